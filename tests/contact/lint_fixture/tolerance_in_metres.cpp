// SPDX-License-Identifier: MIT
bool touches(double overlap) { return overlap > 1e-16; }
