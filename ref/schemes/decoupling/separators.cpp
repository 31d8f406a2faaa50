#include "separators.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "../mesh/extent.hpp"
#include "../mesh/predicates.hpp"
#include "../mesh/triangle.hpp"
#include "../mesh/triangulation.hpp"
#include "../rules/ruppert.hpp"

namespace pardel::schemes::decoupled {
namespace {

using Line = Territory::Line;

Point on(const Line& line, double at) { return line.in_x ? Point{line.at, at} : Point{at, line.at}; }
double along(const Line& line, Point p) { return line.in_x ? p.y : p.x; }
double across_line(const Line& line, Point p) { return (line.in_x ? p.x : p.y) - line.at; }
/// Where the line crosses the segment pq, rounded once: a point that is rounded more often may lie too far off the
/// segment. Precondition: p and q lie on different sides of the line.
double crossing(const Line& line, Point p, Point q) {
  const CGAL::Gmpq from = along(line, p), to = along(line, q), place = line.at;
  const CGAL::Gmpq begin = line.in_x ? p.x : p.y, end = line.in_x ? q.x : q.y;
  return CGAL::to_double(from + (place - begin) * (to - from) / (end - begin));
}
double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// A vertex of a separator is not nearer to others than this share of an edge there. Refinement would have to grade its
/// triangles down to that distance: for ever, if it is as small as rounding.
constexpr double nearest = 0x1p-10;
/// Without a wanted size, the mesh may be much finer in the middle of a line than elsewhere. Then there is a gap: the
/// line has at most as many pieces between two stops as there are triangles, and these.
constexpr std::size_t pieces_of_any_line = 100;

class Layer {
 public:
  Layer(LinkedMesh& mesh, const Bounds& bounds, double length, std::size_t most_points)
      : mesh_(mesh),
        bounds_(bounds),
        length_(length),
        most_points_(most_points),
        most_unsized_(mesh.faces.size() + pieces_of_any_line) {}

  /// Inserts vertices where the line crosses segments. All lines do so before any is laid: shorter sides are encroached
  /// upon by fewer points.
  void cross(const Line& line) { crossings_.push_back(crossings(line)); }

  /// Lays the k-th of the lines.
  void lay(const std::vector<Line>& lines, std::size_t k) {
    const Line& line = lines[k];
    // Where the line is divided in any case: its ends, crossings with other lines, and crossings with segments.
    std::map<double, Index> stops;
    for (const Line& other : lines)
      if (other.in_x != line.in_x && other.at >= line.low && other.at <= line.high && line.at >= other.low &&
          line.at <= other.high)
        stops.emplace(other.at, no_index);
    stops.emplace(line.low, no_index);
    stops.emplace(line.high, no_index);
    for (auto& [at, vertex] : stops) vertex = inserted(on(line, at), 0);
    for (const auto& [at, vertex] : crossings_[k]) stops.insert_or_assign(at, vertex);
    for (auto here = stops.begin(), next = std::next(here); next != stops.end(); ++here, ++next)
      lay(line, *here, *next);
  }

  /// Makes pieces segments.
  Laid finish() {
    Laid laid{static_cast<Index>(mesh_.segments.size()), 0, gaps_, work_};
    std::map<std::array<Index, 2>, bool> wanted;
    for (const auto& piece : pieces_) wanted.emplace(piece, true);
    laid.gaps += wanted.size();
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      for (int i = 0; mesh_.in_use(t) && i < 3; ++i) {
        const auto [a, b] = ends(mesh_, {t, i});
        if (a > b || !wanted.contains({a, b}) || is_constrained(mesh_, {t, i})) continue;
        if (mesh_.faces[t].n[i] == no_index) continue;
        const Side twin = across(mesh_, {t, i});
        const Point p = mesh_.points[a], q = mesh_.points[b];
        if (encroaches(mesh_.corner(t, i), p, q) || encroaches(mesh_.corner(twin.triangle, twin.i), p, q)) continue;
        mesh_.faces[t].segment[i] = mesh_.faces[twin.triangle].segment[twin.i] =
            static_cast<Index>(mesh_.segments.size());
        mesh_.segments.push_back({a, b});
        ++laid.pieces;
        --laid.gaps;
      }
    return laid;
  }

 private:
  /// The triangle that contains p: a walk from the last one, or a search where the walk leaves the domain.
  Index triangle_at(Point p) {
    if (last_ >= mesh_.faces.size() || !mesh_.in_use(last_)) last_ = 0;
    Index t = last_;
    for (std::size_t steps = 0; t != no_index && steps < 100 + mesh_.faces.size() / 16; ++steps, ++work_) {
      int leave = -1;
      for (int i = 0; i < 3 && leave < 0; ++i) {
        const auto [a, b] = ends(mesh_, {t, i});
        if (orientation(mesh_.points[a], mesh_.points[b], p) < 0) leave = i;
      }
      if (leave < 0) return last_ = t;
      t = mesh_.faces[t].n[leave];
    }
    work_ += mesh_.faces.size();
    t = triangle_around(mesh_, p);
    if (t != no_index) last_ = t;
    return t;
  }

