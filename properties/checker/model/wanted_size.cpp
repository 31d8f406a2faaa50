#include "wanted_size.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pardel::checker {
namespace {

double length_of(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The cosine of a turn above which a vertex with two segments is no corner. The mesher has the same number, because
/// the definition does.
constexpr double least_cosine = 0.65;

/// The segments and corners of a domain, and which of them touch each other in the sense of the definition.
class FeatureGraph {
 public:
  explicit FeatureGraph(const Pslg& pslg) : pslg_(pslg), at_(pslg.points.size()) {
    for (Index s = 0; s < pslg.segments.size(); ++s) {
      const auto [a, b, marker] = pslg.segments[s];
      if (a == b) continue;
      usable_.push_back(s);
      at_[a].push_back(s);
      at_[b].push_back(s);
    }
  }

  [[nodiscard]] const std::vector<Index>& segments() const { return usable_; }
  [[nodiscard]] const std::vector<Index>& segments_at(Index v) const { return at_[v]; }
  [[nodiscard]] Index other_end(Index s, Index v) const {
    return pslg_.segments[s].a == v ? pslg_.segments[s].b : pslg_.segments[s].a;
  }
  [[nodiscard]] bool is_corner(Index v) const {
    if (at_[v].size() != 2) return true;
    const Point a = point(other_end(at_[v][0], v)), p = point(v), b = point(other_end(at_[v][1], v));
    const double dot = (p.x - a.x) * (b.x - p.x) + (p.y - a.y) * (b.y - p.y);
    const auto length = [](Point q, Point r) {
      return std::sqrt((r.x - q.x) * (r.x - q.x) + (r.y - q.y) * (r.y - q.y));
    };
    return !(dot > least_cosine * (length(a, p) * length(p, b)));
  }

  /// Calls segment(t) for each segment on the way from s through its end v, s included, and past vertices that are no
  /// corners, as long as the direction differs by less than 90 degrees from that of s. Returns the corner at which the
  /// way ends, or no_index.
  template <class Visit>
  Index walk(Index s, Index v, const Visit& segment) const {
    const Point from = point(other_end(s, v)), to = point(v);
    Index t = s;
    for (;;) {
      segment(t);
      if (is_corner(v)) return v;
      t = at_[v][0] == t ? at_[v][1] : at_[v][0];
      const Index next = other_end(t, v);
      const Point a = point(v), b = point(next);
      const double dot = (to.x - from.x) * (b.x - a.x) + (to.y - from.y) * (b.y - a.y);
      if (t == s || !(dot > 0)) return no_index;
      v = next;
    }
  }
  /// The same for all segments at a corner, away from it.
  template <class Visit>
  void walk_from(Index corner, const Visit& segment) const {
    for (const Index s : at_[corner]) walk(s, other_end(s, corner), segment);
  }

  [[nodiscard]] Point point(Index v) const { return pslg_.points[v]; }

 private:
  const Pslg& pslg_;
  std::vector<std::vector<Index>> at_;
  std::vector<Index> usable_;
};

/// The distances of features to the nearest ones that are apart from them.
class Widths {
 public:
  Widths(const Pslg& pslg, StopSignal* stop)
      : pslg_(pslg),
        ask_(stop),
        graph_(pslg),
        touched_(pslg.segments.size() + pslg.points.size(), no_index),
        features_(all_features()) {}

  /// Adds pieces with these distances, and with the radii of turns, divided by `edges`.
  void add_to(std::vector<GrowingLengths::Piece>& pieces, double edges, double slope) {
    const auto add = [&](Point p, double length) {
      if (length < std::numeric_limits<double>::infinity())
        pieces.push_back({p, p, length / edges, length / edges, slope});
    };
    for (const Index s : graph_.segments()) {
      const Point a = pslg_.points[pslg_.segments[s].a], b = pslg_.points[pslg_.segments[s].b];
      touch_segment(s);
      for (double f = 0; f < 1;) {
        const Point p{a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
        const double width = nearest(p);
        add(p, width);
        const double step = width / length_of(a, b) / 8;
        f += std::max(step, 0x1p-14);
      }
      add(b, nearest(b));
    }
    for (Index v = 0; v < pslg_.points.size(); ++v) {
      if (graph_.is_corner(v)) {
        touch_corner(v);
        add(pslg_.points[v], nearest(pslg_.points[v]));
      } else {
        add(pslg_.points[v], radius(v));
      }
    }
  }

  [[nodiscard]] const FeatureGraph& graph() const { return graph_; }

 private:
  /// A segment is the feature of its number. A corner has the number of its point behind those of all segments.
  [[nodiscard]] Index of_corner(Index v) const { return static_cast<Index>(pslg_.segments.size() + v); }

  GrowingLengths all_features() {
    std::vector<GrowingLengths::Piece> pieces;
    for (const Index s : graph_.segments()) {
      numbers_.push_back(s);
      pieces.push_back({pslg_.points[pslg_.segments[s].a], pslg_.points[pslg_.segments[s].b], 0, 0, 1});
    }
    for (Index v = 0; v < pslg_.points.size(); ++v) {
      if (!graph_.is_corner(v)) continue;
      numbers_.push_back(of_corner(v));
      pieces.push_back({pslg_.points[v], pslg_.points[v], 0, 0, 1});
    }
    return GrowingLengths(std::move(pieces));
  }

  void touch_corner(Index v) {
    ++now_;
    touch_at(v);
  }
  void touch_segment(Index s) {
    ++now_;
    for (const Index v : {pslg_.segments[s].a, pslg_.segments[s].b}) {
      const Index corner = graph_.walk(s, v, [&](Index t) { touch(t); });
      if (corner != no_index) touch_at(corner);
    }
  }
  void touch_at(Index corner) {
    touched_[of_corner(corner)] = now_;
    graph_.walk_from(corner, [&](Index t) { touch(t); });
  }

  void touch(Index feature) {
    ask_();
    touched_[feature] = now_;
  }

  [[nodiscard]] double nearest(Point p) {
    ask_();
    return features_.least(p, [&](Index i) { return touched_[numbers_[i]] == now_; });
  }

  /// The radius of the circle that touches both segments at v, the shorter one in its middle.
  [[nodiscard]] double radius(Index v) const {
    const Point p = graph_.point(v), a = graph_.point(graph_.other_end(graph_.segments_at(v)[0], v)),
                b = graph_.point(graph_.other_end(graph_.segments_at(v)[1], v));
    const double turn = std::atan2(std::abs((p.x - a.x) * (b.y - p.y) - (p.y - a.y) * (b.x - p.x)),
                                   (p.x - a.x) * (b.x - p.x) + (p.y - a.y) * (b.y - p.y));
    return std::min(length_of(a, p), length_of(p, b)) / 2 / std::tan(turn / 2);
  }

  const Pslg& pslg_;
  SparseAsk ask_;
  FeatureGraph graph_;
  std::vector<Index> touched_;  ///< per feature: the last feature that it touches
  Index now_ = 0;
  std::vector<Index> numbers_;  ///< of the pieces in features_
  GrowingLengths features_;
};

std::vector<GrowingLengths::Piece> pieces_of(const Pslg& pslg, const Goal& goal, StopSignal* stop) {
  std::vector<GrowingLengths::Piece> pieces;
  const bool has_limit = goal.grading < std::numeric_limits<double>::infinity();
  if (!has_limit && !(goal.feature_edges > 0)) return pieces;
  const double edges = goal.feature_edges > 0 ? goal.feature_edges : 1;
  Widths widths(pslg, stop);
  widths.add_to(pieces, edges, std::min(goal.grading, 1 / edges));
  if (!has_limit) return pieces;
  for (const Index s : widths.graph().segments()) {
    const Point a = pslg.points[pslg.segments[s].a], b = pslg.points[pslg.segments[s].b];
    pieces.push_back({a, b, length_of(a, b), length_of(a, b), goal.grading});
  }
  for (const SizeSource& source : goal.sources)
    pieces.push_back({source.a, source.b, source.at_a, source.at_b, goal.grading});
  return pieces;
}

}  // namespace

GrowingLengths::GrowingLengths(std::vector<Piece> pieces) : pieces_(std::move(pieces)), order_(pieces_.size()) {
  std::iota(order_.begin(), order_.end(), Index{0});
  if (!pieces_.empty()) build(0, pieces_.size());
}

std::size_t GrowingLengths::build(std::size_t first, std::size_t last) {
  Node node{infinity, infinity, -infinity, -infinity, infinity, infinity, first, last};
  for (std::size_t i = first; i < last; ++i) {
    const Piece& piece = pieces_[order_[i]];
    for (const Point p : {piece.a, piece.b}) {
      node.min_x = std::min(node.min_x, p.x);
      node.min_y = std::min(node.min_y, p.y);
      node.max_x = std::max(node.max_x, p.x);
      node.max_y = std::max(node.max_y, p.y);
    }
    node.length = std::min({node.length, piece.at_a, piece.at_b});
    node.slope = std::min(node.slope, piece.slope);
  }
  const std::size_t here = nodes_.size();
  nodes_.push_back(node);
  if (last - first <= 4) return here;
  const bool wide = node.max_x - node.min_x > node.max_y - node.min_y;
  const auto centre = [&](Index i) {
    const Piece& piece = pieces_[i];
    return wide ? piece.a.x + piece.b.x : piece.a.y + piece.b.y;
  };
  const std::size_t middle = first + (last - first) / 2;
  const auto begin = order_.begin();
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(middle),
                   begin + static_cast<std::ptrdiff_t>(last), [&](Index i, Index j) { return centre(i) < centre(j); });
  const std::size_t left = build(first, middle), right = build(middle, last);
  nodes_[here].left = left;
  nodes_[here].right = right;
  return here;
}

/// The least of at(y) + slope * |p - y| over the piece: a convex function of y.
double GrowingLengths::length_at(const Piece& piece, Point p) {
  const double from_a = piece.at_a + piece.slope * length_of(piece.a, p);
  const double from_b = piece.at_b + piece.slope * length_of(piece.b, p);
  const double extent = length_of(piece.a, piece.b);
  const double change = extent > 0 ? (piece.at_b - piece.at_a) / extent : piece.slope;
  if (!(std::abs(change) < piece.slope)) return std::min(from_a, from_b);
  const Point along{(piece.b.x - piece.a.x) / extent, (piece.b.y - piece.a.y) / extent};
  const double foot = (p.x - piece.a.x) * along.x + (p.y - piece.a.y) * along.y;
  const double away = std::abs((p.y - piece.a.y) * along.x - (p.x - piece.a.x) * along.y);
  // Seen from the best y, the piece and the way to p enclose an angle with this tangent.
  const double y = foot - away * std::tan(std::asin(change / piece.slope));
  if (y <= 0) return from_a;
  if (y >= extent) return from_b;
  return piece.at_a + change * y + piece.slope * std::hypot(away, foot - y);
}

double GrowingLengths::bound(const Node& node, Point p) {
  const double dx = std::max({node.min_x - p.x, 0.0, p.x - node.max_x});
  const double dy = std::max({node.min_y - p.y, 0.0, p.y - node.max_y});
  return node.length + node.slope * std::sqrt(dx * dx + dy * dy);
}

WantedSize::WantedSize(const Pslg& pslg, const Goal& goal, StopSignal* stop)
    : graded_(goal.grading < std::numeric_limits<double>::infinity() || goal.feature_edges > 0),
      lengths_(pieces_of(pslg, goal, stop)) {}

}  // namespace pardel::checker
