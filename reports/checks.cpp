// SPDX-License-Identifier: MIT
#include "reports/checks.hpp"

#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

// Each thing that is not as it must be, in a sentence.
std::vector<std::string> failures(const Verification& v) {
    std::vector<std::string> all;
    for (const verify::Check& c : v.checks)
        if (!c.passed)
            all.push_back(fmt::format("{}: expected {}, got {}, tolerance {}", c.name,
                                      number(c.expected), number(c.got), tolerance_text(c)));
    if (!v.similarity) return all;
    for (const verify::BitsCheck& b : v.similarity->bits)
        if (!b.equal)
            all.push_back(fmt::format(
                "scheme {}, h = {}: the scaled pile is not the reference pile to the last bit",
                b.scheme, number(b.h)));
    for (const verify::Comparison& c : v.similarity->comparisons)
        if (c.must_differ && c.answer == verify::Answer::equivalent)
            all.push_back(
                fmt::format("{}: made wrong on purpose, yet it passes as equivalent", c.name));
    return all;
}

std::string what_passed(const Verification& v) {
    std::string text =
        v.checks.empty() ? "" : fmt::format("{} exact answers are met", v.checks.size());
    if (!v.similarity) return text;
    for (const verify::BitsCheck& b : v.similarity->bits)
        text += fmt::format("{}{} with h = {} gives the same bits after rescaling",
                            text.empty() ? "" : "; ", words(b.scheme), number(b.h));
    return text;
}

// What is said of the comparison that counts; `claimed` is false where the seeds are too few.
std::string comparison_sentence(const verify::Comparison& c) {
    const std::string seeds = fmt::format("{} seeds a side", c.reference.samples.size());
    if (!c.claims && c.answer != verify::Answer::different)
        return fmt::format("{}: intervals from {} are shown, equivalence is not claimed",
                           words(c.name), seeds);
    return fmt::format("{}: {} ({})", words(c.name), verify::to_string(c.answer), seeds);
}

// What may be said where nothing failed: equivalence only where it was shown with enough seeds.
const char* headline_of(const Verification& v, const verify::Comparison* main) {
    const bool claimed = main != nullptr && main->claims;
    if (v.sleep) return "Heaps that may sleep match heaps that stay awake";
    if (claimed) return "The scaled pile matches the reference pile";
    const bool bits = v.similarity && !v.similarity->bits.empty();
    return bits ? "The scaled pile is the reference pile to the last bit" : "All checks passed";
}

// One line per group, and every check that failed; the long list is for JSON and page.
std::string checks_text(const Verification& v) {
    std::vector<std::string> groups;
    for (const verify::Check& c : v.checks)
        if (std::find(groups.begin(), groups.end(), c.group) == groups.end())
            groups.push_back(c.group);
    TextTable rows = {{"exact answers", "checked", "passed"}},
              failed = {{"failed", "expected", "got", "tolerance"}};
    for (const std::string& group : groups) {
        const auto of_group = [&](const verify::Check& c) { return c.group == group; };
        const auto all = std::count_if(v.checks.begin(), v.checks.end(), of_group);
        const auto passed =
            std::count_if(v.checks.begin(), v.checks.end(),
                          [&](const verify::Check& c) { return of_group(c) && c.passed; });
        rows.push_back({words(group), fmt::format("{}", all), fmt::format("{}", passed)});
    }
    for (const verify::Check& c : v.checks)
        if (!c.passed)
            failed.push_back({c.name, number(c.expected), number(c.got), tolerance_text(c)});
    std::string text = groups.empty() ? "" : columns(rows, {false, true, true}) + "\n";
    if (failed.size() > 1) text += columns(failed, {false, true, true, false}) + "\n";
    return text;
}

}  // namespace

std::string tolerance_text(const verify::Check& c) {
    if (c.tolerance == 0.0) return "none";
    return c.relative ? number(c.tolerance) + " of it" : quantity(c.tolerance, c.unit);
}

TextTable bits_table(const Verification& v) {
    if (!v.similarity || v.similarity->bits.empty()) return {};
    TextTable rows = {{"same bits after rescaling", "h", "grains", "reference", "scaled", ""}};
    for (const verify::BitsCheck& b : v.similarity->bits)
        rows.push_back({b.scheme, number(b.h), fmt::format("{}", b.grains), hash_text(b.reference),
                        hash_text(b.scaled), b.equal ? "same" : "DIFFERENT"});
    return rows;
}

std::vector<const verify::Comparison*> comparisons_of(const Verification& v) {
    std::vector<const verify::Comparison*> all;
    if (v.sleep) all.push_back(&v.sleep->comparison);
    if (v.similarity)
        for (const verify::Comparison& c : v.similarity->comparisons) all.push_back(&c);
    return all;
}

std::string saved_text(const verify::SleepStudy& s) {
    return fmt::format(
        "Sleep left out {} % of the grain-steps of a heap of {} grains on average, {} % of those "
        "while it was being fed.",
        number(100.0 * s.saved.whole), count(s.grains), number(100.0 * s.saved.while_fed));
}

std::string heaps_by(const verify::SimilarityResult& r) {
    return (r.engine.empty() ? "dem_min" : r.engine) +
           (r.heap.lammps_rules ? "; contact rules that LAMMPS has" : "; our own contact rules");
}

Verdict verdict_of(const Verification& v) {
    const std::vector<std::string> failed = failures(v);
    const std::vector<const verify::Comparison*> all = comparisons_of(v);
    const verify::Comparison* main = all.empty() ? nullptr : all.front();
    if (!failed.empty())
        return {Answer::no,
                fmt::format("{} check{} failed", failed.size(), failed.size() == 1 ? "" : "s"),
                failed.front()};
    const std::string also = main != nullptr ? comparison_sentence(*main) : "";
    if (main != nullptr && main->answer == verify::Answer::different)
        return {Answer::no,
                v.sleep ? "Heaps that may sleep are not those that stay awake"
                        : "The scaled pile is not the reference pile",
                also};
    if (main != nullptr && main->claims && main->answer == verify::Answer::not_decided)
        return {Answer::cannot_tell, "The seeds do not decide whether the piles are alike", also};
    if (v.sleep && !v.sleep->comparison.claims)
        return {Answer::cannot_tell, "Too few seeds to say whether sleep changes the heap", also};
    const std::string passed = what_passed(v);
    return {Answer::yes, headline_of(v, main),
            passed + (passed.empty() || also.empty() ? "" : ". ") + also};
}

std::string text_of(const Verification& v) {
    const Verdict verdict = verdict_of(v);
    std::string text =
        fmt::format("{}\n{}\n\n", verdict.headline, wrapped(verdict.why, 100, 0)) + checks_text(v);
    const TextTable bits = bits_table(v);
    if (!bits.empty()) text += columns(bits, {false, true, true, false, false, false}) + "\n";
    if (v.similarity) text += fmt::format("heaps by {}\n\n", heaps_by(*v.similarity));
    if (v.sleep) text += wrapped(saved_text(*v.sleep), 100, 0) + "\n\n";
    for (const verify::Comparison* c : comparisons_of(v)) {
        const RunSection section = comparison_section(*c);
        text += fmt::format("{}: {}\n", section.name, section.verdict.headline);
        for (const std::string& note : section.notes) text += "  " + note + "\n";
        text += columns(section.quantities,
                        std::vector<bool>{false, true, true, true, true, true, false}) +
                "\n";
    }
    return text;
}

}  // namespace reports
