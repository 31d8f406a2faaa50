#include "feature_sources.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "../arithmetic/box.hpp"
#include "../arithmetic/distance.hpp"
#include "../arithmetic/floor.hpp"
#include "../decomposition/hilbert_order.hpp"

namespace pardel::engine {
namespace {

double distance_to(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
  const double squared = dx * dx + dy * dy;
  const double f = squared > 0 ? std::clamp((px * dx + py * dy) / squared, 0.0, 1.0) : 0.0;
  const double x = px - f * dx, y = py - f * dy;
  return std::sqrt(x * x + y * y);
}

/// The distance of two pieces that do not cross.
double distance_of(Point a, Point b, Point c, Point d) {
  return std::min({distance_to(a, c, d), distance_to(b, c, d), distance_to(c, a, b), distance_to(d, a, b)});
}

double distance_of(const Box& a, const Box& b) {
  const double dx = std::max({a.min_x - b.max_x, 0.0, b.min_x - a.max_x});
  const double dy = std::max({a.min_y - b.max_y, 0.0, b.min_y - a.max_y});
  return std::sqrt(dx * dx + dy * dy);
}

/// Sources that follow each other along a polyline, joined where one source can stand for several.
class Joined {
 public:
  Joined(double slope, std::vector<GrowingSize>& out) : slope_(slope), out_(out) {}
  ~Joined() { flush(); }
  Joined(const Joined&) = delete;
  Joined& operator=(const Joined&) = delete;

  /// A piece from a to b with this length. It can only be joined with pieces before it if it begins where they end.
  void add(Point a, Point b, double length) {
    if (!ends_.empty() && (!(ends_.back() == a) || !fits(b, length))) flush();
    if (ends_.empty()) {
      ends_ = {a};
      least_ = most_ = length;
    }
    ends_.push_back(b);
    least_ = std::min(least_, length);
    most_ = std::max(most_, length);
  }
  void flush() {
    if (ends_.empty()) return;
    const double length = least_ - slope_ * off_chord(ends_.back());
    out_.push_back({{ends_.front(), ends_.back(), length, length}, slope_});
    ends_.clear();
  }

 private:
  static constexpr double range = 1.125;    ///< of the lengths of one source
  static constexpr double loss = 1.0 / 16;  ///< by which a length may be reduced because the pieces turn
  static constexpr std::size_t most_joined = 64;

  [[nodiscard]] bool fits(Point b, double length) const {
    const double least = std::min(least_, length), most = std::max(most_, length);
    return ends_.size() <= most_joined && most <= range * least && slope_ * off_chord(b) <= loss * least;
  }
  /// The largest distance of the pieces from the chord that ends at `last`.
  [[nodiscard]] double off_chord(Point last) const {
    double most = 0;
    for (const Point p : ends_) most = std::max(most, distance_to(p, ends_.front(), last));
    return most;
  }

  double slope_;
  std::vector<GrowingSize>& out_;
  std::vector<Point> ends_;
  double least_ = 0, most_ = 0;
};

/// The features that are not apart from a feature: `count` segments of its polyline from position `first` on (a closed
/// polyline begins again after its end), and those that touch one of two corners.
struct Touching {
  Index line = no_index, first = 0, count = 0;
  std::array<Index, 2> corners{no_index, no_index};
};

/// The features of a domain (segments and corners), and for each the features that are apart from it.
class Features {
 public:
  Features(const Pslg& pslg, const Polylines& lines, const Threads& threads)
      : pslg_(pslg), lines_(lines), ask_(threads.stop) {
    std::vector<Point> representative;
    for (const Polyline& line : lines.all) representative.push_back(pslg.points[line.vertices.front()]);
    std::vector<Index> corners;
    for (Index v = 0; v < pslg.points.size(); ++v)
      if (lines.is_corner[v]) {
        corners.push_back(v);
        representative.push_back(pslg.points[v]);
      }
    line_begin_.resize(lines.all.size());
    for (const Index i : hilbert_order(representative, threads)) {
      if (i < lines.all.size()) {
        line_begin_[i] = static_cast<Index>(features_.size());
        const auto& v = lines.all[i].vertices;
        for (Index k = 0; k + 1 < v.size(); ++k) features_.push_back({v[k], v[k + 1], i, k});
      } else {
        const Index v = corners[i - lines.all.size()];
        features_.push_back({v, v, no_index, 0});
      }
    }
    make_tree();
    runs_from_ends();
    measure_parts();
  }

  /// The distance of a piece of a feature to the nearest feature that is apart from it; infinity if there is none.
  double nearest_apart(const Touching& touching, Point a, Point b) {
    ask_();
    double best = INFINITY;
    search(1, 0, leaf_count_, touching, a, b, Box::around(a, b), best);
    return best;
  }

