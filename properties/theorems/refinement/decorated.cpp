#include "decorated.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

#include "../../../core/raster.hpp"
#include "../../../core/support/enum_names.hpp"
#include "../../../parallel/sizes.hpp"
#include "../../../parallel/validate.hpp"
#include "../../checker/violating_triangles.hpp"

namespace pardel::properties {
namespace {

using generators::Random;

constexpr auto wish_names = enum_names<Wish>({
    {Wish::area, "area"},
    {Wish::edge, "edge"},
    {Wish::caps_of_regions, "caps_of_regions"},
    {Wish::field, "field"},
    {Wish::lengths_at_points, "lengths_at_points"},
    {Wish::growth, "growth"},
    {Wish::sources, "sources"},
    {Wish::raster, "raster"},
    {Wish::lengths_in_regions, "lengths_in_regions"},
    {Wish::narrow_places, "narrow_places"},
    {Wish::conforming, "conforming"},
    {Wish::hull, "hull"},
    {Wish::fill, "fill"},
    {Wish::floor, "floor"},
    {Wish::kept_markers, "kept_markers"},
    {Wish::kept_boundary, "kept_boundary"},
    {Wish::quadtree, "quadtree"},
    {Wish::small_tiles, "small_tiles"},
    {Wish::circumcentres, "circumcentres"},
});
static_assert(wish_names.size() == Wishes{}.on.size());

constexpr auto way_names = enum_names<Way>({
    {Way::repaired, "repaired"},
    {Way::in_pieces, "in_pieces"},
    {Way::second_order, "second_order"},
    {Way::refined, "refined"},
});
static_assert(way_names.size() == Ways{}.on.size());

/// Makes the goal and the options of a case. Every wish has random numbers of its own, so that it stays the same
/// when others are switched off.
class ProblemMaker {
 public:
  explicit ProblemMaker(const DecoratedCase& c)
      : wishes_(c.wishes), made_{to_problem(c.plain), {.threads = 1}, c.wishes, c.ways}, extent_(extent_of(pslg())) {}

  DecoratedProblem make() {
    bounds();
    lengths();
    options();
    if (!may_split_all_segments(made_.options)) goal().conforming = false;
    return std::move(made_);
  }

 private:
  Pslg& pslg() { return made_.problem.pslg; }
  Goal& goal() { return made_.problem.goal; }
  [[nodiscard]] bool has(Wish wish) const { return wishes_.has(wish); }
  [[nodiscard]] Random random_of(Wish wish) const { return Random(wishes_.seed + static_cast<std::uint64_t>(wish)); }
  [[nodiscard]] double some_length(Random& random) const { return extent_ / random.between(3, 24); }

  void bounds() {
    Random of_area = random_of(Wish::area), of_edge = random_of(Wish::edge);
    const double length = some_length(of_area);
    goal().max_area = has(Wish::area) ? length * length : std::numeric_limits<double>::infinity();
    if (has(Wish::edge)) goal().max_edge = some_length(of_edge);
    goal().region_caps = has(Wish::caps_of_regions);
    Random of_caps = random_of(Wish::caps_of_regions);
    if (goal().region_caps)
      for (Region& region : pslg().regions)
        if (!of_caps.chance(4)) region.max_area = length * length * std::ldexp(1, of_caps.between(-3, 2));
    goal().conforming = has(Wish::conforming);
    goal().convex_hull = has(Wish::hull);
  }

  void lengths() {
    if (has(Wish::field)) add_size(field());
    if (has(Wish::lengths_at_points)) add_size(between_points());
    if (has(Wish::raster)) add_size(on_grid());
    Random of_growth = random_of(Wish::growth);
    if (has(Wish::growth) || has(Wish::sources)) goal().grading = of_growth.one_of<double>({0.2, 0.5, 1});
    if (has(Wish::sources)) goal().sources = sources();
    if (has(Wish::lengths_in_regions)) add_lengths_in_regions();
    Random of_places = random_of(Wish::narrow_places);
    if (has(Wish::narrow_places)) goal().feature_edges = of_places.one_of<double>({0.5, 1, 2});
  }

