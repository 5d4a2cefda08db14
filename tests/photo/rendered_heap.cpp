// SPDX-License-Identifier: MIT
#include "rendered_heap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace rendered {
namespace {

constexpr double deg = std::numbers::pi / 180.0;

// Height of the smooth outline, u from the apex. A parabola joins the straight flank without a kink at 90 and at 10 %.
double smooth(const Scene& s, double u) {
    const double slope = std::tan((u < 0.0 ? s.left : s.right) * deg), a = std::abs(u),
                 end = 0.1 * s.height / slope;
    if (a < end) return s.height - slope * end / 2.0 - slope * a * a / (2.0 * end);
    const double z = s.height - slope * a;
    if (z > 0.1 * s.height) return z;
    const double run = std::max(0.0, 11.0 * end - a);  // from where the foot ends
    return slope * run * run / (4.0 * end);
}

// The outline with grains on it, on a grid of eighths of a pixel.
struct Outline {
    double first;
    std::vector<double> z;

    double operator()(double u) const {
        const double k = (u - first) * 8.0;
        if (k < 0.0 || k > static_cast<double>(z.size()) - 2.0) return 0.0;
        return z[static_cast<std::size_t>(k + 0.5)];
    }
};

Outline outline(const Scene& s, std::mt19937_64& random) {
    const double left = 1.1 * s.height / std::tan(s.left * deg),
                 right = 1.1 * s.height / std::tan(s.right * deg);
    const double margin = 4.0 + 2.0 * s.grain;
    Outline o{-left - margin, {}};
    o.z.resize(static_cast<std::size_t>(8.0 * (left + right + 2.0 * margin)) + 2);
    for (std::size_t k = 0; k < o.z.size(); ++k)
        o.z[k] = smooth(s, o.first + static_cast<double>(k) / 8.0);
    if (s.grain <= 0.0) return o;
    // Discs along the outline, each moved in or out along the normal by a quarter of a diameter.
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const double radius = 0.5 * s.grain;
    for (double u = -left; u < right;) {
        const double rise = (smooth(s, u + 0.1) - smooth(s, u - 0.1)) / 0.2,
                     length = std::hypot(1.0, rise);
        const double out = 0.25 * s.grain * normal(random);
        const double x = u - out * rise / length, z = smooth(s, u) + out / length;
        const long from = std::lround((x - radius - o.first) * 8.0),
                   to = std::lround((x + radius - o.first) * 8.0);
        for (long k = std::max(0L, from); k <= std::min(to, static_cast<long>(o.z.size()) - 1);
             ++k) {
            const double dx = o.first + static_cast<double>(k) / 8.0 - x,
                         h2 = radius * radius - dx * dx;
            if (h2 > 0.0)
                o.z[static_cast<std::size_t>(k)] =
                    std::max(o.z[static_cast<std::size_t>(k)], z + std::sqrt(h2));
        }
        u += s.grain * (0.6 + 0.5 * uniform(random)) / length;
    }
    return o;
}

// A tone of its own for each cell as large as a grain.
double texture(const Scene& s, double u, double z) {
    if (s.texture == 0.0) return 0.0;
    const double cell = std::max(2.0, s.grain);
    auto h = static_cast<std::uint64_t>(std::lround(u / cell) + 4096) * 0x9e3779b97f4a7c15u;
    h = (h ^ (static_cast<std::uint64_t>(std::lround(z / cell) + 4096) * 0xc2b2ae3d27d4eb4fu) ^
         s.seed) *
        0xd6e8feb86659fd93u;
    h ^= h >> 32;
    return s.texture * std::sqrt(12.0) * (static_cast<double>(h % 65536) / 65536.0 - 0.5);
}

void blur(std::vector<double>& t, std::size_t width, std::size_t height, double sigma) {
    if (sigma <= 0.0) return;
    const long reach = std::lround(std::ceil(3.0 * sigma));
    std::vector<double> kernel;
    double sum = 0.0;
    for (long k = -reach; k <= reach; ++k) {
        kernel.push_back(std::exp(-0.5 * static_cast<double>(k * k) / (sigma * sigma)));
        sum += kernel.back();
    }
    const auto along = [&](std::size_t count, std::size_t lines, std::size_t step,
                           std::size_t next) {
        std::vector<double> line(count);
        for (std::size_t l = 0; l < lines; ++l) {
            for (std::size_t i = 0; i < count; ++i) {
                double v = 0.0;
                for (long k = -reach; k <= reach; ++k) {
                    const long at =
                        std::clamp(static_cast<long>(i) + k, 0L, static_cast<long>(count) - 1);
                    v += kernel[static_cast<std::size_t>(k + reach)] *
                         t[l * next + static_cast<std::size_t>(at) * step];
                }
                line[i] = v / sum;
            }
            for (std::size_t i = 0; i < count; ++i) t[l * next + i * step] = line[i];
        }
    };
    along(width, height, 1, width);
    along(height, width, width, 1);
}

void append(void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                          static_cast<std::size_t>(size));
}

}  // namespace

