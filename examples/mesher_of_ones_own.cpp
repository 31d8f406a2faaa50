// A mesher of one's own, on all cores: the worst one that one can think of, and yet every bound holds in the end.
#include <cstdio>
#include <pardel/off_the_shelf/mesh_with_mesher.hpp>

namespace {

/// Puts points into the centroids of triangles that are too large. It does not care about angles.
class CentroidMesher final : public pardel::SubdomainMesher {
 public:
  [[nodiscard]] pardel::MesherAbilities abilities() const override {
    return {.keeps_frozen_edges = true, .is_thread_safe = true};
  }
  [[nodiscard]] pardel::RefinedSubdomain refine(const pardel::Subdomain& part) override {
    pardel::RefinedSubdomain answer;
    answer.points = part.points;
    answer.triangles = part.triangles;
    for (std::size_t i = 0; i < answer.triangles.size();) {
      const auto [u, v, w] = answer.triangles[i];
      const pardel::Point a = answer.points[u], b = answer.points[v], c = answer.points[w];
      const double area = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
      const bool may_insert = answer.points.size() < part.points.size() + part.most_new_points;
      if (area <= part.goal.max_area || !may_insert) {
        ++i;
        continue;
      }
      const auto centroid = static_cast<pardel::Index>(answer.points.size());
      answer.points.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
      answer.edge_of_new_point.push_back(pardel::no_index);  // it splits no edge
      answer.triangles[i] = {u, v, centroid};
      answer.triangles.push_back({v, w, centroid});
      answer.triangles.push_back({w, u, centroid});
    }
    return answer;
  }
};

}  // namespace

int main() {
  pardel::Pslg square;
  square.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  square.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  const auto domain = pardel::validate(square);
  CentroidMesher mesher;
  const auto made = pardel::mesh_with_mesher(*domain, {.min_angle_deg = 25, .max_area = 1e-4}, mesher);
  if (!made) {
    std::fprintf(stderr, "%s\n", made.error().message.c_str());
    return 1;
  }
  std::printf("%zu triangles, %llu vertices by the mesher; every bound holds: %s\n", made->mesh.triangles.size(),
              static_cast<unsigned long long>(made->mesher.inserted), made->report.goal_met() ? "yes" : "no");
}
