// SPDX-License-Identifier: MIT
#include "cases/units.hpp"

#include "scaling/errors.hpp"
#include "temporary_case.hpp"

#include <catch2/catch.hpp>

#include <numbers>
#include <string>
#include <thread>
#include <vector>

using cases::parse_unit;
using cases::to_si;

namespace {

constexpr double pi = std::numbers::pi;

struct Good {
    std::string text, si_unit;
    double si;
};

double read(const std::string& text, const std::string& si_unit) {
    return to_si(text, parse_unit(si_unit, ""), "here");
}

std::string mistake_in(const std::string& text, const std::string& si_unit) {
    return message_of<scaling::InvalidInput>([&] { read(text, si_unit); });
}

}  // namespace

// Values from the definitions of the units (SI brochure; dyn = 1e-5 N, P = 0.1 Pa s, lb = 0.45359237 kg, psi = lbf/in^2).
TEST_CASE("a unit means the same in every spelling", "[cases][units]") {
    const Good good = GENERATE(values<Good>({
        {"0.19 J/m^2", "J/m^2", 0.19},
        {"0.19 J·m⁻²", "J/m^2", 0.19},
        {"0.19 J m-2", "J/m^2", 0.19},
        {"0.19J/m2", "J/m^2", 0.19},
        {"0.19 N/m", "J/m^2", 0.19},
        {"190 mJ.m-2", "J/m^2", 0.19},
        {"190 mJ/m**2", "J/m^2", 0.19},
        {"190 mJ/m²", "J/m^2", 0.19},
        {"190 erg/cm^2", "J/m^2", 0.19},
        {"72 dyn/cm", "N/m", 0.072},
        {"2 N/mm", "N/m", 2000.0},
        {"1.2 um", "m", 1.2e-6},
        {"1.2 \u00B5m", "m", 1.2e-6},
        {"1.2 \u03BCm", "m", 1.2e-6},
        {"1.2\u00A0µm", "m", 1.2e-6},
        {"1.2 micrometer", "m", 1.2e-6},
        {"1.2 microns", "m", 1.2e-6},
        {"3 [mm]", "m", 3e-3},
        {"\u22123 mm", "m", -3e-3},
        {"+3 mm", "m", 3e-3},
        {"12 Å", "m", 1.2e-9},
        {"1 in", "m", 0.0254},
        {"2050 kg m⁻³", "kg/m^3", 2050.0},
        {"2.05 g/cm3", "kg/m^3", 2050.0},
        {"2.05 g/cc", "kg/m^3", 2050.0},
        {"2.05 kg/(dm^3)", "kg/m^3", 2050.0},
        {"60 MPa", "Pa", 6e7},
        {"1e6 GPa", "Pa", 1e15},
        {"1 bar", "Pa", 1e5},
        {"1 psi", "Pa", 0.45359237 * 9.80665 / (0.0254 * 0.0254)},
        {"9.81 m/s^2", "m/s^2", 9.81},
        {"9.81 m/s/s", "m/s^2", 9.81},
        {"1 cP", "Pa*s", 1e-3},
        {"18.1 uPa s", "Pa*s", 18.1e-6},
        {"1.81e-5 kg/(m s)", "Pa*s", 1.81e-5},
        {"7.78 × 10⁻⁷ s", "s", 7.78e-7},
        {"7.78x10^-7 s", "s", 7.78e-7},
        {"6 h", "s", 21600.0},
        {"5 deg", "rad", 5.0 * pi / 180.0},
        {"5°", "rad", 5.0 * pi / 180.0},
        {"60 rpm", "rad/s", 2.0 * pi},
        {"1 rev/s", "rad/s", 2.0 * pi},
        {"3 1/s", "rad/s", 3.0},
        {"50 Hz", "Hz", 50.0},
        {"886 1/s", "1/s", 886.0},
        {"886 grains/s", "1/s", 886.0},
        {"60 per min", "1/s", 1.0},
        {"60 /min", "1/s", 1.0},
        {"30 %", "1", 0.3},
        {"0.3", "1", 0.3},
        {"10 pC", "C", 1e-11},
        {"0.1 (s/m)^(1/5)", "(s/m)^(1/5)", 0.1},
        {"0.1 s^0.2 m^-0.2", "(s/m)^(1/5)", 0.1},
        // 1000^(1/5)
        {"0.1 (s/mm)^(1/5)", "(s/m)^(1/5)", 0.1 * 3.9810717055349722},
    }));
    CAPTURE(good.text);
    // 1e-15: a few roundings of the factors.
    CHECK(read(good.text, good.si_unit) == Approx(good.si).epsilon(1e-15));
}

TEST_CASE("a decimal prefix gives the double nearest to the decimal number", "[cases][units]") {
    CHECK(read("1.2 um", "m") == 1.2e-6);
    CHECK(read("0.272 um", "m") == 0.272e-6);
    CHECK(read("5.6 g/cm^3", "kg/m^3") == 5600.0);
    CHECK(read("0.6 mm", "m") == 0.6e-3);
}

TEST_CASE("a typed quantity takes its dimension from its type", "[cases][units]") {
    CHECK(cases::quantity<scaling::EnergyPerArea>("190 mJ/m^2", "here").value() ==
          Approx(0.19).epsilon(1e-15));
    CHECK(cases::quantity<scaling::Dimensionless>("180 deg", "here").value() ==
          Approx(pi).epsilon(1e-15));
    CHECK_THROWS_AS(cases::quantity<scaling::Length>("1 s", "here"), scaling::InvalidInput);
}