  /// Inserts p. Returns its vertex, or no_index if it would be too close to something. `least`: the least distance from
  /// other vertices, half the length of a piece. A vertex at p is returned as it is. As in Ruppert's algorithm,
  /// segments upon which p encroaches are split first, unless they are already as short as a piece.
  Index inserted(Point p, double least) {
    for (;;) {
      const Index t = triangle_at(p);
      if (t == no_index) return no_index;
      Insertion found{t, p, {}, {}};
      std::vector<Index> starts = {t};
      for (int i = 0; i < 3; ++i) {
        if (mesh_.corner(t, i) == p) return mesh_.faces[t].v[i];
        const auto [a, b] = ends(mesh_, {t, i});
        if (orientation(mesh_.points[a], mesh_.points[b], p) != 0) continue;
        if (is_constrained(mesh_, {t, i})) return no_index;
        starts.push_back(mesh_.faces[t].n[i]);
      }
      found.cavity = cavity_of(mesh_, p, starts);
      work_ += found.work();
      if (const auto side = blocking_side(mesh_, found.cavity, p)) {
        const auto [a, b] = ends(mesh_, *side);
        const auto split = split_of(mesh_, *side, bounds_.small_angles());
        if (!split || !(distance(mesh_.points[a], mesh_.points[b]) > 2 * least) || least == 0) return no_index;
        work_ += split->work();
        carried_out(*split);
        continue;
      }
      const double apart = std::max(least, nearest * longest_side(t));
      for (const Index other : found.cavity.triangles)
        for (const Index v : mesh_.faces[other].v)
          if (distance(mesh_.points[v], p) < apart) return no_index;
      return can_be_connected(mesh_, found.cavity, p) ? carried_out(found) : no_index;
    }
  }
  [[nodiscard]] double longest_side(Index t) const {
    const Point a = mesh_.corner(t, 0), b = mesh_.corner(t, 1), c = mesh_.corner(t, 2);
    return std::max({distance(a, b), distance(b, c), distance(c, a)});
  }
  Index carried_out(const Insertion& insertion) {
    last_ = carry_out(mesh_, insertion).front();
    return static_cast<Index>(mesh_.points.size() - 1);
  }

  /// The places at which the line crosses segments, each with a new vertex, or no_index for a gap.
  std::map<double, Index> crossings(const Line& line) {
    struct Crossed {
      Index a, b, segment;
    };
    std::vector<Crossed> sides;
    std::map<double, Index> found;
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      for (int i = 0; mesh_.in_use(t) && i < 3; ++i) {
        const auto [a, b] = ends(mesh_, {t, i});
        if (!is_constrained(mesh_, {t, i})) continue;
        if (across_line(line, mesh_.points[a]) * across_line(line, mesh_.points[b]) < 0)
          sides.push_back({a, b, mesh_.faces[t].segment[i]});
        // The angles at vertices are not examined: there is a gap.
        for (const Index v : {a, b})
          if (const double at = along(line, mesh_.points[v]);
              across_line(line, mesh_.points[v]) == 0 && at >= line.low && at <= line.high)
            found.emplace(at, no_index);
      }
    for (const auto& [a, b, segment] : sides) {
      const auto [first, second] = mesh_.segments[segment];
      const double at = crossing(line, mesh_.points[first], mesh_.points[second]);
      if (at < line.low || at > line.high) continue;
      // The side is found again: others may have been split since.
      const Index t = triangle_with(a, b);
      if (t != no_index) found.emplace(at, split(line, at, a, b, t));
    }
    return found;
  }
  Index triangle_with(Index a, Index b) const {
    for (Index t = 0; t < mesh_.faces.size(); ++t)
      for (int i = 0; mesh_.in_use(t) && i < 3; ++i)
        if (ends(mesh_, {t, i}) == std::array{a, b}) return t;
    return no_index;
  }
  Index split(const Line& line, double at, Index a, Index b, Index t) {
    const Point p = mesh_.points[a], q = mesh_.points[b], x = on(line, at);
    int i = 0;
    while (ends(mesh_, {t, i}) != std::array{a, b}) ++i;
    const Side side{t, i};
    const bool is_good = std::abs(along(line, q) - along(line, p)) <= 0.5 * distance(p, q);
    const bool is_apart = std::min(distance(p, x), distance(q, x)) >= nearest * distance(p, q);
    if (!is_good || !is_apart || bounds_.small_angles().is_at(mesh_.faces[t].segment[i])) return no_index;
    Insertion found{t, x, side, {}};
    found.cavity = cavity_of(mesh_, x, triangles_at(mesh_, side));
    work_ += found.work();
    return can_be_connected(mesh_, found.cavity, x, side) ? carried_out(found) : no_index;
  }