  [[nodiscard]] Touching touching(Index f) const {
    const Feature& feature = features_[f];
    Touching result;
    if (feature.line == no_index) {
      result.corners[0] = feature.a;
      return result;
    }
    const Polyline& line = lines_.all[feature.line];
    const Index n = segments(feature.line), at = feature.at;
    const Index ahead = run_ahead(feature.line, at, line.closed ? n : n - at);
    const Index behind = run_behind(feature.line, at, line.closed ? n : at + 1);
    result.line = feature.line;
    result.first = (at + n + 1 - behind) % n;
    result.count = std::min(n, ahead + behind - 1);
    if (line.closed) return result;
    if (behind == at + 1) result.corners[0] = line.vertices.front();
    if (ahead == n - at) result.corners[1] = line.vertices.back();
    return result;
  }

  [[nodiscard]] Index first_of_line(Index line) const { return line_begin_[line]; }
  [[nodiscard]] std::size_t size() const { return features_.size(); }
  [[nodiscard]] bool is_corner(Index f) const { return features_[f].line == no_index; }
  [[nodiscard]] Point from(Index f) const { return pslg_.points[features_[f].a]; }
  [[nodiscard]] Point to(Index f) const { return pslg_.points[features_[f].b]; }
  /// The extent of all polylines that are connected with the feature; 0 for a corner.
  [[nodiscard]] double extent_around(Index f) const { return is_corner(f) ? 0 : extent_around_[features_[f].line]; }
  /// Shorter parts of a segment are not divided there. Far from the origin, coordinates have few digits for them.
  [[nodiscard]] static double shortest_part(Point p) { return Floor(0).at(p) / 16; }
  /// Below this width, all widths at a place are alike. No mesh has such short edges there, and where segments nearly
  /// coincide, rounding makes the width change from place to place.
  [[nodiscard]] static double unresolved(Point p) { return Floor(0).at(p); }

 private:
  struct Feature {
    Index a, b;      ///< points of the Pslg; a == b for a corner
    Index line, at;  ///< the polyline and the position on it; no_index for a corner
  };
  [[nodiscard]] Index segments(Index line) const { return static_cast<Index>(lines_.all[line].vertices.size() - 1); }
  /// The number of segments of the polyline, from position `at` onwards, at most `most`, that keep the direction of the
  /// segment there.
  [[nodiscard]] Index run_ahead(Index line, Index at, Index most) const {
    const Index n = segments(line), begin = line_begin_[line];
    const Index straight = std::min(most, n - at);  // before a closed polyline begins again
    const std::size_t turned = first_turned(1, 0, leaf_count_, begin + at, begin + at, begin + at + straight);
    if (turned != none) return static_cast<Index>(turned - begin - at);
    if (straight == most) return most;
    const std::size_t again = first_turned(1, 0, leaf_count_, begin + at, begin, begin + most - straight);
    return again == none ? most : straight + static_cast<Index>(again - begin);
  }
  /// The same backwards.
  [[nodiscard]] Index run_behind(Index line, Index at, Index most) const {
    const Index n = segments(line), begin = line_begin_[line];
    const Index straight = std::min(most, at + 1);
    const std::size_t turned = last_turned(1, 0, leaf_count_, begin + at, begin + at + 1 - straight, begin + at + 1);
    if (turned != none) return static_cast<Index>(begin + at - turned);
    if (straight == most) return most;
    const std::size_t again = last_turned(1, 0, leaf_count_, begin + at, begin + n - (most - straight), begin + n);
    return again == none ? most : straight + static_cast<Index>(begin + n - 1 - again);
  }

  static constexpr std::size_t none = SIZE_MAX;

  /// The first feature in [from, to) that does not keep the direction of segment s. The node has the features from
  /// `first` on, `count` of them.
  [[nodiscard]] std::size_t first_turned(std::size_t node, std::size_t first, std::size_t count, std::size_t s,
                                         std::size_t from, std::size_t to) const {
    if (first >= to || first + count <= from || (from <= first && first + count <= to && all_keep(node, s)))
      return none;
    if (count == 1) return first;
    const std::size_t half = count / 2, left = first_turned(2 * node, first, half, s, from, to);
    return left != none ? left : first_turned(2 * node + 1, first + half, half, s, from, to);
  }
  [[nodiscard]] std::size_t last_turned(std::size_t node, std::size_t first, std::size_t count, std::size_t s,
                                        std::size_t from, std::size_t to) const {
    if (first >= to || first + count <= from || (from <= first && first + count <= to && all_keep(node, s)))
      return none;
    if (count == 1) return first;
    const std::size_t half = count / 2, right = last_turned(2 * node + 1, first + half, half, s, from, to);
    return right != none ? right : last_turned(2 * node, first, half, s, from, to);
  }
  /// True if all directions in the node have a positive product with that of segment s. Rounding is monotonic, so this
  /// agrees with the products of the segments themselves.
  [[nodiscard]] bool all_keep(std::size_t node, std::size_t s) const {
    const Point d = direction(s);
    const Box& box = directions_[node];
    return d.x * (d.x > 0 ? box.min_x : box.max_x) + d.y * (d.y > 0 ? box.min_y : box.max_y) > 0;
  }
  [[nodiscard]] Point direction(std::size_t s) const {
    const Point a = from(static_cast<Index>(s)), b = to(static_cast<Index>(s));
    return {b.x - a.x, b.y - a.y};
  }

