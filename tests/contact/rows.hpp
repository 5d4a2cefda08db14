// SPDX-License-Identifier: MIT
// All laws of contact/ as functions of numbers that know their dimension, so that one battery tests
// them all.
#pragma once

#include "contact/vec3.hpp"

#include <functional>
#include <string>
#include <vector>

// Exponents of mass, length and time.
struct Dimension {
    int mass, length, time;
};

struct Quantity {
    std::string name;  // unique in its state; components of a vector end in .x .y .z
    Dimension dimension;
    double value;  // SI
};

// What a law is handed. A name that the state does not hold reads as NaN, so a law that uses an
// input which its row does not list cannot pass.
struct State {
    std::vector<Quantity> inputs;
    double operator()(const std::string& name) const;
    contact::Vec3 vector(const std::string& name) const;
};

struct Row {
    std::string law;
    // Same inputs in each; several, so that every branch is visited (sticking, sliding ...).
    std::vector<State> states;
    std::function<std::vector<Quantity>(const State&)> evaluate;
};

std::vector<Row> all_laws();
