#include "join_subsegments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../../core/support/straight_points.hpp"
#include "../arithmetic/predicates.hpp"

namespace pardel::engine {
namespace {

/// The distance from the larger of |x| and |y| to the next larger double; 0 if both are 0.
double unit(double x, double y) {
  const double largest = std::max(std::abs(x), std::abs(y));
  return largest == 0 ? 0 : std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
}

/// True if the inner points are at most two units off the line through the ends, and in order. The checker computes
/// these units exactly, so they are slightly smaller here.
bool is_straight(const Array<Point>& points, std::span<const Index> path) {
  constexpr double units = 2 * (1 - 0x1p-20);
  const Point a = points[path.front()], b = points[path.back()];
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double allowed = units * (unit(a.x, b.x) * std::abs(dy) + unit(a.y, b.y) * std::abs(dx));
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Point from = points[path[i - 1]], to = points[path[i]];
    if (!((to.x - from.x) * dx + (to.y - from.y) * dy > 0)) return false;
    if (i + 1 < path.size() && !(std::abs(exact::twice_area(a, b, to)) <= allowed)) return false;
  }
  return true;
}

std::vector<bool> straight_vertices(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments,
                                    const Threads& threads) {
  std::vector<Segment> segments;
  segments.reserve(subsegments.size());
  for (const ConstrainedEdge& e : subsegments) segments.push_back({e.a, e.b});
  return straight_points(
      mesh.points.span(), segments, [&](std::span<const Index> path) { return is_straight(mesh.points, path); },
      threads.stop);
}

class Joiner {
 public:
  Joiner(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments, const Threads& threads)
      : subsegments_(subsegments),
        is_inside_(straight_vertices(mesh, subsegments, threads)),
        at_(mesh.points.size(), {no_index, no_index}),
        done_(subsegments.size(), false),
        ask_(threads.stop) {
    for (Index s = 0; s < subsegments.size(); ++s) {
      ask_();
      for (const Index v : {subsegments[s].a, subsegments[s].b})
        if (is_inside_[v]) at_[v][at_[v][0] == no_index ? 0 : 1] = s;
    }
    const bool has_origins = mesh.origin.size() == mesh.points.size();
    result_.origin.resize(mesh.points.size(), input_vertex);
    for (std::size_t v = 0; has_origins && v < mesh.points.size(); ++v)
      if (mesh.origin[v] == interior_vertex) result_.origin[v] = interior_vertex;
  }

  JoinedSegments run() {
    for (Index s = 0; s < subsegments_.size(); ++s)
      for (const Index v : {subsegments_[s].a, subsegments_[s].b})
        if (!done_[s] && !is_inside_[v]) follow(s, v);
    return std::move(result_);
  }

 private:
  /// Adds the segment that starts at `start` with subsegment s.
  void follow(Index s, Index start) {
    const Index segment = static_cast<Index>(result_.segments.size()), first = s;
    std::vector<VertexId> path{start};
    std::vector<Index> numbers;
    for (;;) {
      ask_();
      done_[s] = true;
      numbers.push_back(s);
      const Index v = subsegments_[s].a == path.back() ? subsegments_[s].b : subsegments_[s].a;
      path.push_back(v);
      if (!is_inside_[v]) break;
      result_.origin[v] = origin_on_segment(segment);
      s = at_[v][0] == s ? at_[v][1] : at_[v][0];
    }
    result_.segments.push_back({start, path.back()});
    result_.subsegment.push_back(first);
    result_.pieces.add(path, numbers);
  }

  std::span<const ConstrainedEdge> subsegments_;
  std::vector<bool> is_inside_;
  std::vector<std::array<Index, 2>> at_;  ///< the two subsegments at a vertex inside a segment
  std::vector<bool> done_;
  SparseAsk ask_;
  JoinedSegments result_;
};

}  // namespace

JoinedSegments join_subsegments(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments,
                                const Threads& threads) {
  return Joiner(mesh, subsegments, threads).run();
}

}  // namespace pardel::engine
