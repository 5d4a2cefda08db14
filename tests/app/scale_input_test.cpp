// SPDX-License-Identifier: MIT
#include "app/scale_input.hpp"

#include "cases/read_case.hpp"
#include "command_line.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

using app::ScaleOverrides;

TEST_CASE("scale input: the funnel's outlet is the length of the scale number, its height the drop",
          "[app][scale]") {
    const scaling::ScaleInput in =
        app::scale_input(cases::read_case("data/zirconia/case.json"), {});
    CHECK(in.apparatus_length.value() == Approx(6e-3).epsilon(1e-12));
    CHECK(in.grain.drop_height->value() == Approx(65e-3).epsilon(1e-12));
    CHECK(in.base_diameter->value() == Approx(80e-3).epsilon(1e-12));
    CHECK(in.adhesion->of == scaling::Of::scaled);
    CHECK(in.adhesion->work_of_adhesion.value() == Approx(0.38).epsilon(1e-12));  // 2 * 0.19
    CHECK(in.duration->value() ==
          Approx(10.0).epsilon(1e-12));  // apparatus kept: both clocks agree
}

TEST_CASE(
    "scale input: adhesion calibrated at one scale is carried back before another scale is asked "
    "for",
    "[app][scale]") {
    // 0.38 J/m^2 at h = 200 by grain weights is 0.38/200^2 for the real grain, whatever h is tried
    // next.
    ScaleOverrides o;
    o.h = 50.0;
    const scaling::ScaleInput in = app::scale_input(cases::read_case("data/zirconia/case.json"), o);
    CHECK(in.adhesion->of == scaling::Of::original);
    CHECK(in.adhesion->work_of_adhesion.value() == Approx(0.38 / 4e4).epsilon(1e-12));
    CHECK(in.stated.grains.empty());  // what was said of the case's own run says nothing of another
}

TEST_CASE("scale input: a case without funnel piles on its base and drops from five diameters",
          "[app][scale]") {
    const Folder f;
    const cases::Case c = cases::read_case(f.write("case.json", tiny_case()));
    ScaleOverrides o;
    o.h = 2.0;
    o.scheme = "kept_gravity";
    const scaling::ScaleInput in = app::scale_input(c, o);
    CHECK(in.apparatus_length.value() == Approx(10e-3).epsilon(1e-12));
    CHECK(in.grain.drop_height->value() == Approx(5e-3).epsilon(1e-12));
    CHECK(*in.grains == 300.0);
    CHECK_FALSE(in.invariant.has_value());
    CHECK(in.adhesion->of == scaling::Of::original);
}

TEST_CASE("scale input: --keep and --scheme exclude each other, an unknown experiment is refused",
          "[app][scale]") {
    const Folder f;
    const cases::Case c = cases::read_case(f.write("case.json", tiny_case()));
    ScaleOverrides o;
    o.h = 2.0;
    o.scheme = "exact";
    o.keep = {"density"};
    CHECK_THROWS_AS(app::scale_input(c, o), scaling::InvalidInput);
    CHECK_THROWS_WITH(app::experiment_of(c, "pil"), Catch::Contains("did you mean \"pile\"?"));
}
