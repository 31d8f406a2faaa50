#include "sequential.hpp"

#include <algorithm>

namespace pardel::schemes::cells {

std::uint64_t refine_where(LinkedMesh& mesh, const Bounds& bounds, std::deque<Index> waiting,
                           const std::function<bool(Index)>& is_due, std::size_t most_points) {
  std::uint64_t work = 0;
  while (!waiting.empty() && mesh.points.size() < most_points) {
    const Index t = waiting.front();
    waiting.pop_front();
    if (!mesh.in_use(t) || !is_due(t)) continue;
    const auto insertion = insertion_for(mesh, t, bounds);
    if (!insertion) continue;
    work += insertion->work();
    const std::vector<Index> made = carry_out(mesh, *insertion);
    waiting.insert(waiting.end(), made.begin(), made.end());
    // A triangle whose circumcentre was rejected is still there.
    if (std::ranges::find(insertion->cavity.triangles, t) == insertion->cavity.triangles.end()) waiting.push_back(t);
  }
  return work;
}

std::deque<Index> all_triangles(const LinkedMesh& mesh) {
  std::deque<Index> all;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) all.push_back(t);
  return all;
}

}  // namespace pardel::schemes::cells