  void runs_from_ends() {
    from_start_.assign(lines_.all.size(), 0);
    from_end_.assign(lines_.all.size(), 0);
    for (Index line = 0; line < lines_.all.size(); ++line) {
      if (lines_.all[line].closed) continue;
      const Index n = segments(line);
      from_start_[line] = run_ahead(line, 0, n);
      from_end_[line] = run_behind(line, n - 1, n);
    }
  }

  void measure_parts() {
    std::vector<Index> other(pslg_.points.size());  // in the same part; a point that names itself stands for its part
    std::iota(other.begin(), other.end(), Index{0});
    const auto part_of = [&](Index v) {
      while (other[v] != v) v = other[v] = other[other[v]];
      return v;
    };
    for (const Polyline& line : lines_.all) other[part_of(line.vertices.front())] = part_of(line.vertices.back());
    std::unordered_map<Index, Box> box_of_part;
    for (const Polyline& line : lines_.all) {
      Box& box = box_of_part.try_emplace(part_of(line.vertices.front()), empty_box).first->second;
      for (const Index v : line.vertices) box.cover(Box::around(pslg_.points[v]));
    }
    for (const Polyline& line : lines_.all)
      extent_around_.push_back(box_of_part.at(part_of(line.vertices.front())).extent());
  }

  /// True if none of the features from `first` to `last` is apart. They are consecutive and belong to one polyline, or
  /// are one corner.
  [[nodiscard]] bool touch(const Touching& touching, const Feature& first, const Feature& last) const {
    if (first.line == no_index) return first.a == touching.corners[0] || first.a == touching.corners[1];
    const Index n = segments(first.line);
    if (first.line == touching.line && (first.at + n - touching.first) % n + (last.at - first.at) < touching.count)
      return true;
    const Polyline& line = lines_.all[first.line];
    if (line.closed) return false;
    for (const Index corner : touching.corners) {
      if (corner == no_index) continue;
      if (line.vertices.front() == corner && last.at < from_start_[first.line]) return true;
      if (line.vertices.back() == corner && first.at + from_end_[first.line] >= n) return true;
    }
    return false;
  }

  void make_tree() {
    leaf_count_ = std::bit_ceil(std::max<std::size_t>(1, features_.size()));
    boxes_.assign(2 * leaf_count_, empty_box);
    directions_.assign(2 * leaf_count_, empty_box);
    for (std::size_t i = 0; i < features_.size(); ++i) {
      boxes_[leaf_count_ + i] = Box::around(from(static_cast<Index>(i)), to(static_cast<Index>(i)));
      directions_[leaf_count_ + i] = Box::around(direction(i));
    }
    for (std::size_t i = leaf_count_ - 1; i > 0; --i) {
      boxes_[i].cover(boxes_[2 * i]);
      boxes_[i].cover(boxes_[2 * i + 1]);
      directions_[i].cover(directions_[2 * i]);
      directions_[i].cover(directions_[2 * i + 1]);
    }
  }

  /// The node has the features from `first` on, `count` of them.
  void search(std::size_t node, std::size_t first, std::size_t count, const Touching& touching, Point a, Point b,
              const Box& box, double& best) const {
    if (first >= features_.size()) return;
    const std::size_t last = std::min(first + count, features_.size()) - 1;
    const Feature &front = features_[first], &back = features_[last];
    const bool one_line = front.line == back.line && (front.line != no_index || first == last);
    if (one_line && touch(touching, front, back)) return;
    if (count == 1) {
      best = std::min(best, distance_of(a, b, pslg_.points[front.a], pslg_.points[front.b]));
      return;
    }
    std::array<std::size_t, 2> child = {2 * node, 2 * node + 1};
    std::array<double, 2> away = {distance_of(boxes_[child[0]], box), distance_of(boxes_[child[1]], box)};
    const unsigned nearer = away[1] < away[0] ? 1 : 0;
    for (const unsigned i : {nearer, 1 - nearer}) {
      // What is left out is farther by more than the rounding of distances, so that the order does not matter.
      const double margin = std::max({best, box.extent(), boxes_[child[i]].extent()}) * 0x1p-40;
      if (away[i] <= best + margin) search(child[i], first + i * (count / 2), count / 2, touching, a, b, box, best);
    }
  }

