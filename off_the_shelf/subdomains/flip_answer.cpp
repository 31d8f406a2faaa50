#include "flip_answer.hpp"

#include <array>
#include <vector>

#include "../../parallel/arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

class Flips {
 public:
  explicit Flips(VerifiedSubdomain& answer) : a_(answer) {}

  void run() {
    std::vector<Index> suspects;
    for (Index side = 0; side < a_.across.size(); ++side)
      if (side < a_.across[side] && !is_delaunay(side)) suspects.push_back(side);
    while (!suspects.empty()) {
      const Index side = suspects.back();
      suspects.pop_back();
      if (is_delaunay(side)) continue;
      const Index left = side / 3, right = a_.across[side] / 3;
      flip(side);
      suspects.insert(suspects.end(), {3 * left, 3 * left + 2, 3 * right, 3 * right + 2});
    }
  }

 private:
  [[nodiscard]] bool stays(Index side) const { return a_.across[side] == no_index || a_.on_edge[side] != no_index; }
  [[nodiscard]] bool is_delaunay(Index side) const {
    if (stays(side)) return true;
    const auto& v = a_.triangles[side / 3];
    const Index opposite = a_.triangles[a_.across[side] / 3][a_.across[side] % 3];
    return !(incircle(a_.points[v[0]], a_.points[v[1]], a_.points[v[2]], a_.points[opposite]) > 0);
  }

  /// What is beyond a side.
  struct Beyond {
    Index across, on_edge;
  };
  [[nodiscard]] Beyond beyond(Index triangle, Index side) const {
    return {a_.across[3 * triangle + side % 3], a_.on_edge[3 * triangle + side % 3]};
  }
  void link(Index side, const Beyond& to) {
    a_.across[side] = to.across;
    a_.on_edge[side] = to.on_edge;
    if (to.across != no_index) a_.across[to.across] = side;
  }

  /// The triangles (p, a, b) and (q, b, a) become (p, a, q) and (q, b, p).
  void flip(Index side) {
    const Index left = side / 3, i = side % 3, right = a_.across[side] / 3, j = a_.across[side] % 3;
    const auto of_left = a_.triangles[left], of_right = a_.triangles[right];
    const Index p = of_left[i], a = of_left[(i + 1) % 3], b = of_left[(i + 2) % 3], q = of_right[j];
    const Beyond bp = beyond(left, i + 1), pa = beyond(left, i + 2), aq = beyond(right, j + 1),
                 qb = beyond(right, j + 2);
    a_.triangles[left] = {p, a, q};
    a_.triangles[right] = {q, b, p};
    link(3 * left, aq);
    link(3 * left + 2, pa);
    link(3 * right, bp);
    link(3 * right + 2, qb);
    link(3 * left + 1, {3 * right + 1, no_index});
    link(3 * right + 1, {3 * left + 1, no_index});
  }

  VerifiedSubdomain& a_;
};

}  // namespace

void flip_to_delaunay(VerifiedSubdomain& answer) { Flips(answer).run(); }

}  // namespace pardel::engine
