#include "split_candidates.hpp"

#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

/// The cosines of 0, 22.5, ..., 337.5 degrees. The sine of an angle is the cosine of the angle minus 90 degrees.
constexpr double c1 = 0.92387953251128674, c2 = 0.70710678118654752, c3 = 0.38268343236508977;
constexpr std::array<double, candidates_per_circle> cosines{1,  c1,  c2,  c3,  0, -c3, -c2, -c1,
                                                            -1, -c1, -c2, -c3, 0, c3,  c2,  c1};
constexpr std::size_t quarter_turn = candidates_per_circle / 4;

}  // namespace

std::array<CandidateCircle, candidate_circles> split_candidates(const Shape& shape) {
  const unsigned apex = shape.shortest_side();
  const Point a = shape.p[apex], q = shape.p[next_corner[apex]], r = shape.p[previous_corner[apex]];
  const auto [x, y] = to_circumcentre({q.x - a.x, q.y - a.y}, {r.x - a.x, r.y - a.y}, shape.twice_area);
  std::array<CandidateCircle, candidate_circles> circles;
  for (std::size_t circle = 0; circle < candidate_circles; ++circle) {
    const double part = 0.25 * static_cast<double>(circle + 1);
    for (std::size_t k = 0; k < candidates_per_circle; ++k) {
      const double c = -part * cosines[k], s = -part * cosines[(k + 3 * quarter_turn) % candidates_per_circle];
      circles[circle][k] = {snapped(a.x + x + c * x - s * y), snapped(a.y + y + s * x + c * y)};
    }
  }
  return circles;
}

}  // namespace pardel::engine
