#include "justified.hpp"

#include <algorithm>
#include <array>

#include "../arithmetic/exact.hpp"
#include "../arithmetic/measure.hpp"
#include "../tolerances.hpp"

namespace pardel::checker {
namespace {

Index other_end(const Segment& s, Index end) { return s.a == end ? s.b : s.a; }

class Justification {
 public:
  Justification(Index t, const Subject& subject, const Domain& domain, const Adjacency& adjacency, const Chains& chains,
                const InputVertices& inputs)
      : t_(t),
        triangle_(adjacency.triangles()[t]),
        subject_(subject),
        domain_(domain),
        chains_(chains),
        inputs_(inputs) {}

  /// The cause of the angle at corner k.
  [[nodiscard]] std::optional<Justified> of_angle(int k) const {
    auto cause = nestled(k);
    return cause ? cause : across(k);
  }

  [[nodiscard]] Point corner(int k) const { return subject_.corner(triangle_, k); }

 private:
  /// The cause if corner k is an input vertex, both edges at this corner are pieces of segments, and these meet at less
  /// than 60 degrees. The least angle is that across a shell, for the rounding of the other two corners.
  [[nodiscard]] std::optional<Justified> nestled(int k) const {
    const Index apex = inputs_.input(triangle_.v[k]);
    const bool between_segments = chains_.has(t_, next(k)) && chains_.has(t_, previous(k));
    if (apex == no_index || !between_segments) return std::nullopt;
    const Index p = triangle_.v[next(k)], q = triangle_.v[previous(k)];
    const Index of_p = segment_between(apex, p), of_q = segment_between(apex, q);
    if (of_p == no_index || of_q == no_index) return std::nullopt;
    const Point centre = corner(k), at_p = subject_.mesh.points[p], at_q = subject_.mesh.points[q];
    const Point far_p = far_end(of_p, apex), far_q = far_end(of_q, apex);
    if (!exactly::cosine_exceeds(centre, far_p, far_q, shell_cosine)) return std::nullopt;
    if (is_below_least(centre, at_p, at_q, centre, far_p, far_q)) return std::nullopt;
    return justified(apex, angle_deg(centre, far_p, far_q));
  }

  [[nodiscard]] Point far_end(Index segment, Index apex) const {
    return subject_.pslg.points[other_end(domain_.segments()[segment], apex)];
  }

  /// The segment at the input point `apex` whose chain begins with the edge to this vertex, which belongs to a chain.
  [[nodiscard]] Index segment_between(Index apex, Index vertex) const {
    if (chains_.segment_of[vertex] != no_index) return chains_.segment_of[vertex];
    const Index input = inputs_.input(vertex);
    for (const Index s : domain_.faces().incident(apex))
      if (other_end(domain_.segments()[s], apex) == input) return s;
    return no_index;
  }

  /// The cause if the edge opposite corner k joins two vertices of one shell, and the angle is large enough. Straight
  /// paths of segments count as segments, but are needed for few domains.
  [[nodiscard]] std::optional<Justified> across(int k) const {
    auto cause = across(
        k, [&](Index vertex) { return segment_around(vertex); }, [&](Index s) { return segment(s); });
    if (cause) return cause;
    const StraightPaths& paths = domain_.straight_paths();
    return across(
        k, [&](Index vertex) { return path_around(paths, vertex); }, [&](Index s) { return paths.of(s); });
  }

  [[nodiscard]] const Segment& segment(Index s) const { return domain_.segments()[s]; }

  /// The segment of the domain in whose interior a vertex lies.
  [[nodiscard]] std::optional<Segment> segment_around(Index vertex) const {
    const Index s = chains_.segment_of[vertex];
    if (s == no_index || !domain_.has(s)) return std::nullopt;
    return segment(s);
  }
  /// The straight path in whose interior a vertex lies.
  [[nodiscard]] std::optional<Segment> path_around(const StraightPaths& paths, Index vertex) const {
    const Index s = chains_.segment_of[vertex], input = inputs_.input(vertex);
    if (s != no_index && domain_.has(s)) return paths.of(s);
    if (input != no_index) return paths.around(input);
    return std::nullopt;
  }