  /// The length of a piece at p. Without a wanted size it is that of the mesh at t, for a whole line between two stops.
  [[nodiscard]] double piece_at(Point p, Index t) const {
    double area = bounds_.wanted_area(p, mesh_.faces[t].region);
    if (!std::isfinite(area)) area = twice_area(mesh_, t) / 2;
    return length_ * piece_of_unit_area * std::sqrt(area);
  }

  /// Lays the pieces between two stops.
  void lay(const Line& line, const std::pair<const double, Index>& from, const std::pair<const double, Index>& to) {
    const double length = to.first - from.first;
    const Point middle = on(line, from.first + length / 2);
    const Index t = triangle_at(middle);
    if (t == no_index || !(length > 0)) return;
    const bool is_sized = std::isfinite(bounds_.wanted_area(middle, mesh_.faces[t].region));
    const std::size_t most = is_sized ? most_points_ : most_unsized_;
    std::vector<double> ends = {0};
    while (ends.back() < length) {
      const double step = piece_at(on(line, from.first + ends.back()), t);
      ends.push_back(ends.back() + piece_at(on(line, std::min(from.first + ends.back() + step / 2, to.first)), t));
      if (ends.size() <= most) continue;
      ++gaps_;
      return;
    }
    // The last piece ends too late: all become a little shorter.
    const double share = length / ends.back();
    for (double& end : ends) end = from.first + end * share;
    std::vector<Index> vertices(ends.size(), no_index);
    vertices.front() = from.second;
    vertices.back() = to.second;
    lay_between(line, ends, 0, ends.size() - 1, vertices);
    for (std::size_t k = 1; k < ends.size(); ++k)
      if (vertices[k - 1] != no_index && vertices[k] != no_index)
        pieces_.push_back({std::min(vertices[k - 1], vertices[k]), std::max(vertices[k - 1], vertices[k])});
      else
        ++gaps_;
  }
  /// Inserts the points between two of a line, the middle ones first: cavities are smaller than from end to end.
  void lay_between(const Line& line, const std::vector<double>& ends, std::size_t low, std::size_t high,
                   std::vector<Index>& vertices) {
    const std::size_t k = (low + high) / 2;
    if (k == low || mesh_.points.size() > most_points_) return;
    vertices[k] = inserted(on(line, ends[k]), (ends[k] - ends[k - 1]) / 2);
    lay_between(line, ends, low, k, vertices);
    lay_between(line, ends, k, high, vertices);
  }

  LinkedMesh& mesh_;
  const Bounds& bounds_;
  double length_;
  std::size_t most_points_;
  std::size_t most_unsized_;  ///< pieces between two stops
  Index last_ = 0;
  std::uint64_t work_ = 0;
  std::size_t gaps_ = 0;
  std::vector<std::map<double, Index>> crossings_;  ///< of each line
  std::vector<std::array<Index, 2>> pieces_;
};

}  // namespace

Plan lattice_plan(const LinkedMesh& mesh, int workers) {
  const Extent e = extent_of(mesh.points);
  const int columns = std::max(1, static_cast<int>(std::sqrt(workers)));
  const int rows = (workers + columns - 1) / columns;
  const auto place = [](double low, double length, int k, int count) { return low + length * k / count; };
  Plan plan{{}, columns * rows, {}};
  for (int i = 1; i < columns; ++i)
    plan.lines.push_back({true, place(e.low.x, e.width(), i, columns), e.low.y, e.high.y});
  for (int j = 1; j < rows; ++j) plan.lines.push_back({false, place(e.low.y, e.height(), j, rows), e.low.x, e.high.x});
  plan.part_of = [lines = plan.lines, columns](Point p) {
    int i = 0, j = 0;
    for (const Line& line : lines) (line.in_x ? i : j) += (line.in_x ? p.x : p.y) >= line.at ? 1 : 0;
    return i + j * columns;
  };
  return plan;
}

Plan bisection_plan(const LinkedMesh& mesh, const Territory& territory) {
  const Extent e = extent_of(mesh.points);
  return {territory.borders(e.low, e.high), territory.workers(), [&](Point p) { return territory.owner(p); }};
}

Laid lay(LinkedMesh& mesh, const Bounds& bounds, const Plan& plan, double length, std::size_t most_points) {
  Layer layer(mesh, bounds, length, most_points);
  for (const Territory::Line& line : plan.lines) layer.cross(line);
  for (std::size_t k = 0; k < plan.lines.size(); ++k) layer.lay(plan.lines, k);
  return layer.finish();
}

}  // namespace pardel::schemes::decoupled
