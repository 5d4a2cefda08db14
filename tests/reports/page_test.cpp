// SPDX-License-Identifier: MIT
#include "reports/page.hpp"

#include "samples.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace reports;

namespace {

Page whole_page() {
    const Verification v = cone_verification();
    Page page{.title = "zirconia <powder>",
              .source = "a paper",
              .verdict = verdict_of(v),
              .study = zirconia_study("kept_gravity"),
              .beside = zirconia_study("paper"),
              .verification = v,
              .limits = limits_of(v)};
    page.provenance = {.version = "1.2.3",
                       .git = "abc",
                       .compiler = "GNU",
                       .command = "similitude verify case.json",
                       .case_path = "case.json",
                       .seeds = {1, 2, 3},
                       .threads = 2};
    page.data = R"({"text": "</script>"})";
    return page;
}

// The page without style sheet and embedded data, so that words are looked for where a reader sees
// them.
std::string visible(const std::string& text) {
    std::string out = text.substr(text.find("<body>"));
    return out.substr(0, out.find("<script"));
}

}  // namespace

TEST_CASE("page: sections stand in the order of reading, the verdict first", "[reports][page]") {
    const std::string text = html(whole_page());
    std::size_t before = 0;
    for (const char* part :
         {"class=\"verdict yes\"", "id=\"scale\"", "id=\"groups\"", "id=\"adhesion\"",
          "id=\"cost\"", "id=\"runs\"", "id=\"checks\"", "id=\"limits\"", "id=\"repeat\""}) {
        INFO(part);
        const std::size_t at = text.find(part);
        REQUIRE(at != std::string::npos);
        CHECK(at > before);
        before = at;
    }
}

TEST_CASE("page: well-formed, and no text of the case becomes markup", "[reports][page]") {
    const std::string text = html(whole_page());
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "zirconia &lt;powder&gt;") == 2);
    CHECK(times_in(text, "<powder>") == 0);
    CHECK(times_in(text, "</script>") == 1);
}

TEST_CASE("page: no number that is none, no address outside the page, no script that runs",
          "[reports][page]") {
    const std::string text = visible(html(whole_page()));
    for (const char* part : {"nan", ">inf", "-inf", "{{", "}}"}) {
        INFO(part);
        CHECK(times_in(text, part) == 0);
    }
    const std::string all = html(whole_page());
    CHECK(times_in(all, "src=") == 0);
    CHECK(times_in(all, "url(") == 0);
    CHECK(times_in(all, "<script") == times_in(all, "<script type=\"application/json\""));
}

TEST_CASE("page: heaps of both sides lie in one plot with a band each, and three intervals follow",
          "[reports][page]") {
    const std::string text = html(whole_page());
    CHECK(times_in(text, "<svg") == 4);
    CHECK(times_in(text, "fill-opacity=\"0.18\"") == 2);
    CHECK(times_in(text, "r / d") == 1);
}

TEST_CASE("page: a scheme beside the one simulated has its column in both tables",
          "[reports][page]") {
    CHECK(times_in(html(whole_page()), "under paper") == 2);
    Page alone = whole_page();
    alone.beside.reset();
    CHECK(times_in(html(alone), "under paper") == 0);
}

TEST_CASE("page: how to repeat it names command, version, commit and seeds", "[reports][page]") {
    const std::string text = html(whole_page());
    const std::string end = text.substr(text.find("id=\"repeat\""));
    for (const char* part : {"similitude verify case.json", "1.2.3", "abc", "1, 2, 3"}) {
        INFO(part);
        CHECK(times_in(end, part) == 1);
    }
}

TEST_CASE("page: what a result has not is left out, heading and all", "[reports][page]") {
    Page page{.title = "nothing", .verdict = {Answer::yes, "Fine", "there is nothing"}};
    const std::string text = html(page);
    CHECK(fault_in_markup(text) == "");
    for (const char* part : {"id=\"scale\"", "id=\"runs\"", "id=\"checks\"", "id=\"limits\""})
        CHECK(times_in(text, part) == 0);
    CHECK(times_in(text, "id=\"repeat\"") == 1);
}

TEST_CASE("page: several experiments are told one by one, and a jam among them is no success",
          "[reports][page]") {
    const auto section = [](const char* name, Answer answer, const char* headline) {
        return RunSection{name, {answer, headline, "so it was"}, {}, {}, {}, {}};
    };
    const RunSection drained = section("wide", Answer::yes, "The silo drained"),
                     jammed = section("narrow", Answer::no, "The outlet jammed");
    cases::Case c;
    c.title = "silos";
    const Page both = page_of(c, {drained, jammed}, {});
    CHECK(both.verdict.answer == Answer::no);
    CHECK(both.verdict.headline == "1 of 2 experiments ran as meant");
    CHECK(both.verdict.why == "wide: the silo drained; narrow: the outlet jammed");
    CHECK(page_of(c, {drained, drained}, {}).verdict.answer == Answer::yes);
    CHECK(page_of(c, {drained}, {}).verdict.headline == "The silo drained");
}
