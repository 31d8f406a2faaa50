// Reads a mesh from Triangle's files .node and .ele, and from the .poly, .edge and .neigh of the same name.
#include <atomic>
#include <string>
#include <utility>
#include <vector>

#include "../neighbours.hpp"
#include "mesh_readers.hpp"
#include "middles.hpp"
#include "triangle_sections.hpp"

namespace pardel::files {
namespace {

namespace fs = std::filesystem;

struct ReadMesh {
  Mesh mesh;
  int base = 1;
  std::vector<char> is_middle;  ///< per node: 1 for the middle of an edge; empty if a triangle has three nodes
};

/// Format: `<# of triangles> <nodes per triangle, 3 or 6> <# of attributes>`, then `<triangle #> <nodes> [attributes]`.
/// The first three nodes are the corners; the others are the middles of the edges opposite them. The first attribute is
/// the attribute of the region.
void read_elements(TextReader& in, ReadMesh& read) {
  Mesh& mesh = read.mesh;
  in.expect_line("the number of triangles");
  const std::size_t n = in.count("the number of triangles");
  const std::int64_t nodes = in.integer_or("the number of nodes per triangle", 3, 6, 3);
  if (nodes != 3 && nodes != 6) in.fail("expected 3 or 6 nodes per triangle, found " + std::to_string(nodes));
  const auto attributes = static_cast<std::size_t>(
      in.integer_or("the number of attributes per triangle", 0, std::numeric_limits<std::int32_t>::max(), 0));
  if (!can_be_a_mesh(n)) in.fail("announces more than " + std::to_string(max_mesh_triangles) + " triangles");
  if (!in.room_for(n, text_bytes(static_cast<std::size_t>(nodes) + 1 + attributes), "triangles")) return;

  mesh.triangles.resize_uninitialised(n);  // each thread then gets the memory of the triangles that it reads
  if (nodes == 6) read.is_middle.resize(mesh.points.size());
  Array<double> region(attributes > 0 ? n : 0);
  read_records(in, "triangle", 0, n, [&](TextReader& line, std::size_t t) {
    read_number(line, "triangle", t, read.base);
    mesh.triangles[t] = {};
    for (Index& corner : mesh.triangles[t].v) {
      corner = read_point_index(line, "a corner of a triangle", mesh.points.size(), read.base);
    }
    for (std::size_t i = 0; nodes == 6 && i < 3; ++i) {
      const Index middle = read_point_index(line, "a middle node of a triangle", mesh.points.size(), read.base);
      if (line.failed()) break;
      const auto node = [&](Index v) {
        return NumberedNode{std::uint64_t{v} + static_cast<unsigned>(read.base), mesh.points[v]};
      };
      const auto& v = mesh.triangles[t].v;
      const std::string fault = why_curved(node(middle), node(v[(i + 1) % 3]), node(v[(i + 2) % 3]));
      if (!fault.empty()) line.fail(fault);
      std::atomic_ref(read.is_middle[middle]).store(1, std::memory_order_relaxed);
    }
    for (std::size_t k = 0; k < attributes; ++k) {
      const double attribute = line.number("a triangle's attribute");
      if (k == 0) region[t] = attribute;
    }
  });
  if (attributes > 0 && !in.failed()) set_regions(mesh, region.span());
}

/// Reads the segments of the .poly that was written with the mesh. Returns false if the .poly has points: then it is
/// the input from which the mesh was made.
bool read_own_segments(TextReader& in, ReadMesh& read) {
  const PointHeader header = read_point_header(in);
  if (header.points > 0) return false;
  for (const Segment& s : read_segments(in, read.mesh.points.size(), read.base).segments) {
    read.mesh.constrained_edges.push_back({s.a, s.b, no_index, s.marker});
  }
  return true;
}

/// `<# of edges> <# of markers>`, then `<edge #> <end> <end> [marker]`, like the segments of a .poly. Edges with a
/// marker become constrained edges: they lie on a segment or on the boundary.
void read_edges(TextReader& in, ReadMesh& read) {
  for (const Segment& s : read_segments(in, read.mesh.points.size(), read.base).segments) {
    if (s.marker != 0) read.mesh.constrained_edges.push_back({s.a, s.b, no_index, s.marker});
  }
}

/// `<# of triangles> 3`, then `<triangle #> <neighbour opposite each corner, -1: none>`. The neighbours follow from the
/// triangles; a file with other neighbours is wrong.
void check_neighbours(TextReader& in, const ReadMesh& read) {
  const Array<Triangle>& triangles = read.mesh.triangles;
  in.expect_line("the number of triangles");
  const std::size_t n = in.count("the number of triangles");
  if (n != triangles.size()) {
    in.fail("expected as many triangles as the .ele has, " + std::to_string(triangles.size()));
  }
  in.integer_or("the number of neighbours per triangle", 3, 3, 3);
  const auto name = [&](Index t) { return t == no_index ? std::int64_t{-1} : std::int64_t{t} + read.base; };
  read_records(in, "triangle", 0, n, [&](TextReader& line, std::size_t t) {
    read_number(line, "triangle", t, read.base);
    for (const Index neighbour : triangles[t].n) {
      const std::int64_t found = line.integer("a neighbour", -1, static_cast<std::int64_t>(n) - 1 + read.base);
      if (found == name(neighbour)) continue;
      line.fail("expected neighbour " + std::to_string(name(neighbour)) + ", as the triangles have it, found " +
                std::to_string(found));
      break;
    }
  });
}

/// Reads `file` with reader(in).
template <class Reader>
Status read_with(const fs::path& file, StopSignal* stop, const Reader& reader) {
  const auto text = read_file(file, stop);
  if (!text.ok()) return text.error();
  TextReader in(*text, file.string(), stop);
  reader(in);
  if (in.failed()) return in.error();
  return Done{};
}

}  // namespace

Result<Mesh> read_triangle_mesh(const fs::path& file, StopSignal* stop) {
  ReadMesh read;
  Status status = Done{};
  const auto read_beside = [&](const char* suffix, const auto& reader) {
    if (status.ok()) status = read_with(fs::path(file).replace_extension(suffix), stop, reader);
  };
  const auto present = [&](const char* suffix) {
    std::error_code unreadable;
    return fs::is_regular_file(fs::path(file).replace_extension(suffix), unreadable);
  };

  read_beside(".node", [&](TextReader& in) { read.base = read_points(in, read_point_header(in), read.mesh); });
  read_beside(".ele", [&](TextReader& in) { read_elements(in, read); });
  bool has_segments = false;
  if (present(".poly")) read_beside(".poly", [&](TextReader& in) { has_segments = read_own_segments(in, read); });
  if (!has_segments && present(".edge")) read_beside(".edge", [&](TextReader& in) { read_edges(in, read); });
  if (!status.ok()) return status.error();
  read.mesh.first_id = {read.base};
  if (!read.is_middle.empty()) remove_middles(read.mesh, std::move(read.is_middle));

  const std::size_t surplus = rebuild_neighbours(read.mesh.triangles, read.mesh.points.size(), stop);
  if (surplus == 0 && present(".neigh")) read_beside(".neigh", [&](TextReader& in) { check_neighbours(in, read); });
  if (!status.ok()) return status.error();
  return std::move(read.mesh);
}

}  // namespace pardel::files