  const Pslg& pslg_;
  const Polylines& lines_;
  SparseAsk ask_;
  std::vector<double> extent_around_;  ///< of each polyline
  std::vector<Feature> features_;
  std::vector<Index> line_begin_;             ///< the first feature of each polyline
  std::vector<Index> from_start_, from_end_;  ///< how many segments keep the direction of the first, or of the last
  std::size_t leaf_count_ = 1;
  // Implicit binary trees over features_: root at 1, leaves from leaf_count_ on.
  std::vector<Box> boxes_;
  std::vector<Box> directions_;  ///< around the directions of segments
};

/// The radius of the turn at v: of the circle that touches both segments, the shorter one in its middle.
double radius_of_turn(Point a, Point v, Point b) {
  const double x = v.x - a.x, y = v.y - a.y, u = b.x - v.x, w = b.y - v.y;
  const double first = distance(a, v), second = distance(v, b);
  return std::min(first, second) * (first * second + (x * u + y * w)) / (2 * std::abs(x * w - y * u));
}

/// Adds sources along the polyline whose lengths are the distances to other features, divided by `edges`.
class Widths {
 public:
  Widths(Features& features, double edges, double slope, std::vector<GrowingSize>& out)
      : features_(features), edges_(edges), out_(slope, out) {}

  void add(Index feature) {
    extent_ = features_.extent_around(feature);
    add(features_.touching(feature), features_.from(feature), features_.to(feature));
  }

 private:
  /// Divides the piece until the distance to other features changes little along each part. Along a channel that is
  /// much narrower than the part of the domain around it, it changes little along long parts, too; near a single narrow
  /// place it does not.
  void add(const Touching& touching, Point a, Point b) {
    constexpr double part = 0.25, short_part = 0x1p-16, narrow_part = 0x1p-8;
    const double width = features_.nearest_apart(touching, a, b), length = distance(a, b);
    if (width == INFINITY) return;
    const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const auto is_nowhere_above = [&](double most) {
      return std::ranges::all_of(std::array{a, middle, b},
                                 [&](Point y) { return features_.nearest_apart(touching, y, y) <= most; });
    };
    const double unresolved = Features::unresolved(middle);
    if (length <= part * width || length <= Features::shortest_part(middle) ||
        (length <= short_part * extent_ && is_nowhere_above(2 * width)) ||
        (length <= narrow_part * extent_ && width <= unresolved && is_nowhere_above(unresolved)))
      return out_.add(a, b, width / edges_);
    add(touching, a, middle);
    add(touching, middle, b);
  }

  Features& features_;
  double edges_;
  double extent_ = 0;  ///< Features::extent_around() of the feature that is added
  Joined out_;
};

/// Adds the radii of the turns of a polyline, divided by `edges`. Where vertices are dense, a source joins them.
void add_turns(const Pslg& pslg, const Polyline& line, double edges, double slope, std::vector<GrowingSize>& out) {
  constexpr double dense = 0.25;
  Joined joined(slope, out);
  const std::vector<Index>& v = line.vertices;
  double before = INFINITY;
  const std::size_t end = line.closed ? v.size() : v.size() - 1;
  for (std::size_t k = 1; k < end; ++k) {
    const Point a = pslg.points[v[k - 1]], p = pslg.points[v[k]], b = pslg.points[v[k + 1 < v.size() ? k + 1 : 1]];
    const double length = radius_of_turn(a, p, b) / edges;
    if (length < INFINITY)
      joined.add(distance(a, p) <= dense * std::min(before, length) && before < INFINITY ? a : p, p, length);
    before = length;
  }
}

}  // namespace

std::vector<GrowingSize> feature_sources(const Pslg& pslg, const Polylines& lines, double edges, double slope,
                                         const Threads& threads) {
  Features features(pslg, lines, threads);
  std::vector<GrowingSize> sources;
  for (Index f = 0; f < features.size(); ++f)
    if (features.is_corner(f)) Widths(features, edges, slope, sources).add(f);
  for (Index line = 0; line < lines.all.size(); ++line) {
    Widths widths(features, edges, slope, sources);
    for (Index k = 0; k + 1 < lines.all[line].vertices.size(); ++k) widths.add(features.first_of_line(line) + k);
    add_turns(pslg, lines.all[line], edges, slope, sources);
  }
  return sources;
}

std::vector<GrowingSize> segment_sources(const Pslg& pslg, const Polylines& lines, double slope) {
  std::vector<GrowingSize> sources;
  for (const Polyline& line : lines.all) {
    Joined lengths(slope, sources);
    for (std::size_t k = 0; k + 1 < line.vertices.size(); ++k) {
      const Point a = pslg.points[line.vertices[k]], b = pslg.points[line.vertices[k + 1]];
      lengths.add(a, b, distance(a, b));
    }
  }
  return sources;
}

}  // namespace pardel::engine
