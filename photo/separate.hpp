// SPDX-License-Identifier: MIT
// Heap against background, with uneven light taken out.
#pragma once

#include "photo/picture.hpp"

#include <cstddef>
#include <vector>

namespace photo {

// What of the colours is looked at: brightness, or, where that does not tell heap and background apart, a difference of colours.
enum class Tone { brightness, red_less_blue, green_less_rest };

// A rectangle of a picture, in its pixels.
struct Box {
    std::size_t x, y, width, height;
};

struct Field {
    std::size_t width, height;
    std::vector<float> v;      // [height][width]: about 0 on the background, about 1 on the heap
    double contrast_to_noise;  // of the two surfaces' distance to the scatter about them
};

// Two smooth surfaces are fitted to the tone, a cubic to the background's and a plane to the heap's, and each pixel is given to
// the nearer one, by turns until nothing changes. Uneven light and the lens' darker corners are so part of the surfaces. The background is where the upper
// border is. First guess: a plane through the upper border, then the threshold of Otsu (1979), IEEE Trans. Syst. Man Cybern. 9, 62,
// doi:10.1109/TSMC.1979.4310076, on the distance from it. Single wild pixels are taken out before by a median over 3 x 3.
// `lighter`: the heap's tone is higher than the background's. The contrast is 0 where there are no two classes.
Field separate(const Picture&, const Box&, Tone, bool lighter);

}  // namespace photo
