// The grid of SCHISM (hgrid.gr3) and of ADCIRC (fort.14): a title; the numbers of elements and nodes; `ID X Y DEPTH`
// per node; `ID 3 A B C` per element; the number of open boundaries, the number of their nodes, and for each its number
// of nodes and its nodes, one per line; then the same for land boundaries, with their types after the numbers of nodes.
// What follows the fields of a line is a comment.
#include <algorithm>

#include "../formats.hpp"
#include "../neighbours.hpp"
#include "../support/mesh_edges.hpp"
#include "chains.hpp"
#include "mesh_readers.hpp"
#include "records.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
namespace {

constexpr int land_marker = 1;
constexpr std::int64_t island_type = 1;

void read_nodes(TextReader& in, Mesh& mesh) {
  read_records(in, "node", 0, mesh.points.size(), [&](TextReader& line, std::size_t i) {
    read_number(line, "node", i, 1);
    const double x = line.number("an x coordinate");
    const double y = line.number("a y coordinate");
    mesh.points[i] = {x, y};
    mesh.point_attributes[i] = line.number("a depth");
  });
}

void read_elements(TextReader& in, Mesh& mesh) {
  read_records(in, "element", 0, mesh.triangles.size(), [&](TextReader& line, std::size_t t) {
    read_number(line, "element", t, 1);
    line.integer("the number of nodes of an element (only triangles are read)", 3, 3);
    for (Index& corner : mesh.triangles[t].v) corner = read_point_index(line, "a node", mesh.points.size(), 1);
  });
}

/// An island is closed: its last node is joined to its first one. Weirs (types such as 24) have two nodes per line, of
/// which the first is read.
void read_boundary(TextReader& in, int marker, bool is_land, Mesh& mesh) {
  in.expect_line("the number of nodes of a boundary");
  const std::size_t n = in.count("the number of nodes of a boundary");
  const std::int64_t type = is_land ? in.integer_or("the type of a boundary", 0, any_marker_high, 0) : 0;
  if (!in.room_for(n, text_bytes(1), "nodes of a boundary")) return;
  Index first = no_index, last = no_index;
  const auto join = [&](Index from, Index to) {
    if (from != no_index && from != to) mesh.constrained_edges.push_back({from, to, no_index, marker});
  };
  for (std::size_t i = 0; i < n && in.expect_record("node of a boundary", i, n); ++i) {
    const Index node = read_point_index(in, "a node of a boundary", mesh.points.size(), 1);
    join(last, node);
    last = node;
    if (i == 0) first = node;
  }
  const std::int64_t kind = type % 10;  // 1, 11 and 21 are islands
  if (is_land && kind == island_type && n > 2) join(last, first);
}

void read_boundaries(TextReader& in, bool is_land, Mesh& mesh) {
  const std::string_view what = is_land ? "the number of land boundaries" : "the number of open boundaries";
  const std::size_t n = in.count(what);
  if (!in.room_for(n, text_bytes(1), is_land ? "land boundaries" : "open boundaries")) return;
  in.expect_line("the number of nodes of all boundaries");
  in.count("the number of nodes of all boundaries");
  for (std::size_t k = 0; k < n && !in.failed(); ++k)
    read_boundary(in, is_land ? land_marker : land_marker + static_cast<int>(k) + 1, is_land, mesh);
}

/// The edges of the boundary of each kind, with the domain to their left.
struct Boundaries {
  std::vector<EdgeEnds> land;
  std::vector<std::vector<EdgeEnds>> open;  ///< per open marker
};

Boundaries boundaries_of(const Mesh& mesh, std::span<const int> open_markers) {
  Boundaries boundaries;
  boundaries.open.resize(open_markers.size());
  const ConstrainedEdgeIndex constrained(mesh);
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (t.n[i] != no_index) continue;
      const EdgeEnds edge{t.v[(i + 1) % 3], t.v[(i + 2) % 3]};
      const ConstrainedEdge* given = constrained.find(edge[0], edge[1]);
      const auto open = std::ranges::find(open_markers, given != nullptr ? given->marker : land_marker);
      auto& edges = open == open_markers.end() ? boundaries.land
                                               : boundaries.open[static_cast<std::size_t>(open - open_markers.begin())];
      edges.push_back(edge);
    }
  }
  return boundaries;
}

