// The OFF format: "OFF", then the numbers of vertices, faces and edges, then "x y z" per vertex and "3 a b c" per face.
// Further numbers of a record are colours and are ignored. z is written as 0 and ignored by the reader. The format has
// no edges of its own, so comments at the end list the constrained edges; other readers ignore comments.
#include "../formats.hpp"
#include "../neighbours.hpp"
#include "mesh_readers.hpp"
#include "records.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
namespace {

constexpr std::string_view heading = "# constrained edges: ";

/// Reads the comments `# constrained edges: N`, then `# A B MARKER` N times, if there are any after the faces.
void read_constrained_edges(TextReader& in, Mesh& mesh) {
  in.end_line();
  const std::size_t at = in.rest().find(heading);
  if (in.failed() || at == std::string_view::npos) return;
  in.skip(at + heading.size());
  const std::size_t n = in.count("the number of constrained edges");
  if (!in.room_for(n, text_bytes(4), "constrained edges")) return;
  mesh.constrained_edges.resize(n);
  for (std::size_t i = 0; i < n && !in.failed(); ++i) {
    in.end_line();
    if (!in.rest().starts_with("# "))
      return in.fail("expected the comment of constrained edge " + std::to_string(i + 1) + " of " + std::to_string(n));
    in.skip(2);
    ConstrainedEdge& edge = mesh.constrained_edges[i];
    edge.a = read_point_index(in, "an end of a constrained edge", mesh.points.size(), 0);
    edge.b = read_point_index(in, "an end of a constrained edge", mesh.points.size(), 0);
    edge.marker = static_cast<int>(in.integer("the marker of a constrained edge", any_marker_low, any_marker_high));
  }
}

}  // namespace

Result<Mesh> files::parse_off(std::string_view text, const std::string& name, StopSignal* stop) {
  TextReader in(text, name, stop);
  Mesh mesh;
  in.expect_line("\"OFF\"");
  if (const std::string_view word = in.word(); word != "OFF") in.fail("expected \"OFF\", found " + in_quotes(word));
  if (!in.has_field()) in.expect_line("the number of vertices");
  const std::size_t points = in.count("the number of vertices");
  const std::size_t triangles = in.count("the number of faces");
  if (points > max_points || !can_be_a_mesh(triangles)) in.fail("announces more than a mesh can hold");
  if (!in.room_for(points, text_bytes(2), "vertices")) return in.error();
  if (!in.room_for(triangles, text_bytes(4), "faces")) return in.error();

  mesh.points.resize(points);
  read_records(in, "vertex", 0, points, [&](TextReader& line, std::size_t i) {
    const double x = line.number("an x coordinate");
    const double y = line.number("a y coordinate");
    mesh.points[i] = {x, y};
  });
  mesh.triangles.resize(triangles);
  read_records(in, "face", 0, triangles, [&](TextReader& line, std::size_t t) {
    line.integer("the number of corners", 3, 3);
    for (Index& corner : mesh.triangles[t].v) corner = read_point_index(line, "a corner of a face", points, 0);
  });
  if (in.failed()) return in.error();
  read_constrained_edges(in, mesh);
  if (in.failed()) return in.error();
  rebuild_neighbours(mesh.triangles, mesh.points.size(), stop);
  return mesh;
}

Status write_off(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on) {
  OutputFile out(file, go_on);
  Bytes header;
  header << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  out.write(header.view());
  write_records(out, mesh.points.size(),
                [&](Bytes& to, std::size_t i) { to.numbers(mesh.points[i].x, mesh.points[i].y) << " 0\n"; });
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto& v = mesh.triangles[t].v;
    to.numbers(3, v[0], v[1], v[2]) << '\n';
  });
  if (!mesh.constrained_edges.empty()) {
    Bytes comment;
    out.write((comment << heading << mesh.constrained_edges.size() << '\n').view());
  }
  write_records(out, mesh.constrained_edges.size(), [&](Bytes& to, std::size_t i) {
    const ConstrainedEdge& edge = mesh.constrained_edges[i];
    (to << "# ").numbers(edge.a, edge.b, edge.marker) << '\n';
  });
  return out.commit();
}

}  // namespace pardel
