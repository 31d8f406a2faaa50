#include "generated_case.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "../../parallel/mesher.hpp"
#include "../../parallel/repair.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/domains/generators/goals.hpp"
#include "../../properties/domains/generators/mixed_scales.hpp"
#include "../distances.hpp"
#include "../doubles.hpp"
#include "../numbered_random.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// Draws the parts of a case one after another, each with a probability of its own.
class Drawing {
 public:
  Drawing(GeneratedCase& drawn, Random& random) : drawn_(drawn), random_(random) {}

  void draw() {
    const generators::LatticeDomain domain =
        generators::any_domain(random_, random_.between(0, random_.chance(4) ? 100 : 40));
    note(generators::name(domain.family));
    drawn_.pslg = to_pslg(domain);
    drawn_.goal = to_goal(generators::any_goal(domain, random_), domain);
    const auto [left, right] = std::ranges::minmax(drawn_.pslg.points, {}, &Point::x);
    const auto [low, high] = std::ranges::minmax(drawn_.pslg.points, {}, &Point::y);
    extent_ = std::max(right.x - left.x, high.y - low.y);
    if (random_.chance(3))
      mix();
    else if (random_.chance(3))
      turn();
    goal();
    lengths();
    options();
    limits();
    repetitions();
    kept_markers();
  }

 private:
  void note(std::string kind) { drawn_.kinds.push_back(std::move(kind)); }

  /// Mixes scales. The other component, if there is one, is a copy or another domain.
  void mix() {
    Pslg other = drawn_.pslg;
    if (random_.chance(2)) other = to_pslg(generators::any_domain(random_, random_.between(0, 20)));
    generators::Mixed mixed = mixed_scales(drawn_.pslg, other, random_, random_.chance(6));
    if (mixed.what.empty()) return;
    note("mixed_scales");
    for (const generators::Mixture mixture : mixed.what) note(generators::name(mixture));
    drawn_.pslg = std::move(mixed.pslg);
    drawn_.mixtures = std::move(mixed.what);
    drawn_.parts = std::move(mixed.parts);
    drawn_.is_tiny = mixed.is_tiny;
    enlarged_ = mixed.enlarges;
    if (enlarged_) drawn_.goal.max_area = no_bound;
  }

  /// Turns the domain around one of its points, and moves it in one of two cases. Its coordinates are then rounded:
  /// lines and circles of points become nearly straight and nearly round. The domain is repaired if this makes it
  /// invalid.
  void turn() {
    const double angle = random_.uniform(0, 2 * std::numbers::pi), cosine = std::cos(angle), sine = std::sin(angle);
    const Point centre = drawn_.pslg.points.front();
    const int farthest = random_.chance(2) ? 0 : random_.between(1, 44);
    const double shift = farthest == 0 ? 0 : extent_ * std::exp2(farthest);
    const auto turned = [&](Point p) {
      const double x = p.x - centre.x, y = p.y - centre.y;
      return Point{shift + cosine * x - sine * y, shift / 3 + sine * x + cosine * y};
    };
    Pslg pslg = drawn_.pslg;
    const bool nudges = random_.chance(3);
    for (Point& p : pslg.points) {
      p = turned(p);
      if (nudges && random_.chance(4)) p = nudged(p);
    }
    for (Point& p : pslg.holes) p = turned(p);
    for (Region& region : pslg.regions) region.seed = turned(region.seed);
    if (!find_problems(pslg, {.threads = 1}).empty()) {
      Result<Repaired> repaired = repair(pslg, {.snap = 0});
      if (!repaired) return;
      pslg = std::move(repaired->domain).pslg();
      note("repaired");
    }
    drawn_.pslg = std::move(pslg);
    drawn_.turned = true;
    drawn_.far_off = farthest > 10 || nudges;
    note(farthest > 10 ? "far" : "turned");
    if (nudges) note("nudged");
  }

  /// The point, moved by up to three units in the last place.
  [[nodiscard]] Point nudged(Point p) {
    const double x = moved(p.x, random_.between(-3, 3));
    return {x, moved(p.y, random_.between(-3, 3))};
  }

