// SPDX-License-Identifier: MIT
#include "prove/world.hpp"

#include <catch2/catch.hpp>
