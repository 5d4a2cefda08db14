// SPDX-License-Identifier: MIT
// Workbooks as pandas and LibreOffice see them. A program that is missing fails the test.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <map>
#include <sstream>

using Catch::Matchers::Contains;

namespace {

using Row = std::vector<std::string>;

std::vector<Row> rows_of(const std::string& text, char mark) {
    std::istringstream in(text);
    std::vector<Row> rows;
    for (std::string line; std::getline(in, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, mark);) rows.back().push_back(cell);
    }
    return rows;
}

std::vector<Row> as_pandas_reads(const std::string& file, const std::string& sheet) {
    if (std::system("/usr/bin/python3 -c 'import pandas, openpyxl' > /dev/null 2>&1") != 0)
        FAIL("this test opens workbooks: install python3-pandas and python3-openpyxl");
    return rows_of(output_of("/usr/bin/python3 tests/app/read_workbook.py " + file + " " + sheet),
                   '|');
}

const Row& row_with(const std::vector<Row>& rows, const std::string& first, std::size_t at = 0) {
    for (const Row& row : rows)
        if (row.size() > at && row[at] == first) return row;
    FAIL("no row " << first);
    std::abort();
}

}  // namespace

// The paper's factors (Table 2 and its text): length 200, gravity 1; w of the scaled grain 2 x 0.19 J/m^2.
TEST_CASE("workbook: pandas reads the tables of scale as numbers with units beside them",
          "[app][formats]") {
    const Folder folder;
    const Outcome o =
        similitude({"scale", "data/zirconia", "--xlsx", folder / "s.xlsx", "--json", "-"});
    INFO(o.err);
    const auto factors = as_pandas_reads(folder / "s.xlsx", "factors");
    CHECK(factors[0][0] == "quantity");
    CHECK(std::stod(row_with(factors, "length")[2]) == 200.0);
    CHECK(std::stod(row_with(factors, "gravity")[2]) == 1.0);
    const auto adhesion = as_pandas_reads(folder / "s.xlsx", "adhesion");
    const Row& w = row_with(adhesion, "work_of_adhesion");
    CHECK(w[1] == "J/m^2");
    CHECK(std::stod(w[3]) == Approx(0.38).epsilon(1e-12));
    const auto groups = as_pandas_reads(folder / "s.xlsx", "groups");
    CHECK(row_with(groups, "weight_bond")[5] == "kept");
    CHECK(groups.size() == 1 + o.json()["groups"].size());
}

TEST_CASE("workbook: LibreOffice opens the table of convert", "[app][formats]") {
    if (std::system("command -v soffice > /dev/null 2>&1") != 0)
        FAIL("this test opens workbooks: install the Debian package libreoffice-calc-nogui");
    const Folder folder;
    REQUIRE(similitude({"convert", "adhesion", "--from", "surface_energy", "--value", "0.19 J/m^2",
                        "--diameter", "240 um", "--xlsx", folder / "c.xlsx", "--quiet"})
                .code == 0);
    output_of("HOME=" + folder / "" + " soffice --headless --convert-to csv --outdir " +
              folder / "" + " " + folder / "c.xlsx");
    const std::string csv = contents(folder / "c.csv");
    CHECK_THAT(csv, Contains("role,convention,engine,parameter,value,unit"));
    // 3 pi gamma R* by hand: the deepest tension of LAMMPS' jkr at R* = 60 um
    CHECK_THAT(csv,
               Contains("from,surface_energy,") && Contains(",0.19,J/m^2,0.00010744246875277"));
}