  /// The lesser of two fields is the wanted length.
  void add_size(std::function<double(Point)> size) {
    if (goal().size)
      size = [one = goal().size, other = std::move(size)](Point p) { return std::min(one(p), other(p)); };
    goal().size = std::move(size);
  }
  std::function<double(Point)> field() {
    Random random = random_of(Wish::field);
    const Point centre = random.one_of(pslg().points);
    const double least = some_length(random), slope = random.one_of<double>({0.1, 0.5, 2});
    return [=](Point p) { return least + slope * std::hypot(p.x - centre.x, p.y - centre.y); };
  }
  std::function<double(Point)> between_points() {
    Random random = random_of(Wish::lengths_at_points);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < pslg().points.size(); ++i) lengths.push_back(some_length(random));
    Result<std::function<double(Point)>> size = interpolated_size(pslg(), lengths, goal().convex_hull, {.threads = 1});
    if (!size) RC_FAIL(size.error().message);
    return std::move(size).value();
  }
  std::function<double(Point)> on_grid() {
    Random random = random_of(Wish::raster);
    const auto [left, right] = std::ranges::minmax(pslg().points, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(pslg().points, {}, &Point::y);
    Raster raster;
    raster.columns = static_cast<Index>(random.between(1, 4));
    raster.rows = static_cast<Index>(random.between(1, 4));
    const double width = 1.25 * extent_;  // beyond the domain, whatever is rounded
    raster.step_x = width / raster.columns;
    raster.step_y = width / raster.rows;
    raster.first = {left.x + raster.step_x / 2 - extent_ / 8, low.y + raster.step_y / 2 - extent_ / 8};
    for (Index i = 0; i < raster.columns * raster.rows; ++i) raster.values.push_back(some_length(random));
    Result<std::function<double(Point)>> size = interpolated_size(std::move(raster));
    if (!size) RC_FAIL(size.error().message);
    return std::move(size).value();
  }
  void add_lengths_in_regions() {
    Random random = random_of(Wish::lengths_in_regions);
    std::vector<double> lengths;
    for (std::size_t i = 0; i < pslg().regions.size(); ++i)
      lengths.push_back(random.chance(3) ? std::numeric_limits<double>::infinity() : some_length(random));
    const auto domain = validate(pslg(), {.convex_hull = goal().convex_hull});
    if (!domain) RC_FAIL(domain.error().front().message());
    Result<RegionSizes> sizes = region_sizes(*domain, lengths, {.threads = 1});
    if (!sizes) RC_FAIL(sizes.error().message);
    if (!sizes->size) return;  // no region
    add_size(sizes->size);
    goal().sources.insert(goal().sources.end(), sizes->borders.begin(), sizes->borders.end());
  }
  std::vector<SizeSource> sources() {
    Random random = random_of(Wish::sources);
    const Point p = random.one_of(pslg().points);
    const double at_point = some_length(random), on_segment = some_length(random);
    std::vector<SizeSource> result{{p, p, at_point, at_point}};
    if (pslg().segments.empty()) return result;
    const Segment s = random.one_of(pslg().segments);
    result.push_back({pslg().points[s.a], pslg().points[s.b], on_segment, on_segment});
    return result;
  }

  void options() {
    Options& options = made_.options;
    if (has(Wish::fill)) options.interior = Interior::fill;
    Random of_floor = random_of(Wish::floor), of_markers = random_of(Wish::kept_markers);
    if (has(Wish::floor)) options.min_edge = extent_ * std::ldexp(1, -of_floor.between(3, 8));
    if (has(Wish::kept_markers))
      options.kept_markers = {pslg().segments.empty() ? 1 : of_markers.one_of(pslg().segments).marker};
    options.no_boundary_splits = has(Wish::kept_boundary);
    if (has(Wish::quadtree)) options.decomposition = Decomposition::quadtree;
    if (has(Wish::small_tiles)) options.triangles_per_tile = 10;
    if (has(Wish::circumcentres)) options.placement = Placement::circumcentre;
  }

  const Wishes wishes_;
  DecoratedProblem made_;
  double extent_;
};

std::vector<DecoratedCase> simpler_cases(const DecoratedCase& c) {
  std::vector<DecoratedCase> simpler;
  for (const Wishes& fewer : shrinks(c.wishes)) simpler.push_back({c.plain, fewer, c.ways});
  for (const Ways& fewer : shrinks(c.ways)) simpler.push_back({c.plain, c.wishes, fewer});
  for (generators::Case& plain : generators::shrinks(c.plain)) simpler.push_back({std::move(plain), c.wishes, c.ways});
  return simpler;
}

/// The shortest edge that is made at a point (Options::min_edge).
double floor_at(Point p, const Options& options) {
  return std::max({options.min_edge, 0x1p-129, 0x1p-42 * std::max(std::abs(p.x), std::abs(p.y))});
}

/// True if a triangle is about as narrow as the edges that are made there: only then lengths are a reason.
bool has_narrow_triangle(const Mesh& mesh, const Options& options) {
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& triangle) {
    const Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
    const double doubled_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double longest = std::max(
        {std::hypot(b.x - a.x, b.y - a.y), std::hypot(c.x - b.x, c.y - b.y), std::hypot(a.x - c.x, a.y - c.y)});
    const double floor = std::max({floor_at(a, options), floor_at(b, options), floor_at(c, options)});
    return doubled_area <= 3 * floor * longest;
  });
}

