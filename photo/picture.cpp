// SPDX-License-Identifier: MIT
#include "photo/picture.hpp"

#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace photo {
namespace {

using scaling::InvalidInput;
using scaling::mistake;

constexpr std::size_t most_pixels = 120'000'000;

// Unsigned numbers in a TIFF block, in the byte order that it names; nothing beyond its end.
struct Tiff {
    std::string bytes;
    bool big_endian;

    std::optional<unsigned> number(std::size_t at, std::size_t size) const {
        if (at > bytes.size() || size > bytes.size() - at) return std::nullopt;
        unsigned n = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const std::size_t from = big_endian ? at + k : at + size - 1 - k;
            n = n << 8 | static_cast<unsigned char>(bytes[from]);
        }
        return n;
    }
};

// Tag 274 (orientation) of the first directory; 1, upright, where there is none. TIFF 6.0, section 2; EXIF 2.3, 4.6.4.
unsigned orientation_in(const Tiff& tiff) {
    const auto directory = tiff.number(4, 4);
    if (!directory) return 1;
    const auto entries = tiff.number(*directory, 2);
    for (std::size_t k = 0; entries && k < *entries; ++k) {
        const std::size_t entry = *directory + 2 + 12 * k;
        const auto tag = tiff.number(entry, 2);
        if (!tag) break;
        if (*tag == 274) {
            const unsigned value = tiff.number(entry + 8, 2).value_or(1);
            return value >= 1 && value <= 8 ? value : 1;
        }
    }
    return 1;
}

// Of a JPEG file: walks its segments up to the picture itself and looks for APP1 with "Exif". 1 for a PNG.
unsigned orientation_of(const std::string& file) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(file[at]); };
    if (file.size() < 4 || byte(0) != 0xff || byte(1) != 0xd8) return 1;
    std::size_t at = 2;
    while (at + 4 <= file.size() && byte(at) == 0xff && byte(at + 1) != 0xda) {
        const std::size_t length = std::size_t{byte(at + 2)} << 8 | byte(at + 3);
        if (byte(at + 1) == 0xe1 && file.compare(at + 4, 6, std::string("Exif\0\0", 6)) == 0 &&
            length >= 16)
            return orientation_in({file.substr(at + 10, length - 8), file[at + 10] == 'M'});
        at += 2 + length;
    }
    return 1;
}

// The place in the stored picture of the upright one's pixel (x, y). EXIF: 2 mirrored, 3 upside down, 4 both; 5 to 8 the same lying on
// their side.
Picture turned(Picture stored, unsigned orientation) {
    if (orientation == 1) return stored;
    const bool lying = orientation >= 5;
    Picture up{lying ? stored.height : stored.width, lying ? stored.width : stored.height, {}};
    up.rgb.resize(stored.rgb.size());
    const bool from_right =
        orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_below =
        orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    for (std::size_t y = 0; y < up.height; ++y)
        for (std::size_t x = 0; x < up.width; ++x) {
            std::size_t column = lying ? y : x, row = lying ? x : y;
            if (from_right) column = stored.width - 1 - column;
            if (from_below) row = stored.height - 1 - row;
            std::copy_n(&stored.rgb[3 * (row * stored.width + column)], 3,
                        &up.rgb[3 * (y * up.width + x)]);
        }
    return up;
}

// Means of squares of n x n bytes; columns and rows that are left over at right and bottom are dropped.
Picture reduced(const Picture& whole, std::size_t n) {
    Picture small{whole.width / n, whole.height / n, {}, n};
    small.rgb.resize(3 * small.width * small.height);
    for (std::size_t y = 0; y < small.height; ++y)
        for (std::size_t x = 0; x < small.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                std::size_t sum = 0;
                for (std::size_t j = 0; j < n; ++j)
                    for (std::size_t i = 0; i < n; ++i)
                        sum += whole.rgb[3 * ((y * n + j) * whole.width + x * n + i) + c];
                small.rgb[3 * (y * small.width + x) + c] =
                    static_cast<std::uint8_t>((sum + n * n / 2) / (n * n));
            }
    return small;
}

}  // namespace

Pixel Picture::in_file(Pixel p) const {
    const double n = static_cast<double>(reduced_by), half = 0.5 * (n - 1.0);
    return {n * p.x + half, n * p.y + half};
}

Pixel Picture::in_rgb(Pixel p) const {
    const double n = static_cast<double>(reduced_by), half = 0.5 * (n - 1.0);
    return {(p.x - half) / n, (p.y - half) / n};
}

Picture decode(const std::string& bytes, const std::string& where, std::size_t longest) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(data, size, &width, &height, &channels))
        throw InvalidInput(mistake(where, "a file that is no picture", "must be PNG or JPEG",
                                   "export HEIC, WebP or raw pictures as JPEG"));
    const std::size_t w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    if (w * h > most_pixels)
        throw InvalidInput(mistake(where, fmt::format("{} x {} pixels", w, h),
                                   "must have at most 120 million", "save it smaller"));
    const std::unique_ptr<stbi_uc, void (*)(void*)> rgb(
        stbi_load_from_memory(data, size, &width, &height, &channels, 3), stbi_image_free);
    if (!rgb)
        throw InvalidInput(mistake(where, fmt::format("damaged ({})", stbi_failure_reason()),
                                   "must be a whole PNG or JPEG file", "copy it again"));
    const std::size_t n = std::max<std::size_t>(1, (std::max(w, h) + longest - 1) / longest);
    if (w < n || h < n)
        throw InvalidInput(mistake(where, fmt::format("{} x {} pixels", w, h), "must show a heap",
                                   "save it larger"));
    return reduced(turned({w, h, {rgb.get(), rgb.get() + 3 * w * h}}, orientation_of(bytes)), n);
}

Picture read_picture(const std::string& path, std::size_t longest) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (!file || bytes.empty())
        throw InvalidInput(mistake(path, "a file that cannot be read or is empty",
                                   "must be a PNG or JPEG", "check the name"));
    return decode(bytes, path, longest);
}

std::string jpeg_of(const Picture& picture) {
    std::string out;
    const auto append = [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
    };
    stbi_write_jpg_to_func(append, &out, static_cast<int>(picture.width),
                           static_cast<int>(picture.height), 3, picture.rgb.data(), 85);
    return out;
}

}  // namespace photo
