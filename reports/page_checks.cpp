// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"
#include "reports/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reports {

namespace {

data check_data(const verify::Check& c) {
    data d;
    d["name"] = typeset(c.name);
    d["source"] = optional_text(c.source);
    d["expected"] = typeset(quantity(c.expected, c.unit));
    d["got"] = typeset(quantity(c.got, c.unit));
    d["tolerance"] = typeset(tolerance_text(c));
    d["reason"] = typeset(c.reason);
    d["status"] = c.passed ? "\u2713 passed" : "\u2717 failed";
    d["class"] = c.passed ? "yes" : "no";
    return d;
}

}  // namespace

data checks_part(const std::vector<verify::Check>& checks) {
    std::vector<std::string> groups;
    for (const verify::Check& c : checks)
        if (std::find(groups.begin(), groups.end(), c.group) == groups.end())
            groups.push_back(c.group);
    data list{data::type::list};
    for (const std::string& group : groups) {
        data rows{data::type::list};
        for (const verify::Check& c : checks)
            if (c.group == group) rows << check_data(c);
        data d("name", words(group));
        d["checks"] = std::move(rows);
        list << d;
    }
    return list;
}

data bits_part(const std::vector<verify::BitsCheck>& bits) {
    data rows{data::type::list};
    for (const verify::BitsCheck& b : bits) {
        data d("scheme", words(b.scheme));
        d["h"] = number(b.h);
        d["grains"] = fmt::format("{}", b.grains);
        d["reference"] = fmt::format("{:016x}", b.reference);
        d["scaled"] = fmt::format("{:016x}", b.scaled);
        d["status"] = b.equal ? "\u2713 same bits" : "\u2717 different";
        d["class"] = b.equal ? "yes" : "no";
        rows << d;
    }
    return rows;
}

}  // namespace reports
