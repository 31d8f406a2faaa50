#include "judgement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "../cli/centroid.hpp"
#include "../cli/domain_of_mesh.hpp"
#include "../properties/checker/check.hpp"
#include "../properties/checker/violating_triangles.hpp"
#include "distances.hpp"

namespace pardel::fuzz {
namespace {

constexpr double no_bound = std::numeric_limits<double>::infinity();

/// The mesher's bounds are stricter than the goal by a small factor, so it may list triangles that just keep a bound.
constexpr double nearly = 1 - 1e-9;

double area_of(const Mesh& mesh, const Triangle& triangle) {
  const Point a = mesh.points[triangle.v[0]], b = mesh.points[triangle.v[1]], c = mesh.points[triangle.v[2]];
  return std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

class Judgement {
 public:
  Judgement(const Meshed& meshed, const Expected& expected)
      : mesh_(meshed.mesh),
        report_(meshed.report),
        expected_(expected),
        certificate_(check(expected.pslg, mesh_, expected.goal,
                           {.max_violations = mesh_.triangles.size() * 4 + 100, .foreign = expected.foreign})),
        reason_of_(mesh_.triangles.size(), not_listed),
        misses_(mesh_.triangles.size(), false) {}

  [[nodiscard]] std::string fault() {
    using Part = std::string (Judgement::*)();
    for (const Part part : {&Judgement::fault_of_list, &Judgement::fault_of_violations, &Judgement::fault_of_justified,
                            &Judgement::fault_of_reasons, &Judgement::fault_of_limits})
      if (std::string fault = (this->*part)(); !fault.empty()) return fault;
    return {};
  }

 private:
  static constexpr int not_listed = -1;

  [[nodiscard]] std::string fault_of_list() {
    for (const Exemption& e : report_.exempt) {
      if (e.triangle >= mesh_.triangles.size()) return "the report lists a triangle that does not exist";
      if (reason_of_[e.triangle] != not_listed) return "the report lists a triangle twice";
      reason_of_[e.triangle] = static_cast<int>(e.reason);
    }
    return {};
  }

  /// The checker finds only missed bounds, of triangles that are listed.
  [[nodiscard]] std::string fault_of_violations() {
    const bool may_miss = expected_.may_miss || report_.count(ExemptReason::budget) > 0;
    for (const Violation& violation : certificate_.violations) {
      if (!may_miss || !is_bound(violation.kind)) return violation.message();
      for (const Index t : violating_triangles(violation, mesh_)) {
        if (reason_of_[t] == not_listed) return "not in the report: " + violation.message();
        if (justified(static_cast<ExemptReason>(reason_of_[t])) && violation.kind == ViolationKind::small_angle)
          return "the report justifies it: " + violation.message();
        misses_[t] = true;
      }
    }
    if (certificate_.valid != certificate_.violations.empty()) return "the verdict contradicts the list of violations";
    if (report_.goal_met() && !certificate_.valid) return "the report says that every bound holds";
    return {};
  }

  /// Small angles that the checker justifies are listed, too.
  [[nodiscard]] std::string fault_of_justified() {
    for (const Justified& found : certificate_.justified) {
      if (reason_of_[found.triangle] == not_listed) return "not in the report: " + text(found.triangle);
      misses_[found.triangle] = true;
    }
    return {};
  }

  [[nodiscard]] std::string fault_of_reasons() {
    const Options& options = expected_.options;
    std::vector<bool> is_justified(mesh_.triangles.size(), false);
    for (const Justified& found : certificate_.justified) is_justified[found.triangle] = true;
    for (const Exemption& e : report_.exempt) {
      const std::string listed = std::string(name(e.reason)) + " " + text(e.triangle);
      if (!misses_[e.triangle] && !nearly_misses(e.triangle)) return "listed, but keeps all bounds: " + listed;
      if (justified(e.reason) && misses_[e.triangle] && !is_justified[e.triangle])
        return "the checker sees no such reason: " + listed;
      if (e.reason == ExemptReason::budget && options.max_vertices == 0) return "there is no limit: " + listed;
      if (e.reason == ExemptReason::budget && mesh_.points.size() < options.max_vertices)
        return "the limit was not reached, with " + std::to_string(mesh_.points.size()) + " of " +
               std::to_string(options.max_vertices) + " vertices: " + listed;
      if (e.reason == ExemptReason::kept_segment && may_split_all_segments(options))
        return "every segment may be split: " + listed;
      if ((e.reason == ExemptReason::min_edge || e.reason == ExemptReason::precision) && least_height() > 3)
        return "no triangle is so narrow that lengths are a reason: " + listed;
    }
    return {};
  }

  /// The shortest edge that is made around a triangle (Options::min_edge).
  [[nodiscard]] double floor_at(const Triangle& triangle) const {
    double floor = std::max(expected_.options.min_edge, 0x1p-129);
    for (const Index v : triangle.v) floor = std::max(floor, resolution(mesh_.points[v]));
    return floor;
  }

  /// The least distance from a corner of a triangle to its opposite side, divided by the shortest edge that is made
  /// there, in the whole mesh.
  [[nodiscard]] double least_height() {
    if (least_height_ == no_bound)
      for (const Triangle& triangle : mesh_.triangles)
        least_height_ =
            std::min(least_height_, 2 * area_of(mesh_, triangle) / sides_of(triangle).back() / floor_at(triangle));
    return least_height_;
  }

  [[nodiscard]] std::string fault_of_limits() {
    const Options& options = expected_.options;
    const std::size_t given = expected_.pslg.points.size(), present = mesh_.points.size();
    if (options.max_vertices > 0 && present > std::max<std::uint64_t>(options.max_vertices, given))
      return "more vertices than allowed: " + std::to_string(present);
    if (report_.laid == 0 && present != given + report_.inserted + report_.segment_splits)
      return "the report counts " + std::to_string(report_.inserted + report_.segment_splits) + " new vertices, not " +
             std::to_string(present - given);
    for (std::size_t v = given; options.no_segment_splits && v < mesh_.origin.size(); ++v)
      if (mesh_.origin[v] != interior_vertex) return "a segment was split at vertex " + std::to_string(v);
    for (const ConstrainedEdge& e : mesh_.constrained_edges)
      if (std::ranges::find(options.kept_markers, e.marker) != options.kept_markers.end() &&
          std::max(e.a, e.b) >= given)
        return "a segment with the kept marker " + std::to_string(e.marker) + " was split at vertex " +
               std::to_string(std::max(e.a, e.b));
    for (const Triangle& triangle : mesh_.triangles)
      for (int k = 0; k < 3; ++k) {
        const Index a = triangle.v[k], b = triangle.v[(k + 1) % 3];
        if (a < given && b < given) continue;
        if (distance(mesh_.points[a], mesh_.points[b]) < options.min_edge * nearly)
          return "an edge is shorter than allowed: " + std::to_string(a) + " to " + std::to_string(b);
      }
    return {};
  }

  [[nodiscard]] static bool is_bound(ViolationKind kind) {
    return kind == ViolationKind::small_angle || kind == ViolationKind::large_area ||
           kind == ViolationKind::region_area || kind == ViolationKind::long_edge ||
           kind == ViolationKind::size_exceeded || kind == ViolationKind::user_test ||
           kind == ViolationKind::not_conforming;
  }

  /// The lengths of the sides, ascending.
  [[nodiscard]] std::array<double, 3> sides_of(const Triangle& triangle) const {
    const Point a = mesh_.points[triangle.v[0]], b = mesh_.points[triangle.v[1]], c = mesh_.points[triangle.v[2]];
    std::array<double, 3> sides{distance(a, b), distance(b, c), distance(c, a)};
    std::ranges::sort(sides);
    return sides;
  }

  /// True if the triangle misses a bound, or keeps one by less than rounding.
  [[nodiscard]] bool nearly_misses(Index t) const {
    if (expected_.has_other_caps) return true;
    const Goal& goal = expected_.goal;
    const std::array<double, 3> sides = sides_of(mesh_.triangles[t]);
    const double area = area_of(mesh_, mesh_.triangles[t]);
    if (2 * area * nearly < std::sin(goal.min_angle_deg * std::numbers::pi / 180) * sides[1] * sides[2]) return true;
    if (area > goal.max_area * nearly || sides[2] > goal.max_edge * nearly) return true;
    if (expected_.longest_edge && sides[2] > least_longest_edge_near(cli::centroid(mesh_, mesh_.triangles[t])) * nearly)
      return true;
    if (!goal.region_caps || mesh_.region.empty() || mesh_.region[t] >= expected_.pslg.regions.size()) return false;
    return area > expected_.pslg.regions[mesh_.region[t]].max_area * nearly;
  }

  /// The least of the longest edges at a place and at the doubles beside it. The mesher may round a centroid to another
  /// of these; far from the origin they are so far apart that the longest edges differ.
  [[nodiscard]] double least_longest_edge_near(Point place) const {
    double least = no_bound;
    for (const double x : {std::nextafter(place.x, -no_bound), place.x, std::nextafter(place.x, no_bound)})
      for (const double y : {std::nextafter(place.y, -no_bound), place.y, std::nextafter(place.y, no_bound)})
        least = std::min(least, expected_.longest_edge({x, y}));
    return least;
  }

  [[nodiscard]] std::string text(Index t) const {
    char corners[200];
    const auto& v = mesh_.triangles[t].v;
    const Point a = mesh_.points[v[0]], b = mesh_.points[v[1]], c = mesh_.points[v[2]];
    std::snprintf(corners, sizeof corners, "triangle %u, (%.17g, %.17g) (%.17g, %.17g) (%.17g, %.17g)", t, a.x, a.y,
                  b.x, b.y, c.x, c.y);
    return corners;
  }

  const Mesh& mesh_;
  const Report& report_;
  const Expected& expected_;
  Certificate certificate_;
  std::vector<int> reason_of_;  ///< per triangle: why the report lists it
  std::vector<bool> misses_;    ///< per triangle: the checker finds that it misses a bound
  double least_height_ = no_bound;
};

/// What a file does not say about a mesh: from which part of the input its vertices and edges come.
void forget_origins(Mesh& mesh) {
  mesh.origin.clear();
  for (ConstrainedEdge& edge : mesh.constrained_edges) edge.segment = no_index;
}

/// For every second triangle two thirds of its area.
std::vector<double> caps_of(const Mesh& mesh) {
  std::vector<double> caps(mesh.triangles.size(), no_bound);
  for (std::size_t t = 0; t < caps.size(); t += 2) {
    const double cap = area_of(mesh, mesh.triangles[t]) * 2 / 3;
    if (cap > 0) caps[t] = cap;
  }
  return caps;
}

/// To the left of the line through a and b, or to its right by less than the rounding of p.
bool is_hardly_right_of(Point a, Point b, Point p) {
  const double size = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(p.x - a.x), std::abs(p.y - a.y)});
  const double rounding = 1e-9 * size + 0x1p-50 * std::max(std::abs(p.x), std::abs(p.y));
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= -rounding * size;
}

/// The largest cap of the triangles that contain a place, within rounding.
double cap_at(const Mesh& mesh, const std::vector<double>& caps, Point p) {
  double largest = 0;
  for (std::size_t t = 0; t < caps.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
    if (is_hardly_right_of(a, b, p) && is_hardly_right_of(b, c, p) && is_hardly_right_of(c, a, p))
      largest = std::max(largest, caps[t]);
  }
  return largest;
}

/// A triangle that is larger than the cap of the triangle of the coarse mesh in which it lies has to be listed.
std::string fault_of_caps(const Meshed& refined, const Mesh& coarse, const std::vector<double>& caps) {
  std::vector<bool> is_listed(refined.mesh.triangles.size(), false);
  for (const Exemption& e : refined.report.exempt) is_listed[e.triangle] = true;
  for (std::size_t t = 0; t < is_listed.size(); ++t) {
    const Triangle& triangle = refined.mesh.triangles[t];
    if (!is_listed[t] &&
        area_of(refined.mesh, triangle) * nearly > cap_at(coarse, caps, cli::centroid(refined.mesh, triangle)))
      return "triangle " + std::to_string(t) + " is larger than the cap of the triangle in which it lies";
  }
  return {};
}

}  // namespace

std::string fault_of(const Meshed& meshed, const Expected& expected) { return Judgement(meshed, expected).fault(); }

std::string fault_of_refining(Mesh coarse, const Goal& goal, const Options& options, bool may_miss) {
  forget_origins(coarse);
  const Result<Pslg> domain = cli::domain_of(coarse);
  if (!domain) return "a mesh without a domain: " + domain.error().message;
  Goal again = goal;
  again.region_caps = again.convex_hull = false;
  again.grading = Goal{}.grading;
  again.sources.clear();
  again.feature_edges = 0;
  Options limited = options;
  limited.max_vertices = coarse.points.size() + 300;
  const std::vector<double> caps = caps_of(coarse);
  Result<Meshed> refined = refine(coarse, caps, again, limited);
  if (!refined) return "a valid mesh was rejected: " + refined.error().message;
  forget_origins(refined->mesh);
  std::string fault = fault_of(*refined, {.pslg = *domain,
                                          .goal = again,
                                          .options = limited,
                                          .may_miss = may_miss,
                                          .foreign = true,
                                          .has_other_caps = true});
  if (fault.empty()) fault = fault_of_caps(*refined, coarse, caps);
  return fault.empty() ? fault : "refined again: " + fault;
}

}  // namespace pardel::fuzz
