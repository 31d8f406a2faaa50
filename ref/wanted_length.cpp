#include "wanted_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pardel::ref {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }
Point between(Point a, Point b, double f) { return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)}; }

double distance_to(Point p, Point a, Point b) {
  const double ux = b.x - a.x, uy = b.y - a.y, squared = ux * ux + uy * uy;
  const double f = squared > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / squared, 0.0, 1.0) : 0;
  return distance(p, between(a, b, f));
}

std::vector<Segment> segments_at(const Pslg& pslg, Index point) {
  std::vector<Segment> found;
  for (const Segment& s : pslg.segments)
    if (s.a == point || s.b == point) found.push_back(s);
  return found;
}

/// The other end of a segment.
Index beyond(const Segment& s, Index point) { return s.a == point ? s.b : s.a; }

/// The product of the directions from a to b and from c to d.
double product(const Pslg& pslg, Index a, Index b, Index c, Index d) {
  const auto& p = pslg.points;
  return (p[b].x - p[a].x) * (p[d].x - p[c].x) + (p[b].y - p[a].y) * (p[d].y - p[c].y);
}

/// Adds the segments of a walk along s from `start` (see touching()). Returns the corner where it ends, if any.
std::optional<Index> walk(const Pslg& pslg, const Segment& s, Index start, std::vector<Feature>& found) {
  Segment here = s;
  Index from = start, to = beyond(s, start);
  for (;;) {
    found.push_back({here.a, here.b});
    if (is_corner_of(pslg, to)) return to;
    const std::vector<Segment> both = segments_at(pslg, to);
    const Segment next = beyond(both[0], to) == from ? both[1] : both[0];
    const Index after = beyond(next, to);
    // A ring without corners turns by 360 degrees in steps of less than 50. So this ends before it reaches s again.
    if (!(product(pslg, start, beyond(s, start), to, after) > 0)) return std::nullopt;
    from = to;
    to = after;
    here = next;
  }
}

void add_touching_corner(const Pslg& pslg, Index corner, std::vector<Feature>& found) {
  found.push_back({corner, corner});
  for (const Segment& s : segments_at(pslg, corner)) walk(pslg, s, corner, found);
}

/// The distance of p to the nearest feature that is not in `near`.
double width(const Pslg& pslg, const std::vector<Feature>& features, const std::vector<Feature>& near, Point p) {
  double least = infinity;
  for (const Feature& g : features) {
    const bool touches = std::ranges::any_of(
        near, [&](const Feature& n) { return (n.a == g.a && n.b == g.b) || (n.a == g.b && n.b == g.a); });
    if (!touches) least = std::min(least, distance_to(p, pslg.points[g.a], pslg.points[g.b]));
  }
  return least;
}

}  // namespace

bool is_corner_of(const Pslg& pslg, Index point) {
  const std::vector<Segment> both = segments_at(pslg, point);
  if (both.size() != 2) return true;
  const Index a = beyond(both[0], point), b = beyond(both[1], point);
  const double lengths = distance(pslg.points[a], pslg.points[point]) * distance(pslg.points[point], pslg.points[b]);
  return !(product(pslg, a, point, point, b) > 0.65 * lengths);
}

std::vector<Feature> features_of(const Pslg& pslg) {
  std::vector<Feature> features;
  for (const Segment& s : pslg.segments) features.push_back({s.a, s.b});
  for (Index v = 0; v < pslg.points.size(); ++v)
    if (is_corner_of(pslg, v)) features.push_back({v, v});
  return features;
}

std::vector<Feature> touching(const Pslg& pslg, Feature f) {
  std::vector<Feature> found;
  if (f.a == f.b) {
    add_touching_corner(pslg, f.a, found);
    return found;
  }
  for (const Index start : {f.a, f.b})
    if (const auto corner = walk(pslg, {f.a, f.b, 0}, start, found)) add_touching_corner(pslg, *corner, found);
  return found;
}

double width_at(const Pslg& pslg, Feature f, Point p) { return width(pslg, features_of(pslg), touching(pslg, f), p); }

std::optional<double> radius_of_turn(const Pslg& pslg, Index point) {
  if (is_corner_of(pslg, point)) return std::nullopt;
  const std::vector<Segment> both = segments_at(pslg, point);
  const Point a = pslg.points[beyond(both[0], point)], p = pslg.points[point], b = pslg.points[beyond(both[1], point)];
  const double turn = std::abs(
      std::remainder(std::atan2(b.y - p.y, b.x - p.x) - std::atan2(p.y - a.y, p.x - a.x), 2 * std::numbers::pi));
  if (!(turn > 0)) return std::nullopt;
  return std::min(distance(a, p), distance(p, b)) / 2 / std::tan(turn / 2);
}

WantedLength::WantedLength(const Pslg& pslg, const Goal& goal, int points_per_segment) {
  const double edges = goal.feature_edges > 0 ? goal.feature_edges : 1;
  const double feature_slope = std::min(goal.grading, 1 / edges);
  const std::vector<Feature> features = features_of(pslg);
  for (const Feature& f : features) {
    const Point a = pslg.points[f.a], b = pslg.points[f.b];
    const std::vector<Feature> near = touching(pslg, f);
    for (int i = 0; i <= points_per_segment; ++i) {
      const Point p = between(a, b, static_cast<double>(i) / points_per_segment);
      add(p, width(pslg, features, near, p) / edges, feature_slope);
    }
    // A width changes by at most the distance of its places.
    error_ = std::max(error_, distance(a, b) / points_per_segment / 2 * (1 / edges + feature_slope));
  }
  for (Index v = 0; v < pslg.points.size(); ++v)
    if (const auto radius = radius_of_turn(pslg, v)) add(pslg.points[v], *radius / edges, feature_slope);
  slope_ = feature_slope;
  if (goal.grading == infinity) return;
  slope_ = goal.grading;
  for (const Segment& s : pslg.segments) {
    const double length = distance(pslg.points[s.a], pslg.points[s.b]);
    all_.push_back({{pslg.points[s.a], pslg.points[s.b], length, length}, goal.grading});
  }
  for (const SizeSource& source : goal.sources) all_.push_back({source, goal.grading});
}

void WantedLength::add(Point p, double length, double slope) {
  if (length < infinity) all_.push_back({{p, p, length, length}, slope});
}

double WantedLength::at(Point p) const {
  double least = infinity;
  for (const auto& growing : all_) {
    const SizeSource& source = growing.source;
    const auto value = [&](double f) {
      return source.at_a + f * (source.at_b - source.at_a) +
             growing.slope * distance(p, between(source.a, source.b, f));
    };
    // The value is a convex function of f.
    double low = 0, high = 1;
    for (int i = 0; i < 100 && !(source.a == source.b); ++i) {
      const double left = low + (high - low) / 3, right = high - (high - low) / 3;
      (value(left) < value(right) ? high : low) = value(left) < value(right) ? right : left;
    }
    least = std::min({least, value(0), value(low), source.a == source.b ? value(0) : value(1)});
  }
  return least;
}

}  // namespace pardel::ref
