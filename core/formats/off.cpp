// The OFF format: "OFF", then the numbers of vertices, faces and edges, then "x y z" per vertex and "3 a b c" per face.
// Further numbers of a record are colours and are ignored. z is written as 0 and ignored by the reader.
#include "../formats.hpp"
#include "../neighbours.hpp"
#include "mesh_readers.hpp"
#include "records.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;

Result<Mesh> files::parse_off(std::string_view text, const std::string& name) {
  TextReader in(text, name);
  Mesh mesh;
  in.expect_line("\"OFF\"");
  if (const std::string_view word = in.word(); word != "OFF") in.fail("expected \"OFF\", found " + in_quotes(word));
  if (!in.has_field()) in.expect_line("the number of vertices");
  const std::size_t points = in.count("the number of vertices");
  const std::size_t triangles = in.count("the number of faces");
  if (points > max_points || triangles > max_mesh_triangles) in.fail("announces more than a mesh can hold");
  if (!in.room_for(points, text_bytes(2), "vertices")) return in.error();
  if (!in.room_for(triangles, text_bytes(4), "faces")) return in.error();

  mesh.points.resize(points);
  for (std::size_t i = 0; i < points && in.expect_record("vertex", i, points); ++i) {
    const double x = in.number("an x coordinate");
    const double y = in.number("a y coordinate");
    mesh.points[i] = {x, y};
    if (in.failed()) return in.error();
  }
  mesh.triangles.resize(triangles);
  for (std::size_t t = 0; t < triangles && in.expect_record("face", t, triangles); ++t) {
    in.integer("the number of corners", 3, 3);
    for (Index& corner : mesh.triangles[t].v) corner = read_point_index(in, "a corner of a face", points, 0);
    if (in.failed()) return in.error();
  }
  if (in.failed()) return in.error();
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  return mesh;
}

Status write_off(const Mesh& mesh, const std::filesystem::path& file) {
  OutputFile out(file);
  Bytes header;
  header << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  out.write(header.view());
  write_records(out, mesh.points.size(),
                [&](Bytes& to, std::size_t i) { to << mesh.points[i].x << ' ' << mesh.points[i].y << " 0\n"; });
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto& v = mesh.triangles[t].v;
    to << "3 " << v[0] << ' ' << v[1] << ' ' << v[2] << '\n';
  });
  return out.commit();
}

}  // namespace pardel
