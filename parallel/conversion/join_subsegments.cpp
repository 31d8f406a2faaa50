#include "join_subsegments.hpp"

#include <array>

namespace pardel::engine {
namespace {

class Joiner {
 public:
  Joiner(const Mesh& mesh, std::span<const ConstrainedEdge> pieces)
      : mesh_(mesh),
        pieces_(pieces),
        knows_origins_(mesh.origin.size() == mesh.points.size()),
        at_(mesh.points.size()),
        done_(pieces.size(), false) {
    for (Index p = 0; p < pieces.size(); ++p)
      for (const Index v : {pieces[p].a, pieces[p].b}) {
        if (at_[v].count < 2) at_[v].pieces[at_[v].count] = p;
        ++at_[v].count;
      }
    result_.origin.resize(mesh.points.size(), input_vertex);
    for (std::size_t v = 0; knows_origins_ && v < mesh.points.size(); ++v)
      if (mesh.origin[v] == interior_vertex) result_.origin[v] = interior_vertex;
  }

  Joined run() {
    for (Index p = 0; p < pieces_.size(); ++p) {
      if (done_[p]) continue;
      if (!passes(pieces_[p].a))
        follow(p, pieces_[p].a);
      else if (!passes(pieces_[p].b))
        follow(p, pieces_[p].b);
    }
    // Rings without an end are no segments, whatever the provenance says.
    for (Index p = 0; p < pieces_.size(); ++p)
      if (!done_[p]) add({pieces_[p].a, pieces_[p].b}, p);
    return std::move(result_);
  }

 private:
  struct At {
    Index count = 0;
    std::array<Index, 2> pieces{no_index, no_index};
  };

  /// The vertex lies in the interior of a line.
  [[nodiscard]] bool passes(Index v) const {
    if (!knows_origins_ || at_[v].count != 2) return false;
    const ConstrainedEdge &first = pieces_[at_[v].pieces[0]], &second = pieces_[at_[v].pieces[1]];
    const Index segment = mesh_.origin[v] == hull_vertex ? no_index : mesh_.origin[v];
    const bool was_put_there = mesh_.origin[v] != input_vertex && mesh_.origin[v] != interior_vertex;
    return was_put_there && first.segment == segment && second.segment == segment && first.marker == second.marker;
  }

  /// From an end of piece p that is an end of its line, to the line's other end.
  void follow(Index p, Index start) {
    const auto line = static_cast<Index>(result_.lines.size());
    const Index first = p;
    Index v = start;
    for (;;) {
      done_[p] = true;
      v = pieces_[p].a == v ? pieces_[p].b : pieces_[p].a;
      if (!passes(v)) break;
      result_.origin[v] = line;
      p = at_[v].pieces[0] == p ? at_[v].pieces[1] : at_[v].pieces[0];
    }
    add({start, v}, first);
  }

  void add(Constraint ends, Index piece) {
    result_.lines.push_back(ends);
    result_.segment_of_line.push_back(pieces_[piece].segment);
    result_.marker_of_line.push_back(pieces_[piece].marker);
  }

  const Mesh& mesh_;
  std::span<const ConstrainedEdge> pieces_;
  bool knows_origins_;
  std::vector<At> at_;
  std::vector<bool> done_;
  Joined result_;
};

}  // namespace

Joined join_pieces(const Mesh& mesh, std::span<const ConstrainedEdge> pieces) { return Joiner(mesh, pieces).run(); }

}  // namespace pardel::engine
