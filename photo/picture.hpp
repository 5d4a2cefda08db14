// SPDX-License-Identifier: MIT
// A photograph as it is seen: upright, in colour, small enough to work on. The only file that knows PNG and JPEG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace photo {

// A place in a picture: x to the right, y down, in pixels of the file turned upright; 0, 0 is the centre of the top left one.
struct Pixel {
    double x, y;
};

struct Picture {
    std::size_t width, height;      // of `rgb`
    std::vector<std::uint8_t> rgb;  // [height][width][3], as encoded (not linear in light)
    std::size_t reduced_by =
        1;  // so many pixels of the file, each way, are one of `rgb`: their mean

    // Between a place in the file and one in `rgb`, whose pixels are wider.
    Pixel in_file(Pixel p) const;
    Pixel in_rgb(Pixel p) const;
};

// Reads PNG or JPEG, turns it as its EXIF orientation says (telephones store pictures lying on their side), and reduces it by a whole number
// until its longer side is at most `longest` pixels. Throws scaling::InvalidInput for a file that is missing, is neither of
// the two, is damaged, or has more than 120 million pixels.
Picture read_picture(const std::string& path, std::size_t longest = 1600);

// The same from the bytes of a file; `where` is what messages call it.
Picture decode(const std::string& bytes, const std::string& where, std::size_t longest = 1600);

// The picture as a JPEG file, for a page.
std::string jpeg_of(const Picture&);

}  // namespace photo
