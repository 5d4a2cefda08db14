// SPDX-License-Identifier: MIT
// What each rig of a case may have: its conditions and its channels. How a rig runs is the business of rigs/; a new rig
// is a new entry here.
#pragma once

#include "cases/domain.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cases {

// One condition. Exactly one of the forms: a quantity (`unit`), a count, a word, any text, a group; a quantity or count may
// have words beside it ("instant").
struct Condition {
    std::string name;
    std::string unit{};  // SI; empty: no quantity
    Domain domain = Domain::any;
    bool required = false;
    bool count = false;
    std::vector<std::string> words{};
    bool text = false;                 // anything: the name of a file
    std::vector<Condition> members{};  // a group such as the funnel
    bool several = false;              // one of these, or a list of them
    std::size_t in_list = 0;           // a list of exactly so many of these
};

struct ChannelRule {
    std::string name;
    std::vector<std::string> units;    // SI, of which one must fit
    std::vector<std::string> words{};  // a column of words
};

struct RigRule {
    std::string name;
    std::vector<Condition> conditions;
    std::vector<ChannelRule> channels;
    std::vector<std::vector<std::string>>
        recorded;  // a recording holds at least one of these sets of channels
};

const std::vector<RigRule>& rig_rules();
std::vector<std::string> rig_names();
const RigRule& rig_rule(
    const std::string& name);  // throws scaling::InvalidParameter for an unknown name

const ChannelRule* find_channel(const RigRule&,
                                const std::string& name);  // nullptr where there is none
std::vector<std::string> channel_names(const RigRule&);

// Every condition alone, then the rules between them ("funnel or feed_diameter"). Throws InvalidInput.
void check_conditions(const RigRule&, const Value& conditions);

// Whether a grain can touch the plate or a wall of this material.
bool needs_plate(const RigRule&, const Value& conditions);

}  // namespace cases
