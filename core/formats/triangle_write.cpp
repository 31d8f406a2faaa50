// Writes Triangle's files.
#include <cmath>

#include "../formats.hpp"
#include "../support/mesh_edges.hpp"
#include "records.hpp"
#include "triangle_records.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;

/// Writes the point section of a Pslg or a Mesh. `total` includes points that the caller adds afterwards.
template <class PointSet>
void write_points(OutputFile& out, const PointSet& set, std::span<const int> markers, int base, std::size_t total) {
  const std::size_t k = set.attributes_per_point;
  Bytes header;
  put_point_header(header, total, k, !markers.empty());
  out.write(header.view());
  const std::span<const double> attributes(set.point_attributes.data(), set.point_attributes.size());
  write_records(out, set.points.size(), [&](Bytes& to, std::size_t i) {
    put_point(to, i + base, set.points[i], attributes.subspan(i * k, k), markers.empty() ? nullptr : &markers[i]);
  });
}

/// Segments, constrained edges, or edges.
template <class Edges>
void write_edges(OutputFile& out, const Edges& edges, bool markers, int base) {
  Bytes header;
  put_edge_header(header, edges.size(), markers);
  out.write(header.view());
  write_records(out, edges.size(), [&](Bytes& to, std::size_t i) {
    const auto& edge = edges[i];
    put_edge(to, i + base, std::uint64_t{edge.a} + base, std::uint64_t{edge.b} + base,
             markers ? &edge.marker : nullptr);
  });
}

void write_holes_and_regions(OutputFile& out, const Pslg& pslg, int base) {
  Bytes to;
  put_holes_and_regions(to, pslg, base);
  out.write(to.view());
}

/// Writes the .node. Points of a mesh without markers get none. If the mesh is written in second order, the midpoints
/// of all edges follow the vertices. The attributes of a midpoint are the means of the attributes of the edge's ends.
void write_node(OutputFile& out, const Mesh& mesh, const EdgeTable& table, const TriangleFiles& files) {
  const std::size_t n = mesh.points.size();
  const std::size_t middles = files.second_order ? table.edges.size() : 0;
  const std::span<const int> markers = files.markers ? mesh.point_markers.span() : std::span<const int>();
  write_points(out, mesh, markers, files.base, n + middles);
  const std::size_t k = mesh.attributes_per_point;
  write_records(out, middles, [&](Bytes& to, std::size_t i) {
    const MarkedEdge& edge = table.edges[i];
    const Point& a = mesh.points[edge.a];
    const Point& b = mesh.points[edge.b];
    std::vector<double> attributes(k);
    for (std::size_t j = 0; j < k; ++j) {
      attributes[j] = 0.5 * (mesh.point_attributes[edge.a * k + j] + mesh.point_attributes[edge.b * k + j]);
    }
    put_point(to, n + i + files.base, {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, attributes,
              markers.empty() ? nullptr : &edge.marker);
  });
}

/// Writes the .ele. If the mesh has regions, each triangle has one attribute, that of its region. In a second-order
/// triangle, node 4 is the midpoint of the edge opposite corner 1, node 5 that opposite corner 2, and node 6 that
/// opposite corner 3.
void write_ele(OutputFile& out, const Mesh& mesh, const EdgeTable& table, const TriangleFiles& files) {
  const bool regions = !mesh.region.empty();
  Bytes header;
  put_triangle_header(header, mesh.triangles.size(), files.second_order ? 6 : 3, regions);
  out.write(header.view());
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto corner = [&](std::size_t i) { return std::uint64_t{mesh.triangles[t].v[i]} + files.base; };
    to.numbers(t + files.base, corner(0), corner(1), corner(2));
    for (std::size_t i = 0; files.second_order && i < 3; ++i) {
      to << ' ' << mesh.points.size() + table.edge_of_side[3 * t + i] + files.base;
    }
    if (regions) to << ' ' << (mesh.region[t] == no_index ? 0.0 : mesh.region_attributes[mesh.region[t]]);
    to << '\n';
  });
}

void write_neigh(OutputFile& out, const Mesh& mesh, int base) {
  Bytes header;
  header << mesh.triangles.size() << " 3\n";
  out.write(header.view());
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto number = [&](Index n) { return n == no_index ? std::int64_t{-1} : std::int64_t{n} + base; };
    const auto& n = mesh.triangles[t].n;
    to.numbers(t + base, number(n[0]), number(n[1]), number(n[2])) << '\n';
  });
}

}  // namespace

void files::put_holes_and_regions(Bytes& to, const Pslg& pslg, int base) {
  to << pslg.holes.size() << '\n';
  for (std::size_t i = 0; i < pslg.holes.size(); ++i) put_point(to, i + base, pslg.holes[i], {}, nullptr);
  if (pslg.regions.empty()) return;
  to << pslg.regions.size() << '\n';
  for (std::size_t i = 0; i < pslg.regions.size(); ++i) {
    const Region& r = pslg.regions[i];
    to.numbers(i + base, r.seed.x, r.seed.y, r.attribute, std::isinf(r.max_area) ? -1.0 : r.max_area) << '\n';
  }
}

Status write_poly(const Pslg& pslg, const fs::path& file, int base, const GoOn& go_on) {
  OutputFile out(file, go_on);
  write_points(out, pslg, pslg.point_markers, base, pslg.points.size());
  write_edges(out, pslg.segments, pslg.has_segment_markers, base);
  write_holes_and_regions(out, pslg, base);
  return out.commit();
}

Status write_area(const fs::path& file, std::span<const double> caps, int base) {
  OutputFile out(file);
  Bytes header;
  header << caps.size() << '\n';
  out.write(header.view());
  write_records(out, caps.size(),
                [&](Bytes& to, std::size_t i) { to.numbers(i + base, std::isinf(caps[i]) ? -1.0 : caps[i]) << '\n'; });
  return out.commit();
}

Status write_triangle_files(const Mesh& mesh, const Pslg& pslg, const fs::path& stem, const TriangleFiles& files) {
  std::deque<OutputFile> outputs;
  const auto open = [&](const char* suffix) -> OutputFile& {
    return outputs.emplace_back(fs::path(stem) += suffix, files.go_on);
  };
  const EdgeTable table = files.write_edge || files.second_order ? edge_table(mesh) : EdgeTable();

  if (files.write_node) write_node(open(".node"), mesh, table, files);
  if (files.write_ele) write_ele(open(".ele"), mesh, table, files);
  if (files.write_poly) {
    OutputFile& out = open(".poly");
    Bytes header;
    put_point_header(header, 0, mesh.attributes_per_point, files.markers && !mesh.point_markers.empty());
    out.write(header.view());
    write_edges(out, mesh.constrained_edges, files.markers, files.base);
    // Without segments a .poly stands for the convex hull, in which a hole would remove everything.
    write_holes_and_regions(out, mesh.constrained_edges.empty() ? Pslg{} : pslg, files.base);
  }
  if (files.write_edge) write_edges(open(".edge"), table.edges, files.markers, files.base);
  if (files.write_neigh) write_neigh(open(".neigh"), mesh, files.base);
  if (!files.command.empty()) {
    for (OutputFile& out : outputs) out.write("# Generated by " + files.command + "\n");
  }
  return commit_all(outputs);
}

}  // namespace pardel
