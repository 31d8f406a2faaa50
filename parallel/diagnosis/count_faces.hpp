// The number of faces of a domain.
#pragma once

#include <cstddef>
#include <vector>

#include "../construction/domain_triangulation.hpp"

namespace pardel::engine {

/// A face is what can be reached from a triangle without crossing a segment. O(n).
[[nodiscard]] inline std::size_t count_faces(const DomainTriangulation& domain) {
  const Triangulation& t = domain.triangulation;
  std::vector<bool> is_visited(t.slots.size());
  std::vector<TriangleId> waiting;
  const auto visit = [&](TriangleId id) {
    if (!is_visited[id]) waiting.push_back(id);
    is_visited[id] = true;
  };
  std::size_t faces = 0;
  for (TriangleId first = 0; first < t.slots.size(); ++first) {
    if (!is_visited[first]) ++faces;
    visit(first);
    while (!waiting.empty()) {
      const Slot& slot = t.slots[waiting.back()];
      waiting.pop_back();
      for (const EdgeRef out : slot.n)
        if (!out.constrained()) visit(out.triangle());
    }
  }
  return faces;
}

}  // namespace pardel::engine
