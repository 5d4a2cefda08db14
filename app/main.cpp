// SPDX-License-Identifier: MIT
#include "app/program.hpp"
#include "diagnose/diagnose.hpp"

int main(int argc, char** argv) { return app::program(argc, argv, diagnose::diagnose); }
