// SPDX-License-Identifier: MIT
// Format: The VTK User's Guide, "XML File Formats"; PolyData with appended raw data.
#include "reports/frame.hpp"
#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <bit>
#include <numeric>
#include <utility>

namespace reports {

namespace {

static_assert(sizeof(contact::Vec3) == 3 * sizeof(double), "a vector array is written as it is");

constexpr const char* byte_order =
    std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";

// Arrays are written in two goes: all headings first, then all bytes, each array's behind their
// number (UInt64). The arrays must outlive this.
class Blocks {
  public:
    template <class T>
    std::string add(const std::string& type, const std::string& name, int components,
                    const std::vector<T>& values) {
        const std::uint64_t bytes = values.size() * sizeof(T);
        blocks_.push_back({values.data(), bytes});
        const std::string heading = fmt::format(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
            "offset=\"{}\"/>\n",
            type, name, components, offset_);
        offset_ += sizeof bytes + bytes;
        return heading;
    }
    void write(std::ostream& out) const {
        for (const auto& [data, bytes] : blocks_) {
            out.write(reinterpret_cast<const char*>(&bytes), sizeof bytes);
            out.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
        }
    }

  private:
    std::vector<std::pair<const void*, std::uint64_t>> blocks_;
    std::uint64_t offset_ = 0;  // bytes from the underscore that opens the data
};

}  // namespace

void write_vtp(std::ostream& out, const Frame& f) {
    std::vector<double> diameter;
    for (const double r : f.radius) diameter.push_back(2.0 * r);
    // Not as bytes: VTK takes an array of bytes for colours.
    const std::vector<std::int32_t> fixed(f.fixed.begin(), f.fixed.end());
    std::vector<std::int64_t> grain(f.count()), end(f.count());  // one vertex a grain
    std::iota(grain.begin(), grain.end(), 0);
    std::iota(end.begin(), end.end(), 1);

    Blocks blocks;
    const std::string points = blocks.add("Float64", "position", 3, f.position);
    std::string of_points = blocks.add("Int64", "id", 1, f.id);
    of_points += blocks.add("Float64", "radius", 1, f.radius);
    of_points += blocks.add("Float64", "diameter", 1, diameter);
    of_points += blocks.add("Float64", "velocity", 3, f.velocity);
    of_points += blocks.add("Float64", "spin", 3, f.spin);
    of_points += blocks.add("Int32", "fixed", 1, fixed);
    std::string vertices = blocks.add("Int64", "connectivity", 1, grain);
    vertices += blocks.add("Int64", "offsets", 1, end);

    const std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" "
        "header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n<DataArray type=\"Float64\" "
        "Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>\n</FieldData>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<Points>\n{}</Points>\n<PointData "
        "Scalars=\"diameter\" "
        "Vectors=\"velocity\">\n{}</PointData>\n<Verts>\n{}</Verts>\n</Piece>\n</PolyData>\n"
        "<AppendedData encoding=\"raw\">\n_",
        byte_order, f.time, f.count(), f.count(), points, of_points, vertices);
    out << head;
    blocks.write(out);
    out << "\n</AppendedData>\n</VTKFile>\n";
}

void write_pvd(std::ostream& out, const std::vector<TimedFile>& files) {
    out << fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        "byte_order=\"{}\">\n<Collection>\n",
        byte_order);
    for (const TimedFile& file : files)
        out << fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", file.time,
                           escaped(file.path));
    out << "</Collection>\n</VTKFile>\n";
}

}  // namespace reports
