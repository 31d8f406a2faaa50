// Labels for the triangles that belong together.
#pragma once

#include <vector>

#include "../threads/threads.hpp"
#include "../triangulation/triangulation.hpp"

namespace pardel::engine {

/// Labels all triangles that can be reached from the triangles on the stack without crossing a constrained edge.
inline void flood(const Triangulation& t, std::vector<TriangleId>& stack, Array<Index>& label, Index value,
                  SparseAsk& ask) {
  while (!stack.empty()) {
    ask();
    const TriangleId id = stack.back();
    stack.pop_back();
    if (label[id] == value) continue;
    label[id] = value;
    for (const EdgeRef out : t.slots[id].n)
      if (!out.constrained() && label[out.triangle()] != value) stack.push_back(out.triangle());
  }
}

}  // namespace pardel::engine