  void goal() {
    Goal& goal = drawn_.goal;
    // Above 30 degrees, refinement need not end by itself, so it gets a limit.
    if (random_.chance(8)) {
      goal.min_angle_deg = random_.one_of<double>({30, 31, 33, 36, 45});
      limit_vertices(600);
    }
    note("angle" + std::to_string(static_cast<int>(goal.min_angle_deg)));
    if (random_.chance(6) && !enlarged_) {
      goal.max_edge = extent_ / random_.between(2, 12);
      note("edge");
    }
    // Between far points and a domain, the hull can be a needle, which has too many triangles.
    if (random_.chance(16) && drawn_.parts.empty()) {
      goal.convex_hull = true;
      note("hull");
    }
    if (goal.max_area < no_bound) note("area");
    if (goal.region_caps && std::ranges::any_of(drawn_.pslg.regions, [](auto& r) { return r.max_area < no_bound; }))
      note("caps");
    if (goal.conforming) note("conforming");
  }

  /// Lengths that depend on the place. Their meshes can be large, so they get a limit.
  void lengths() {
    Goal& goal = drawn_.goal;
    if (random_.chance(6) && drawn_.parts.empty()) {
      field();
      note("field");
    }
    if (random_.chance(8)) {
      goal.grading = random_.one_of<double>({0.05, 0.2, 0.5, 1, 2});
      note("grading");
      limit_vertices(1'000);
    }
    if (random_.chance(8)) {
      goal.feature_edges = random_.one_of<double>({0.3, 1, 2, 4});
      note("features");
      limit_vertices(1'000);
    }
  }

  void field() {
    Goal& goal = drawn_.goal;
    const double least = extent_ / random_.between(4, 40);
    const Point centre = random_.one_of(drawn_.pslg.points);
    limit_vertices(1'000);
    switch (random_.below(4)) {
      case 0:
        goal.size = [=](Point p) { return p.x < centre.x ? least : 3 * least; };
        return;
      case 1: {
        std::vector<double> sizes;
        for (std::size_t i = 0; i < drawn_.pslg.points.size(); ++i)
          sizes.push_back(least * std::exp2(random_.uniform(0, 3)));
        if (auto size = interpolated_size(drawn_.pslg, sizes, goal.convex_hull, {.threads = 1})) goal.size = *size;
        if (!random_.chance(2)) return;
        goal.grading = random_.one_of<double>({0.1, 0.5});
        note("grading");
        if (const auto domain = validate(drawn_.pslg, {.convex_hull = goal.convex_hull}))
          if (auto sources = size_sources(*domain, sizes, goal.grading, {.threads = 1})) goal.sources = *sources;
        return;
      }
      default:
        const double slope = random_.one_of<double>({0.05, 0.3, 1});
        goal.size = [=](Point p) { return least + slope * std::hypot(p.x - centre.x, p.y - centre.y); };
        if (slope <= 0.3 && random_.chance(2)) goal.size_slope = slope;
    }
  }

  void options() {
    Options& options = drawn_.options;
    options.placement = random_.one_of<Placement>(
        {Placement::off_centre, Placement::automatic, Placement::search, Placement::circumcentre});
    if (options.placement == Placement::search) note("search");
    const auto decomposition = random_.below(6);
    options.decomposition =
        std::vector{Decomposition::automatic,      Decomposition::lattice, Decomposition::quadtree,
                    Decomposition::paper_quadtree, Decomposition::paper,   Decomposition::none}[decomposition];
    note(std::vector{"automatic", "lattice", "quadtree", "paper_quadtree", "paper", "one_tile"}[decomposition]);
    options.triangles_per_tile = random_.one_of<std::uint32_t>({8'000, 80, 20, 4});
    if (random_.chance(8)) {
      options.cells = {static_cast<Index>(random_.between(1, 9)), static_cast<Index>(random_.between(1, 9))};
      note("cells");
    }
    options.interior = random_.one_of<Interior>({Interior::refine, Interior::automatic, Interior::fill});
    if (options.interior != Interior::refine) note("fill");
    options.threads = random_.chance(2) ? 1 : random_.between(2, 3);
    note("threads" + std::to_string(options.threads));
  }

  void limits() {
    Options& options = drawn_.options;
    if (random_.chance(10)) {
      options.min_edge = extent_ * std::exp2(-random_.between(3, 9));
      note("floor");
    }
    if (random_.chance(16)) options.no_boundary_splits = true;
    if (random_.chance(16)) options.no_segment_splits = true;
    if (options.no_boundary_splits || options.no_segment_splits) {
      drawn_.goal.conforming = false;  // a mesh whose segments may not be split is not conforming in general
      note("kept_segments");
    }
    if (random_.chance(10)) limit_vertices(static_cast<std::uint64_t>(random_.between(0, 200)));
    if (drawn_.has_gaps_of_rounding()) limit_vertices(1'000);
    if (options.max_vertices > 0) note("limit");
  }

  /// Keeps the segments of one or two markers: of the first segment, and of unmarked segments on the boundary.
  void kept_markers() {
    if (!random_.chance(12)) return;
    std::vector<int>& kept = drawn_.options.kept_markers;
    if (!drawn_.pslg.segments.empty()) kept.push_back(drawn_.pslg.segments.front().marker);
    if (kept.empty() || random_.chance(3)) kept.push_back(1);
    drawn_.goal.conforming = false;
    note("kept_markers");
  }

  void repetitions() {
    if (random_.chance(8)) {
      drawn_.refine_again = true;
      note("refined_again");
    }
    // Ranks have no limit on vertices.
    if (drawn_.options.max_vertices > 0 || !random_.chance(3)) return;
    drawn_.ranks = random_.between(1, 4);
    drawn_.delays = random_.chance(8);
    note("ranks" + std::to_string(drawn_.ranks));
  }

  /// At most this many vertices more than the domain has.
  void limit_vertices(std::uint64_t more) {
    const std::uint64_t most = drawn_.pslg.points.size() + more;
    std::uint64_t& limit = drawn_.options.max_vertices;
    limit = limit == 0 ? most : std::min(limit, most);
  }

  GeneratedCase& drawn_;
  Random& random_;
  double extent_ = 1;      ///< the longer side of the bounding box
  bool enlarged_ = false;  ///< by a mixture of scales
};

/// Of two segments that meet at less than 60 degrees: how far apart their points are that lie as far from the common
/// point as the other end of the shorter one, divided by the shortest edge that the mesher makes there. Infinite for
/// other segments.
double gap_between(const Pslg& pslg, const Segment& s, const Segment& t) {
  for (const auto& [from, to_s] : {std::pair(s.a, s.b), std::pair(s.b, s.a)})
    for (const auto& [also_from, to_t] : {std::pair(t.a, t.b), std::pair(t.b, t.a)}) {
      if (from != also_from) continue;
      const Point p = pslg.points[from], q = pslg.points[to_s], r = pslg.points[to_t];
      const double of_s = distance(p, q), of_t = distance(p, r);
      const double cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      const double dot = (q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y);
      if (dot > 0.5 * of_s * of_t)
        return std::abs(cross) / std::max(of_s, of_t) / std::max({resolution(p), resolution(q), resolution(r)});
    }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

bool GeneratedCase::has_gaps_of_rounding() const {
  return far_off || (turned && (goal.convex_hull || pslg.segments.empty()));
}

bool GeneratedCase::has_angles_of_rounding() const {
  constexpr double share = 64;  // pieces of segments are rarely shorter than this part of the segments
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pslg.segments.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) gap = std::min(gap, gap_between(pslg, pslg.segments[i], pslg.segments[j]));
  return gap < share;
}

bool GeneratedCase::may_miss() const {
  return has_gaps_of_rounding() || has_angles_of_rounding() || is_tiny || options.min_edge > 0 ||
         !may_split_all_segments(options) || goal.min_angle_deg > 30;
}

GeneratedCase generated_case(std::uint64_t seed, std::uint64_t number) {
  Random random = random_of(seed, number);
  GeneratedCase drawn;
  Drawing(drawn, random).draw();
  return drawn;
}

}  // namespace pardel::fuzz