// z = h - g t^2/2 at the recording's rows, all before the plate. A sheet is called runs: the experiment of that name gets another.
TEST_CASE("workbook: pandas and LibreOffice read the runs and channels of simulate",
          "[app][formats][simulate]") {
    if (std::system("command -v soffice > /dev/null 2>&1") != 0)
        FAIL("this test opens workbooks: install the Debian package libreoffice-calc-nogui");
    const Folder folder;
    folder.write("fall.csv", "t [s],z [m]\n0,0.05\n0.02,0.0481\n0.04,0.0422\n");
    const std::string path =
        folder.write("case.json", R"({"format": "similitude-case/1", "title": "t",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "5 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "8 MPa", "poisson_ratio": 0.25}, "surroundings": {"gravity": "10 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin"], "parameters": {"restitution": {"value": 0.7},
      "sliding_friction": {"value": 0.3}}},
  "experiments": [
    {"id": "runs", "rig": "drop", "conditions": {"height": "50 mm"}, "recording": "fall.csv"},
    {"id": "an-impact-with-a-name-much-too-long-for-Excel", "rig": "impact", "conditions": {"speed": "1.5 m/s"}}]})");
    const std::string book = folder / "r.xlsx";
    const Outcome o = similitude({"simulate", path, "--out", folder / "out", "--xlsx", book});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const auto runs = as_pandas_reads(book, "runs");
    CHECK(runs[0] == Row{"experiment", "rig", "quantity", "value", "unit"});
    CHECK(row_with(runs, "wall_time", 2)[4] == "s");
    CHECK(std::stod(row_with(runs, "rows", 2)[3]) == 44.0);  // of the impact, without a recording
    const auto fall = as_pandas_reads(book, "runs~2");
    CHECK(fall[0] == Row{"t [s]", "z [m]", "x [m]"});
    REQUIRE(fall.size() == 4);
    for (std::size_t k = 1; k < fall.size(); ++k) {
        const double t = std::stod(fall[k][0]);
        CHECK(std::stod(fall[k][1]) == Approx(0.05 - 5.0 * t * t).margin(1e-9));
    }
    CHECK(as_pandas_reads(book, "an-impact-with-a-name-much-too-").size() == 1 + 44);
    output_of("HOME=" + folder / "" + " soffice --headless --convert-to csv --outdir " +
              folder / "" + " " + book);  // the first sheet
    CHECK_THAT(contents(folder / "r.csv"),
               Contains("experiment,rig,quantity,value,unit") && Contains("runs,drop,wall_time,"));
}

// Shear modulus and coefficients as in the paper's Table 3; radius 200 x 0.6 um; gamma = w/2 by the equations of EDEM's page, w by its
// text; EDEM's Standard multiplies the rolling coefficient by R, the case by R*: half between grains, the same at the wall.
TEST_CASE("workbook: EDEM's sheet for the scaled zirconia grain, in the order of its dialogs",
          "[app][formats][edem]") {
    const Folder folder;
    const std::string file = folder / "edem.xlsx";
    REQUIRE(similitude({"convert", "edem", "data/zirconia", "--of", "scaled", "--jkr",
                        "edem_v1_equations", "--out", file, "--quiet"})
                .code == 0);
    const auto rows = as_pandas_reads(file, "EDEM");
    REQUIRE(rows.size() > 10);
    const std::vector<std::string> order{"field",
                                         "Poisson's Ratio",
                                         "Shear Modulus",
                                         "Young's Modulus",
                                         "Solids Density",
                                         "Work Function",
                                         "Coefficient of Restitution",
                                         "Coefficient of Static Friction",
                                         "Coefficient of Rolling Friction"};
    for (std::size_t k = 0; k < order.size(); ++k) CHECK(rows[k][1] == order[k]);
    const auto value = [&](std::size_t k) { return std::stod(rows[k][2]); };
    CHECK(value(1) == 0.3);
    CHECK(value(2) == Approx(60e6).epsilon(1e-12));
    CHECK(rows[2][3] == "Pa");
    CHECK(value(4) == 5600.0);
    CHECK(value(6) == 0.225);
    CHECK(value(7) == 0.8);
    CHECK(value(8) == Approx(0.1125).epsilon(1e-12));
    CHECK(value(9) == 0.15);  // grains and plate
    CHECK(value(11) == Approx(0.075).epsilon(1e-12));
    CHECK(std::stod(row_with(rows, "Physical Radius", 1)[2]) == Approx(120e-6).epsilon(1e-12));
    CHECK(std::stod(row_with(rows, "Surface Energy", 1)[2]) == Approx(0.19).epsilon(1e-9));
    CHECK(std::stod(row_with(rows, "(check) pull-off force of one contact", 1)[2]) ==
          Approx(1.5 * 3.14159265358979 * 0.38 * 60e-6).epsilon(1e-9));
}

TEST_CASE("workbook: EDEM's surface energy is never written without saying what it means",
          "[app][formats][edem]") {
    const Folder folder;
    const auto sheet = [&](const std::string& jkr, int code) {
        const Outcome o = similitude({"convert", "edem", "data/zirconia", "--of", "scaled", "--jkr",
                                      jkr, "--out", folder / "e.csv", "--quiet"});
        CHECK(o.code == code);
        return contents(folder / "e.csv");
    };
    CHECK_THAT(sheet("edem_v1_text", 0), Contains("Surface Energy,0.38,J/m^2"));
    CHECK_THAT(sheet("edem_v2", 5), Contains("Surface Energy,,J/m^2,not published"));
    const Outcome none = similitude({"convert", "edem", "data/zirconia", "--of", "scaled"});
    CHECK(none.code == 2);
    CHECK_THAT(none.err, Contains("--jkr") && Contains("factor 2"));
    const Outcome which = similitude({"convert", "edem", "data/zirconia"});
    CHECK(which.code == 2);
    CHECK_THAT(which.err, Contains("--of"));
}