photo::Picture picture(const Scene& s) {
    std::mt19937_64 random(s.seed);
    const Outline top = outline(s, random);
    const double c = std::cos(s.roll * deg), sn = std::sin(s.roll * deg);
    const double right_foot = 1.1 * s.height / std::tan(s.right * deg);
    const std::size_t width = s.width, height = s.picture_height;
    std::vector<double> t(width * height);
    constexpr int fine = 3;
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i) {
            double sum = 0.0;
            for (int k = 0; k < fine * fine; ++k) {
                const double x = static_cast<double>(i) + (k % fine + 0.5) / fine - 0.5 - s.apex;
                const double y = s.base - (static_cast<double>(j) + (k / fine + 0.5) / fine - 0.5);
                const double u = x * c + y * sn, z = y * c - x * sn;
                double tone = s.background;
                if (z >= 0.0 && z < top(u))
                    tone = s.heap_tone + texture(s, u, z);
                else if (z < 0.0 && s.ground == Ground::table)
                    tone = s.table;
                if (s.shadow > 0.0 && u > 0.0 &&
                    z < top(u) + 0.15 * s.height * (1.0 - (u - right_foot) / (0.5 * s.height)) &&
                    u > 0.85 * right_foot && u < right_foot + 0.5 * s.height &&
                    z > -0.05 * s.height && z < 0.15 * s.height)
                    tone *= 1.0 - s.shadow;
                sum += tone;
            }
            t[j * width + i] = sum / (fine * fine);
        }
    blur(t, width, height, s.blur);

    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    photo::Picture p{width, height, {}, 1};
    p.rgb.resize(3 * width * height);
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i) {
            const double x = static_cast<double>(i) / static_cast<double>(width) - 0.5;
            const double y = static_cast<double>(j) / static_cast<double>(height) - 0.5;
            double v = t[j * width + i] * (1.0 - s.gradient * (x + 0.5)) *
                       (1.0 - s.vignette * 2.0 * (x * x + y * y));
            v += s.noise * normal(random);
            if (uniform(random) < s.salt) v = uniform(random) < 0.5 ? 0.0 : 255.0;
            for (std::size_t k = 0; k < 3; ++k)
                p.rgb[3 * (j * width + i) + k] =
                    static_cast<std::uint8_t>(std::clamp(std::lround(v), 0L, 255L));
        }
    return s.jpeg > 0 ? photo::decode(jpeg(p, s.jpeg), "rendered") : p;
}

std::string png(const photo::Picture& p) {
    std::string out;
    stbi_write_png_to_func(append, &out, static_cast<int>(p.width), static_cast<int>(p.height), 3,
                           p.rgb.data(), static_cast<int>(3 * p.width));
    return out;
}

std::string jpeg(const photo::Picture& p, int quality) {
    std::string out;
    stbi_write_jpg_to_func(append, &out, static_cast<int>(p.width), static_cast<int>(p.height), 3,
                           p.rgb.data(), quality);
    return out;
}

std::string with_orientation(const std::string& file, int orientation, bool big_endian) {
    const auto bytes = [&](unsigned value, int size) {
        std::string text;
        for (int k = 0; k < size; ++k)
            text += static_cast<char>(value >> (8 * (big_endian ? size - 1 - k : k)) & 0xff);
        return text;
    };
    // Header, one directory of two entries (a make first, so that one has to be passed over), no next directory.
    std::string tiff = (big_endian ? "MM" : "II") + bytes(42, 2) + bytes(8, 4) + bytes(2, 2);
    tiff += bytes(271, 2) + bytes(2, 2) + bytes(2, 4) + std::string("X\0\0\0", 4);
    tiff += bytes(274, 2) + bytes(3, 2) + bytes(1, 4) +
            bytes(static_cast<unsigned>(orientation), 2) + bytes(0, 2);
    tiff += bytes(0, 4);
    const std::string body = std::string("Exif\0\0", 6) + tiff;
    const std::size_t length = body.size() + 2;
    std::string segment = "\xff\xe1";
    segment += static_cast<char>(length >> 8), segment += static_cast<char>(length & 0xff);
    return file.substr(0, 2) + segment + body + file.substr(2);
}

}  // namespace rendered