/// True if the domain lies outside of the closed chain: it runs clockwise.
bool is_island(const Mesh& mesh, const Chain& chain) {
  if (chain.front() != chain.back()) return false;
  const Point origin = mesh.points[chain.front()];
  double doubled_area = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Point &p = mesh.points[chain[i]], &q = mesh.points[chain[i + 1]];
    doubled_area += (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
  }
  return doubled_area < 0;
}

struct BoundaryList {
  Chain nodes;
  bool is_island = false;
};

void write_boundaries(OutputFile& out, std::string_view kind, const std::vector<BoundaryList>& lists) {
  std::size_t nodes = 0;
  for (const BoundaryList& list : lists) nodes += list.nodes.size();
  Bytes header;
  header << lists.size() << " = number of " << kind << " boundaries\n"
         << nodes << " = number of nodes of all " << kind << " boundaries\n";
  out.write(header.view());
  for (std::size_t k = 0; k < lists.size(); ++k) {
    Bytes head;
    head << lists[k].nodes.size();
    if (kind == "land") head << ' ' << int{lists[k].is_island};
    out.write((head << " = number of nodes of " << kind << " boundary " << k + 1 << '\n').view());
    write_records(out, lists[k].nodes.size(),
                  [&](Bytes& to, std::size_t i) { to << std::uint64_t{lists[k].nodes[i]} + 1 << '\n'; });
  }
}

Error no_such_boundary(const std::filesystem::path& file, int marker) {
  return {ErrorKind::usage, file.string() + ": no edge of the boundary has the marker " + std::to_string(marker) +
                                ", which shall be an open boundary"};
}

}  // namespace

Result<Mesh> files::parse_gr3(std::string_view text, const std::string& name, StopSignal* stop) {
  TextReader in(text, name, stop);
  in.end_line();  // the title, which may be empty or begin with #
  in.expect_line("the number of elements");
  const std::size_t triangles = in.count("the number of elements");
  const std::size_t points = in.count("the number of nodes");
  if (points > max_points || !can_be_a_mesh(triangles)) in.fail("announces more than a mesh can hold");
  if (!in.room_for(points, text_bytes(4), "nodes")) return in.error();
  if (!in.room_for(triangles, text_bytes(5), "elements")) return in.error();
  Mesh mesh;
  mesh.points.resize(points);
  mesh.attributes_per_point = points > 0 ? 1 : 0;
  mesh.point_attributes.resize(points);
  read_nodes(in, mesh);
  mesh.triangles.resize(triangles);
  read_elements(in, mesh);
  for (const bool is_land : {false, true})
    if (in.next_line()) read_boundaries(in, is_land, mesh);
  if (in.failed()) return in.error();
  rebuild_neighbours(mesh.triangles, mesh.points.size(), stop);
  mesh.first_id = {1};
  return mesh;
}

Status write_gr3(const Mesh& mesh, const std::filesystem::path& file, std::span<const int> open_markers,
                 const GoOn& go_on) {
  const Boundaries boundaries = boundaries_of(mesh, open_markers);
  std::vector<BoundaryList> open, land;
  for (std::size_t k = 0; k < open_markers.size(); ++k) {
    if (boundaries.open[k].empty()) return no_such_boundary(file, open_markers[k]);
    for (Chain& chain : chains_of(boundaries.open[k])) open.push_back({std::move(chain)});
  }
  for (Chain& chain : chains_of(boundaries.land)) {
    const bool closes_an_island = is_island(mesh, chain);
    if (closes_an_island) chain.pop_back();
    land.push_back({std::move(chain), closes_an_island});
  }

  OutputFile out(file, go_on);
  Bytes header;
  header << "pardel\n" << mesh.triangles.size() << ' ' << mesh.points.size() << " = numbers of elements and nodes\n";
  out.write(header.view());
  const std::size_t k = mesh.attributes_per_point;
  write_records(out, mesh.points.size(), [&](Bytes& to, std::size_t i) {
    to.numbers(i + 1, mesh.points[i].x, mesh.points[i].y, k > 0 ? mesh.point_attributes[i * k] : 0.0) << '\n';
  });
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto& v = mesh.triangles[t].v;
    to.numbers(t + 1, 3, std::uint64_t{v[0]} + 1, std::uint64_t{v[1]} + 1, std::uint64_t{v[2]} + 1) << '\n';
  });
  write_boundaries(out, "open", open);
  write_boundaries(out, "land", land);
  return out.commit();
}

}  // namespace pardel
