// Several ranks triangulate and mesh points that none of them has as a whole.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/segments_in_pieces.hpp"
#include "../framework/shares.hpp"
#include "meshing.hpp"

namespace pardel::properties {
namespace {

constexpr const char* point_families =
    "points on lattices of 5 to 100,000 columns and rows, shuffled and dealt to two to six "
    "ranks in parts of any size";

/// Points on a lattice, which are not all on one line. On a small lattice most of them are cocircular with others.
Pslg some_points(Exhibit& exhibit) {
  const int side = *rc::gen::element(5, 12, 60, 100'000);
  const auto places = *rc::gen::resize(300, rc::gen::container<std::vector<std::pair<int, int>>>(
                                                rc::gen::pair(rc::gen::inRange(0, side), rc::gen::inRange(0, side))));
  Pslg pslg;
  std::set<std::pair<int, int>> seen;
  for (const auto& place : places)
    if (seen.insert(place).second) pslg.points.push_back({0.5 * place.first, 0.5 * place.second});
  exhibit.show(pslg);
  RC_PRE(find_problems(pslg).empty());
  classify(side <= 12, "with many cocircular points", 20);
  return pslg;
}

/// Where the part of each rank begins, of n things; last, n.
std::vector<std::size_t> begins_of_parts(std::size_t n, int ranks) {
  std::vector<std::size_t> begin{0};
  for (int rank = 1; rank < ranks; ++rank) begin.push_back(*rc::gen::inRange<std::size_t>(0, n + 1));
  std::ranges::sort(begin);
  begin.push_back(n);
  return begin;
}

/// What each rank has read.
std::vector<PartOfPoints> dealt(const Pslg& pslg, int ranks) {
  const std::vector<std::size_t> begin = begins_of_parts(pslg.points.size(), ranks);
  std::vector<PartOfPoints> parts;
  for (std::size_t rank = 0; rank + 1 < begin.size(); ++rank)
    parts.push_back(domains::points_between(pslg, begin[rank], begin[rank + 1]));
  return parts;
}

/// The ranks call make(part, ranks), and together have to get this mesh.
template <class Make>
void require_together(const Mesh& whole, std::vector<PartOfPoints> parts, const Make& make) {
  const int count = static_cast<int>(parts.size());
  const bool with_delays = *rc::gen::inRange(0, 10) == 0;
  const std::string difference = difference_on_ranks(
      whole, count, [&](pardel::Ranks& ranks) { return make(std::move(parts[ranks.rank()]), ranks); },
      with_delays ? 1 : 0);
  RC_ASSERT(difference == "");
}

/// Adds an attribute that is not linear, in half of the cases.
Pslg with_attributes(Pslg pslg) {
  if (pslg.attributes_per_point > 0 || *rc::gen::arbitrary<bool>()) return pslg;
  pslg.attributes_per_point = 1;
  for (const Point p : pslg.points) pslg.point_attributes.push_back(p.x * p.x + 0.1 * p.y);
  return pslg;
}

PARDEL_PROPERTY(
    GivenPoints, are_triangulated_as_by_one_process,
    {.statement = "Ranks that each have read a part of the points, and that ask each other about the triangles "
                  "at their borders, make the Delaunay triangulation of one process, also where points are "
                  "cocircular.",
     .source = "properties/THEORY_OF_RANKS.md, GivenPoints",
     .families = point_families}) {
  const Pslg pslg = with_attributes(some_points(exhibit));
  const Meshed whole = value_of(triangulate(pslg, true, {.threads = 1}));
  require_together(whole.mesh, dealt(pslg, *rc::gen::inRange(2, 7)), [](PartOfPoints&& part, pardel::Ranks& ranks) {
    return triangulate(std::move(part), {.threads = 1}, ranks);
  });
}

PARDEL_PROPERTY(
    GivenPoints, are_meshed_as_by_one_process,
    {.statement = "Ranks that each have read a part of the points make the mesh of one process: for bounds on "
                  "angles, areas and edges, on few and on many tiles.",
     .source = "properties/THEORY_OF_RANKS.md, GivenPoints",
     .families = point_families}) {
  const Pslg pslg = with_attributes(some_points(exhibit));
  Goal goal{.min_angle_deg = *rc::gen::element(0.0, 20.0, 26.0)};
  const int bound = *rc::gen::inRange(0, 3);
  const double extent = std::ranges::max(pslg.points, {}, &Point::x).x + 1;
  if (bound == 1) goal.max_area = extent * extent * *rc::gen::element(0.01, 0.001);
  if (bound == 2) goal.max_edge = extent * *rc::gen::element(0.2, 0.05);
  Options options{.threads = 1};
  options.placement = *rc::gen::element(Placement::off_centre, Placement::circumcentre);
  options.triangles_per_tile = *rc::gen::inRange(4U, 80U);
  const Meshed whole = value_of(mesh(pslg, goal, options));
  require_together(whole.mesh, dealt(pslg, *rc::gen::inRange(2, 7)), [&](PartOfPoints&& part, pardel::Ranks& ranks) {
    return mesh({std::move(part)}, goal, options, ranks);
  });
}

/// Adds points of a lattice around the domain that are on no segment.
Pslg with_loose_points(Pslg pslg) {
  const auto [low_x, high_x] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low_y, high_y] = std::ranges::minmax(pslg.points, {}, &Point::y);
  const double step_x = (high_x.x - low_x.x) / 16, step_y = (high_y.y - low_y.y) / 16;
  const Point first{low_x.x - 4 * step_x, low_y.y - 4 * step_y};
  const auto places = *rc::gen::resize(60, rc::gen::container<std::vector<std::pair<int, int>>>(
                                               rc::gen::pair(rc::gen::inRange(0, 25), rc::gen::inRange(0, 25))));
  for (const auto& [x, y] : places) {
    Pslg with_point = pslg;
    with_point.points.push_back({first.x + step_x * x, first.y + step_y * y});
    if (!pslg.point_markers.empty()) with_point.point_markers.push_back(x % 3);
    with_point.point_attributes.resize(with_point.points.size() * pslg.attributes_per_point, 0.1 * x + y);
    if (find_problems(with_point, {.convex_hull = true}).empty()) pslg = std::move(with_point);
  }
  return pslg;
}

PARDEL_PROPERTY(
    GivenPoints, of_domains_with_segments_are_meshed_as_by_one_process,
    {.statement =
         "Ranks that each have read a part of the points and of the segments of a domain, and all its "
         "holes and regions, make the mesh of one process, with points in and around the domain that are on no "
         "segment, and with the attributes of its points.",
     .source = "properties/THEORY_OF_RANKS.md, GivenPoints",
     .families = "lattice domains of every family, half of them with segments in 2, 4 or 8 pieces, with up to 60 "
                 "points on no segment, dealt with the segments to two "
                 "to six ranks; random goals without fields of sizes"}) {
  Problem problem = some_problem(exhibit);
  problem.goal.size = {};
  problem.goal.sources.clear();
  problem.goal.grading = INFINITY;
  problem.goal.feature_edges = 0;
  const Index pieces = *rc::gen::element<Index>(1, 1, 2, 4, 8);
  problem.pslg = with_attributes(with_loose_points(with_segments_in_pieces(std::move(problem.pslg), pieces)));
  exhibit.show(problem.pslg);
  RC_PRE(find_problems(problem.pslg, {.convex_hull = problem.goal.convex_hull}).empty());
  Options options{.threads = 1};
  options.placement = *rc::gen::element(Placement::off_centre, Placement::circumcentre, Placement::search);
  options.decomposition = *rc::gen::element(Decomposition::automatic, Decomposition::none);
  options.triangles_per_tile = *rc::gen::inRange(4U, 80U);
  const Meshed whole = meshed(problem, exhibit, options);
  classify(!problem.pslg.segments.empty(), "with segments", 50);
  classify(pieces > 1 && !problem.pslg.segments.empty(), "with segments in pieces", 20);
  const int count = *rc::gen::inRange(2, 7);
  const std::vector<std::size_t> begin = begins_of_parts(problem.pslg.segments.size(), count);
  require_together(whole.mesh, dealt(problem.pslg, count), [&](PartOfPoints&& part, pardel::Ranks& ranks) {
    PartOfSegments segments = domains::segments_between(problem.pslg, begin[ranks.rank()], begin[ranks.rank() + 1]);
    return mesh({std::move(part), std::move(segments), domains::rest_of(problem.pslg)}, problem.goal, options, ranks);
  });
}

}  // namespace
}  // namespace pardel::properties
