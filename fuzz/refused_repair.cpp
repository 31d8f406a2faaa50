#include "refused_repair.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../parallel/validate.hpp"
#include "exact_signs.hpp"
#include "fuzz_one.hpp"

namespace pardel::fuzz {
namespace {

/// The range that validate.hpp promises, written a second time on purpose.
bool is_usable(double x) { return x == 0 || (std::abs(x) >= 0x1p-140 && std::abs(x) <= 0x1p200); }

bool has_unusable_values(const Pslg& pslg) {
  return !std::ranges::all_of(pslg.points, [](Point p) { return is_usable(p.x) && is_usable(p.y); }) ||
         !std::ranges::all_of(pslg.regions, [](const Region& r) { return r.max_area > 0; });
}

bool on_one_line(const std::vector<Point>& points) {
  const auto other = std::ranges::find_if(points, [&](Point p) { return p != points.front(); });
  return other == points.end() ||
         std::ranges::all_of(points, [&](Point p) { return true_orientation(points.front(), *other, p) == 0; });
}

/// Places that are joined by segments.
class Paths {
 public:
  explicit Paths(const Pslg& pslg) {
    for (const Segment& s : pslg.segments) {
      const Place a = place(pslg.points[s.a]), b = place(pslg.points[s.b]);
      if (a == b) continue;
      joined_[a].insert(b);
      joined_[b].insert(a);
    }
  }

  /// True if a segment closes a path whose corners are not all on one line. Such a path encloses an area. Not all paths
  /// are tried, and none through crossings.
  [[nodiscard]] bool enclose_an_area() const {
    for (const auto& [from, neighbours] : joined_)
      for (const Place& to : neighbours)
        if (const std::vector<Point> corners = path_around(from, to); !corners.empty() && !on_one_line(corners))
          return true;
    return false;
  }

 private:
  using Place = std::pair<double, double>;

  static Place place(Point p) { return {p.x, p.y}; }
  static Point point(const Place& p) { return {p.first, p.second}; }

  /// A shortest path from one end of a segment to the other that does not use the segment; empty if there is none.
  [[nodiscard]] std::vector<Point> path_around(const Place& from, const Place& to) const {
    std::map<Place, Place> before{{from, from}};
    std::vector<Place> found{from};
    for (std::size_t i = 0; i < found.size() && !before.contains(to); ++i)
      for (const Place& next : joined_.at(found[i]))
        if (!(found[i] == from && next == to) && before.emplace(next, found[i]).second) found.push_back(next);
    if (!before.contains(to)) return {};
    std::vector<Point> corners{point(from)};
    for (Place at = to; at != from; at = before.at(at)) corners.push_back(point(at));
    return corners;
  }

  std::map<Place, std::set<Place>> joined_;
};

bool encloses_an_area(const Pslg& pslg, bool convex_hull) {
  if (pslg.points.empty()) return false;
  if (convex_hull || pslg.segments.empty()) return !on_one_line(pslg.points);
  return Paths(pslg).enclose_an_area();
}

bool has_a_hole_in_every_face(const Pslg& pslg, bool convex_hull) {
  const std::vector<Problem> problems = find_problems(pslg, {.convex_hull = convex_hull});
  return std::ranges::any_of(problems, [](const Problem& p) { return p.kind == ProblemKind::no_domain; });
}

}  // namespace

void check_refusal(const Pslg& pslg, const RepairOptions& options, const Error& error) {
  if (error.kind != ErrorKind::invalid_input || error.message.empty())
    fail("repair ends with an error of another kind: " + error.message);
  if (options.snap.value_or(0) > 0 || has_unusable_values(pslg) || !encloses_an_area(pslg, options.convex_hull)) return;

  // The repair that chooses its distances itself ends with an error only if it fails without snapping.
  Pslg bare = pslg;
  bare.holes.clear();
  const Result<Repaired> repaired = repair(bare, {.snap = 0, .convex_hull = options.convex_hull});
  if (!repaired) {
    const bool are_crossings_the_reason = repaired.error().message.find("ever more crossings") != std::string::npos;
    if (!options.snap || !are_crossings_the_reason || !repair(bare, {.convex_hull = options.convex_hull}))
      fail("a domain that encloses an area cannot be repaired: " + repaired.error().message);
    return;
  }
  Pslg with_holes = repaired->domain.pslg();
  with_holes.holes = pslg.holes;
  if (!has_a_hole_in_every_face(with_holes, options.convex_hull))
    fail("a domain of which something would be left cannot be repaired: " + error.message);
}

}  // namespace pardel::fuzz
