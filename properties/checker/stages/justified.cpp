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

  /// The justification if corner k is an input vertex and both edges at this corner are pieces of segments.
  [[nodiscard]] std::optional<Justified> nestled(int k) const {
    const Index apex = inputs_.input(triangle_.v[k]);
    const bool between_segments = chains_.has(t_, next(k)) && chains_.has(t_, previous(k));
    if (apex == no_index || !between_segments) return std::nullopt;
    // The edges at corner k: edge previous(k) runs to v[next(k)], edge next(k) to v[previous(k)].
    return justified(apex, angle_deg(corner(k), corner(next(k)), corner(previous(k))));
  }

  /// The justification if edge k joins two vertices of one shell.
  [[nodiscard]] std::optional<Justified> seditious(int k) const {
    const Index p = triangle_.v[next(k)], q = triangle_.v[previous(k)];
    for (const Index s : segments_at(p)) {
      for (const Index r : segments_at(q)) {
        if (s == r) continue;
        const auto found = shell(p, s, q, r);
        if (found) return found;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] Point corner(int k) const { return subject_.corner(triangle_, k); }

 private:
  [[nodiscard]] std::span<const Index> segments_at(Index vertex) const {
    const Index input = inputs_.input(vertex);
    if (input != no_index) return domain_.faces().incident(input);
    const Index& segment = chains_.segment_of[vertex];
    return segment == no_index ? std::span<const Index>{} : std::span<const Index>(&segment, 1);
  }

  /// The justification if segment s of vertex p and segment r of vertex q share an apex that has the same distance from
  /// p and from q.
  [[nodiscard]] std::optional<Justified> shell(Index p, Index s, Index q, Index r) const {
    const Segment& first = domain_.segments()[s];
    const Segment& second = domain_.segments()[r];
    for (const Index apex : {first.a, first.b}) {
      if (apex != second.a && apex != second.b) continue;
      if (!domain_.has(s) || !domain_.has(r)) continue;
      if (inputs_.vertex(apex) == p || inputs_.vertex(apex) == q) continue;
      const Point centre = subject_.pslg.points[apex];
      const Point far_s = subject_.pslg.points[other_end(first, apex)];
      const Point far_r = subject_.pslg.points[other_end(second, apex)];
      if (!exactly::cosine_exceeds(centre, far_s, far_r, shell_cosine)) continue;
      if (exactly::distances_differ(centre, subject_.mesh.points[p], subject_.mesh.points[q], shell_tolerance,
                                    shell_ulps * domain_.ulp()))
        continue;
      return justified(apex, angle_deg(centre, far_s, far_r));
    }
    return std::nullopt;
  }

  [[nodiscard]] Justified justified(Index apex, double input_angle) const {
    double smallest = 180;
    for (int k = 0; k < 3; ++k)
      smallest = std::min(smallest, angle_deg(corner(k), corner(next(k)), corner(previous(k))));
    return {t_, apex, input_angle, smallest};
  }

  Index t_;
  const Triangle& triangle_;
  const Subject& subject_;
  const Domain& domain_;
  const Chains& chains_;
  const InputVertices& inputs_;
};

}  // namespace

std::optional<Justified> justification(Index t, const Subject& subject, const Domain& domain,
                                       const Adjacency& adjacency, const Chains& chains, const InputVertices& inputs) {
  const Justification candidate(t, subject, domain, adjacency, chains, inputs);
  // Edge k is opposite corner k, and the smallest angle is opposite the shortest edge. If several edges are equally
  // short, a justification by one of them is enough.
  for (int k = 0; k < 3; ++k) {
    const Point from = candidate.corner(next(k)), to = candidate.corner(previous(k)), apex = candidate.corner(k);
    if (exactly::compare_lengths(from, to, to, apex) > 0 || exactly::compare_lengths(from, to, apex, from) > 0)
      continue;
    if (auto found = candidate.nestled(k)) return found;
    if (auto found = candidate.seditious(k)) return found;
  }
  return std::nullopt;
}

}  // namespace pardel::checker
