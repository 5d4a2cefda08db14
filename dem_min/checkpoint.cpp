// SPDX-License-Identifier: MIT
#include "dem_min/checkpoint.hpp"

#include "scaling/errors.hpp"

#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <type_traits>

namespace dem_min {
namespace {

constexpr std::uint64_t format =
    0x73696d696c2f3035;  // "simil/05": raise the last digit when the layout changes

struct Writer {
    std::ofstream& out;
    template <class T>
    void operator()(T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        out.write(reinterpret_cast<const char*>(&value), sizeof(T));
    }
    template <class T, class Allocator>
    void operator()(std::vector<T, Allocator>& values) {
        std::uint64_t size = values.size();
        (*this)(size);
        out.write(reinterpret_cast<const char*>(values.data()),
                  static_cast<std::streamsize>(size * sizeof(T)));
    }
};

struct Reader {
    std::ifstream& in;
    std::uintmax_t bytes;  // size of the file: no array is longer
    template <class T>
    void operator()(T& value) {
        in.read(reinterpret_cast<char*>(&value), sizeof(T));
    }
    template <class T, class Allocator>
    void operator()(std::vector<T, Allocator>& values) {
        std::uint64_t size = 0;
        (*this)(size);
        if (!in || size > bytes / sizeof(T)) {
            in.setstate(std::ios::failbit);
            return;
        }
        values.resize(size);
        in.read(reinterpret_cast<char*>(values.data()),
                static_cast<std::streamsize>(size * sizeof(T)));
    }
};

// One list of what is saved serves both directions.
template <class Visit>
void visit(Simulation& s, Visit&& each) {
    each(s.steps);
    each(s.births);
    each(s.past);
    for (Wall& wall : s.walls)
        if (Plane* plane = std::get_if<Plane>(&wall))
            each(*plane);
        else if (Shell* shell = std::get_if<Shell>(&wall))
            each(*shell);
    for (Array* array : s.grains.arrays()) each(*array);
    each(s.grains.id);
    each(s.grains.material);
    each(s.grains.body);
    each(s.bodies);
    each(s.members);
    fit_tiles(s);  // none before the first step
    for (Tile& tile : s.tiles) {
        each(tile.ended);
        each(tile.wall_work);
        each(tile.quiet_steps);
        each(tile.asleep);
        for (Contacts& group : tile.groups) {
            each(group.i);
            each(group.j);
            each(group.alike);
            each(group.common);
            for (Array* array : group.arrays()) each(*array);
        }
    }
}

}  // namespace

void write_checkpoint(const Simulation& simulation, const std::filesystem::path& file) {
    std::filesystem::path unfinished = file;
    unfinished += ".tmp";
    {
        std::ofstream out(unfinished, std::ios::binary);
        std::uint64_t mark = format;
        Writer write{out};
        write(mark);
        visit(const_cast<Simulation&>(simulation), write);  // Writer only reads
        write(mark);
        if (!out.flush())
            throw std::runtime_error(unfinished.string() + ": cannot be written (disk full?)");
    }
    std::filesystem::rename(unfinished, file);
}

void read_checkpoint(Simulation& simulation, const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    Simulation read = simulation;
    read.tiles.clear();
    std::uint64_t first = 0, last = 0;
    if (in) {
        Reader reader{in, std::filesystem::file_size(file)};
        reader(first);
        if (first == format) visit(read, reader);
        reader(last);
    }
    if (!in || first != format || last != format)
        throw scaling::InvalidInput(scaling::mistake(file.string(), "no whole checkpoint",
                                                     "must be one of this version",
                                                     "delete it to start the run anew"));
    read.list_is_stale = true;
    simulation = std::move(read);
}

}  // namespace dem_min
