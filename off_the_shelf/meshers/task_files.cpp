#include "task_files.hpp"

#include <utility>

#include "../../core/formats.hpp"
#include "hole_seeds.hpp"

namespace pardel::engine {
namespace {

Mesh mesh_of(const Subdomain& subdomain) {
  Mesh mesh;
  mesh.points = Array<Point>(std::span(subdomain.points));
  for (const auto& corners : subdomain.triangles) mesh.triangles.push_back({.v = corners});
  for (const SubdomainEdge& e : subdomain.edges)
    mesh.constrained_edges.push_back({e.a, e.b, no_index, e.inside ? 0 : 1});
  return mesh;
}

}  // namespace

Status write_task(const Subdomain& subdomain, std::span<const double> caps, const std::filesystem::path& stem,
                  bool with_holes) {
  Pslg seeds;
  if (with_holes) {
    Result<std::vector<Point>> holes = hole_seeds(subdomain);
    if (!holes) return holes.error();
    seeds.holes = std::move(*holes);
  }
  if (Status written = write_triangle_files(mesh_of(subdomain), seeds, stem, {}); !written) return written;
  return write_area(std::filesystem::path(stem) += ".area", caps);
}

RefinedSubdomain answer_of(const Mesh& mesh, const Subdomain& subdomain) {
  RefinedSubdomain answer;
  answer.points.assign(mesh.points.begin(), mesh.points.end());
  if (answer.points.size() > subdomain.points.size())
    answer.edge_of_new_point.assign(answer.points.size() - subdomain.points.size(), no_index);
  answer.triangles.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) answer.triangles.push_back(triangle.v);
  if (answer.edge_of_new_point.size() >= subdomain.most_new_points) answer.ending = RefinedSubdomain::Ending::limit;
  return answer;
}

}  // namespace pardel::engine