  /// The same with the segments that `around(vertex)` and `of(segment)` return.
  template <class Around, class Of>
  [[nodiscard]] std::optional<Justified> across(int k, const Around& around, const Of& of) const {
    const Index p = triangle_.v[next(k)], q = triangle_.v[previous(k)];
    const std::optional<Segment> of_p = around(p), of_q = around(q);
    if (of_p && of_q) return shell(k, p, *of_p, q, *of_q, shell_cosine);
    // One of them can be the end of a segment in a narrow wedge.
    const Index end = of_p ? q : p, beside = of_p ? p : q;
    const std::optional<Segment>& inside = of_p ? of_p : of_q;
    const Index input = inputs_.input(end);
    if (!inside || input == no_index) return std::nullopt;
    for (const Index s : domain_.faces().incident(input)) {
      if (!domain_.has(s)) continue;
      if (auto cause = shell(k, end, of(s), beside, *inside, narrow_cosine)) return cause;
    }
    return std::nullopt;
  }

  /// The cause of the angle at corner k if the segments of the vertices p and q meet at an angle with a larger cosine
  /// than `least`, if p and q have the same distance from their common end, and if the angle is large enough.
  [[nodiscard]] std::optional<Justified> shell(int k, Index p, const Segment& first, Index q, const Segment& second,
                                               double least) const {
    if (first == second) return std::nullopt;
    for (const Index apex : {first.a, first.b}) {
      if (apex != second.a && apex != second.b) continue;
      if (inputs_.vertex(apex) == p || inputs_.vertex(apex) == q) continue;
      const Point centre = subject_.pslg.points[apex];
      const Point far_s = subject_.pslg.points[other_end(first, apex)];
      const Point far_r = subject_.pslg.points[other_end(second, apex)];
      if (!exactly::cosine_exceeds(centre, far_s, far_r, least)) continue;
      const Point at_p = subject_.mesh.points[p], at_q = subject_.mesh.points[q];
      if (exactly::distances_differ(centre, at_p, at_q, shell_tolerance, shell_units * unit_at(centre, at_p, at_q)))
        continue;
      if (is_below_least(corner(k), at_p, at_q, centre, far_s, far_r)) continue;
      return justified(apex, angle_deg(centre, far_s, far_r));
    }
    return std::nullopt;
  }

  /// True if the angle at `from` between p and q, which lie on a shell around the apex, is smaller than the angle of
  /// the segments from the apex to `far_p` and `far_q` explains (across_tolerance, across_units).
  [[nodiscard]] static bool is_below_least(Point from, Point p, Point q, Point apex, Point far_p, Point far_q) {
    const double tangent = (1 - across_tolerance) * exactly::tangent_across_shell(apex, far_p, far_q);
    return exactly::tangent_is_below(from, p, q, tangent, across_units * unit_at(apex, p, q));
  }

  [[nodiscard]] double angle_at(int k) const { return angle_deg(corner(k), corner(next(k)), corner(previous(k))); }

  [[nodiscard]] Justified justified(Index apex, double input_angle) const {
    return {t_, apex, input_angle, std::min({angle_at(0), angle_at(1), angle_at(2)})};
  }

  Index t_;
  const Triangle& triangle_;
  const Subject& subject_;
  const Domain& domain_;
  const Chains& chains_;
  const InputVertices& inputs_;
};

}  // namespace

AngleVerdict judge_angles(Index t, double cosine_bound, const Subject& subject, const Domain& domain,
                          const Adjacency& adjacency, const Chains& chains, const InputVertices& inputs) {
  const Justification triangle(t, subject, domain, adjacency, chains, inputs);
  // The edge opposite corner k. The smallest angle is opposite the shortest edge.
  const auto is_shorter = [&](int k, int other) {
    return exactly::compare_lengths(triangle.corner(next(k)), triangle.corner(previous(k)),
                                    triangle.corner(next(other)), triangle.corner(previous(other))) < 0;
  };
  AngleVerdict verdict;
  int smallest = -1;
  for (int k = 0; k < 3; ++k) {
    if (!exactly::cosine_exceeds(triangle.corner(k), triangle.corner(next(k)), triangle.corner(previous(k)),
                                 cosine_bound))
      continue;
    auto cause = triangle.of_angle(k);
    if (!cause) {
      if (verdict.unjustified < 0 || is_shorter(k, verdict.unjustified)) verdict.unjustified = k;
    } else if (smallest < 0 || is_shorter(k, smallest)) {
      smallest = k;
      verdict.cause = std::move(cause);
    }
  }
  if (verdict.unjustified >= 0) verdict.cause.reset();
  return verdict;
}

}  // namespace pardel::checker