TEST_CASE("a wrong unit is refused with what was given, what is expected and a hint",
          "[cases][units]") {
    struct Bad {
        std::string text, si_unit, message;
    };
    const Bad bad = GENERATE(values<Bad>({
        {"0.19 J/m^3", "J/m^2",
         "here: got \"0.19 J/m^3\" [M L^-1 T^-2], must be an energy per area [M T^-2] (did you "
         "mean \"0.19 J/m^2\"?)"},
        {"5600 kg/m", "kg/m^3",
         "here: got \"5600 kg/m\" [M L^-1], must be a density [M L^-3] (did you mean \"5600 "
         "kg/m^3\"?)"},
        {"9.81 m/s", "m/s^2",
         "here: got \"9.81 m/s\" [L T^-1], must be an acceleration [L T^-2] (did you mean \"9.81 "
         "m/s^2\"?)"},
        {"3 mm", "s", "here: got \"3 mm\" [L], must be a time [T] (write it in s)"},
        {"3 C", "N", "here: got \"3 C\" [T I], must be a force [M L T^-2] (write it in N)"},
        {"0.19", "J/m^2",
         "here: got 0.19, must be an energy per area with its unit (write \"0.19 J/m^2\")"},
        {"5", "rad", "here: got \"5\", must be an angle with its unit (write \"5 deg\")"},
        {"60 MPA", "Pa",
         "here: got \"60 MPA\", must be a known unit in place of \"MPA\" (did you mean \"60 "
         "MPa\"?)"},
        {"0.2 J/M^2", "J/m^2",
         "here: got \"0.2 J/M^2\", must be a known unit in place of \"M\" (did you mean \"0.2 "
         "J/m^2\"?)"},
        {"1 Pas", "Pa*s",
         "here: got \"1 Pas\", must be a known unit in place of \"Pas\" (did you mean \"1 "
         "Pa*s\"?)"},
        {"20 K", "m",
         "here: got \"20 K\", must be a known unit in place of \"K\" (did you mean \"20 m\"?)"},
        {"1 Hz", "rad/s",
         "here: got \"1 Hz\", must be a spin: Hz counts turns, not radians (write \"60 rpm\" or "
         "use rad/s)"},
        {"3000 rpm", "Hz",
         "here: got \"3000 rpm\", must be a frequency, and radians or turns are none (write it in "
         "Hz)"},
        {"30 deg", "1",
         "here: got \"30 deg\", must be a dimensionless number, and radians or turns are none "
         "(write it in per cent or as a bare "
         "number)"},
        {"1,2 um", "m",
         "here: got \"1,2 um\", must have a decimal point and no thousands separator (write 1.2 "
         "for one and a fifth, 1200 for "
         "twelve hundred)"},
        {"big", "m",
         "here: got \"big\", must begin with a finite number (write a number and its unit, such as "
         "\"1.2 um\")"},
        {"nan m", "m",
         "here: got \"nan m\", must begin with a finite number (write a number and its unit, such "
         "as \"1.2 um\")"},
        {"1e999 m", "m",
         "here: got \"1e999 m\", must begin with a finite number (write a number and its unit, "
         "such as \"1.2 um\")"},
    }));
    CAPTURE(bad.text);
    CHECK(mistake_in(bad.text, bad.si_unit) == bad.message);
}

TEST_CASE("what is no unit is an error and nothing worse", "[cases][units]") {
    const std::string text =
        GENERATE("", "[m]", "1 m^", "1 m)", "1 (m", "1 m^0/0", "1 m^(1/0)", "1 /", "1 m//s", "1 *m",
                 "1 m^999", "1 ((((m", "1 \xFF", "1 m\n", "1 m$", "- m", "1 e5 m", "1 0 m");
    CAPTURE(text);
    if (text == "1 m\n") {
        CHECK(read(text, "m") == 1.0);
    } else {
        CHECK_THROWS_AS(read(text, "m"), scaling::InvalidInput);
    }
}

TEST_CASE("a value is written for people with the prefix that they would use", "[cases][units]") {
    struct Shown {
        double si;
        std::string unit, text;
    };
    const Shown shown = GENERATE(values<Shown>({{1.2e-6, "m", "1.2 um"},
                                                {0.272e-6, "m", "272 nm"},
                                                {0.6, "m", "0.6 m"},
                                                {-3e-3, "m", "-3 mm"},
                                                {0.0, "m", "0 m"},
                                                {0.999999999e-3, "m", "1 mm"},
                                                {0.19, "J/m^2", "0.19 J/m^2"},
                                                {4.75e-6, "J/m^2", "4.75 uJ/m^2"},
                                                {6e7, "Pa", "60 MPa"},
                                                {7.78e-7, "s", "778 ns"},
                                                {5600.0, "kg/m^3", "5600 kg/m^3"},
                                                {5.07e-15, "kg", "5.07 pg"},
                                                {3.0, "kg", "3 kg"},
                                                {2e-9, "m^2", "2e-09 m^2"},
                                                {pi / 4.0, "rad", "45 deg"},
                                                {0.3, "1", "0.3"}}));
    CHECK(cases::format_si(shown.si, shown.unit) == shown.text);
    // Six digits are printed.
    CHECK(read(shown.text, shown.unit) == Approx(shown.si).epsilon(1e-6));
}

TEST_CASE("units are read alike from several threads", "[cases][units]") {
    std::vector<double> sums(4, 0.0);
    std::vector<std::thread> threads;
    for (double& sum : sums) {
        threads.emplace_back([&sum] {
            for (int i = 0; i < 500; ++i) sum += read("2 mJ/m^2", "J/m^2") + read("1 deg", "rad");
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const double sum : sums) CHECK(sum == Approx(500.0 * (2e-3 + pi / 180.0)).epsilon(1e-12));
}
