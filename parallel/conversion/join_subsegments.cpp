#include "join_subsegments.hpp"

#include <array>

namespace pardel::engine {
namespace {

class Joiner {
 public:
  Joiner(const Mesh& mesh, std::span<const ConstrainedEdge> subsegments, const Threads& threads)
      : mesh_(mesh),
        subsegments_(subsegments),
        has_origins_(mesh.origin.size() == mesh.points.size()),
        at_(mesh.points.size()),
        done_(subsegments.size(), false),
        ask_(threads.stop) {
    for (Index s = 0; s < subsegments.size(); ++s) {
      ask_();
      for (const Index v : {subsegments[s].a, subsegments[s].b}) {
        if (at_[v].count < 2) at_[v].subsegments[at_[v].count] = s;
        ++at_[v].count;
      }
    }
    result_.origin.resize(mesh.points.size(), input_vertex);
    for (std::size_t v = 0; has_origins_ && v < mesh.points.size(); ++v)
      if (mesh.origin[v] == interior_vertex) result_.origin[v] = interior_vertex;
  }

  JoinedSegments run() {
    for (Index s = 0; s < subsegments_.size(); ++s) {
      if (done_[s]) continue;
      if (!is_inside_segment(subsegments_[s].a))
        follow(s, subsegments_[s].a);
      else if (!is_inside_segment(subsegments_[s].b))
        follow(s, subsegments_[s].b);
    }
    // A closed ring of subsegments is not a segment, even if all its vertices have the same segment as origin.
    for (Index s = 0; s < subsegments_.size(); ++s)
      if (!done_[s]) add({subsegments_[s].a, subsegments_[s].b}, s);
    return std::move(result_);
  }

 private:
  /// The subsegments that end at a vertex: their number and the first two.
  struct Incident {
    Index count = 0;
    std::array<Index, 2> subsegments{no_index, no_index};
  };

  /// True if the vertex lies in the interior of a segment.
  [[nodiscard]] bool is_inside_segment(Index v) const {
    if (!has_origins_ || at_[v].count != 2) return false;
    const ConstrainedEdge& first = subsegments_[at_[v].subsegments[0]];
    const ConstrainedEdge& second = subsegments_[at_[v].subsegments[1]];
    const Index segment = mesh_.origin[v] == hull_vertex ? no_index : segment_of_origin(mesh_.origin[v]);
    const bool was_inserted = mesh_.origin[v] != input_vertex && mesh_.origin[v] != interior_vertex;
    return was_inserted && first.segment == segment && second.segment == segment && first.marker == second.marker;
  }

  /// Adds the segment that starts at `start` with subsegment s.
  void follow(Index s, Index start) {
    const auto segment = static_cast<Index>(result_.segments.size());
    const Index first = s;
    Index v = start;
    for (;;) {
      ask_();
      done_[s] = true;
      v = subsegments_[s].a == v ? subsegments_[s].b : subsegments_[s].a;
      if (!is_inside_segment(v)) break;
      result_.origin[v] = origin_on_segment(segment);
      s = at_[v].subsegments[0] == s ? at_[v].subsegments[1] : at_[v].subsegments[0];
    }
    add({start, v}, first);
  }

  void add(Constraint ends, Index subsegment) {
    result_.segments.push_back(ends);
    result_.input_segment.push_back(subsegments_[subsegment].segment);
    result_.segment_marker.push_back(subsegments_[subsegment].marker);
  }

  const Mesh& mesh_;
  std::span<const ConstrainedEdge> subsegments_;
  bool has_origins_;
  std::vector<Incident> at_;
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