/// True if a triangle that is listed for this reason may miss a bound. The checker accepts small angles beside small
/// angles of the domain, so those that it finds have another reason.
bool excuses_a_violation(ExemptReason reason, const Mesh& mesh, const Options& options) {
  switch (reason) {
    case ExemptReason::nestled:
    case ExemptReason::seditious:
      return false;
    case ExemptReason::budget:
      return options.max_vertices > 0;
    case ExemptReason::kept_segment:
      return !may_split_all_segments(options);
    case ExemptReason::min_edge:
    case ExemptReason::precision:
      return has_narrow_triangle(mesh, options);
  }
  return false;
}

}  // namespace

const char* name(Wish wish) { return wish_names[wish]; }
const char* name(Way way) { return way_names[way]; }

DecoratedCase any_decorated_case(Random& random, int size) {
  DecoratedCase drawn{generators::any_case(random, size / 2), {}, {}};
  drawn.wishes = generators::any_switches<Wishes>(random);
  drawn.ways = generators::any_switches<Ways>(random);
  // Interiors are filled only where bounds are the same everywhere.
  if (drawn.wishes.has(Wish::fill) && random.chance(2))
    for (const Wish wish : {Wish::field, Wish::lengths_at_points, Wish::growth, Wish::sources, Wish::raster,
                            Wish::lengths_in_regions, Wish::narrow_places})
      drawn.wishes.on.reset(static_cast<std::size_t>(wish));
  return drawn;
}

std::ostream& operator<<(std::ostream& out, const DecoratedCase& c) {
  return out << c.plain << "; " << to_string(c.wishes) << "; " << to_string(c.ways);
}

DecoratedProblem some_decorated_problem(Exhibit& exhibit) {
  const DecoratedCase c = *generators::generator(any_decorated_case, simpler_cases);
  RC_TAG(std::string(generators::name(c.plain.domain.family)));
  exhibit.show(to_pslg(c.plain.domain));
  return ProblemMaker(c).make();
}

void require_kept_segments(const DecoratedProblem& drawn, const Meshed& meshed) {
  const std::vector<Segment>& segments = drawn.problem.pslg.segments;
  const std::vector<int>& kept = drawn.options.kept_markers;
  std::vector<int> edges(segments.size(), 0);
  for (const ConstrainedEdge& e : meshed.mesh.constrained_edges)
    if (e.segment != no_index) ++edges[e.segment];
  for (std::size_t s = 0; s < edges.size(); ++s)  // a segment without a marker has the marker 1 on the boundary
    if (segments[s].marker != 0 && std::ranges::find(kept, segments[s].marker) != kept.end()) RC_ASSERT(edges[s] <= 1);
}

void require_certified(const DecoratedProblem& drawn, const Meshed& meshed, bool hairlines_outside) {
  const auto& [pslg, goal] = drawn.problem;
  require_valid(check(pslg, meshed.mesh, {.min_angle_deg = 0, .convex_hull = goal.convex_hull}));
  std::map<Index, ExemptReason> listed;
  for (const Exemption& e : meshed.report.exempt) listed.emplace(e.triangle, e.reason);
  const auto is_excused = [&](Index t) {
    if (!listed.contains(t)) return false;
    const bool is_hairline = hairlines_outside && listed[t] == ExemptReason::precision;
    return is_hairline || excuses_a_violation(listed[t], meshed.mesh, drawn.options);
  };
  for (const Violation& violation :
       check(pslg, meshed.mesh, goal, {.max_violations = std::numeric_limits<std::size_t>::max()}).violations)
    if (!std::ranges::all_of(violating_triangles(violation, meshed.mesh), is_excused)) RC_FAIL(violation.message());
}

}  // namespace pardel::properties
