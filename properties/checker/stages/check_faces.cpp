// Checks that the chains divide the plane as the segments do: each face of the segments corresponds to one face of the
// chains, with the same sides of segments around it and the same isolated points in it. Holes and the outside count,
// too; what only segments outside the domain divide is one face.
//
// The earlier stages have found that the graph of the chains is that of the segments, with the same order around each
// vertex. So the sides around a face are the same in both, component by component. Here remains which components lie in
// which face.
#include <cmath>
#include <limits>

#include "../arithmetic/measure.hpp"
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

class FaceComparison {
 public:
  FaceComparison(const Subject& subject, const Domain& domain, const Chains& chains, const ChainGraph& graph)
      : subject_(subject),
        domain_(domain),
        chains_(chains),
        graph_(graph),
        place_of_face_(domain.places_of_faces()),
        of_input_(domain.faces().count()),
        of_mesh_(graph.faces().count()) {
    of_input_[place_of_face_[PlanarFaces::exterior()]].partner = PlanarFaces::exterior();
    of_mesh_[PlanarFaces::exterior()].partner = place_of_face_[PlanarFaces::exterior()];
  }

  void check_sides(Findings& found) {
    SparseAsk ask(found.stop());
    for (std::size_t i = 0; i < chains_.edges.size(); ++i) {
      ask();
      for (const Side side : {Side::left, Side::right}) {
        const Index face = graph_.face(i, side);
        if (face != no_index) pair(i, side, face, found);
      }
    }
  }

  void check_isolated_points(Findings& found) const {
    const auto& points = subject_.pslg.points;
    check_each(points.size(), found, [&](std::size_t i, Findings& mine) {
      const auto input = static_cast<Index>(i);
      if (!domain_.faces().incident(input).empty()) return;
      const Index face = domain_.faces().face_at(points[i]);
      if (!domain_.inside(face)) return;
      const Index in_mesh = graph_.faces().face_at(points[i]);
      if (in_mesh != no_index && of_mesh_[in_mesh].partner == face) return;
      mine.add(ViolationKind::wrong_face, {input}, {points[i]},
               "input point " + domain_number(i) + " lies on one side of " + nearest_segment(points[i]) +
                   " in the domain, and on the other side of its edges in the mesh");
    });
  }

 private:
  /// The face of the other graph that corresponds to a face, and where both were seen first.
  struct Partner {
    Index partner = no_index;
    std::size_t seen_at = 0;  ///< in Chains::edges
    bool has_place = false;   ///< false for the outside, before a chain was seen there
  };

  void pair(std::size_t i, Side side, Index face, Findings& found) {
    const Index place = place_of_face_[domain_.faces().face(chains_.edges[i].segment, side)];
    Partner& of_input = of_input_[place];
    Partner& of_mesh = of_mesh_[face];
    if (of_input.partner == no_index && of_mesh.partner == no_index) {
      of_input = {face, i, true};
      of_mesh = {place, i, true};
    } else if (of_input.partner != face || of_mesh.partner != place) {
      const bool joined = of_mesh.partner != no_index && of_mesh.partner != place;
      report(i, side, joined, joined ? of_mesh : of_input, found);
    }
  }

  void report(std::size_t i, Side side, bool joined, const Partner& other, Findings& found) const {
    const ChainEdge& edge = chains_.edges[i];
    std::vector<Index> ids{edge.segment};
    if (other.has_place) ids.push_back(chains_.edges[other.seen_at].segment);
    found.add(ViolationKind::wrong_face, std::move(ids),
              {subject_.mesh.points[edge.from], subject_.mesh.points[edge.to]},
              "the face on the " + std::string(side == Side::left ? "left" : "right") + " of " +
                  segment_text(domain_, edge.segment) +
                  (joined ? " is joined in the mesh with the face beside "
                          : " is cut off in the mesh from its part beside ") +
                  (other.has_place ? segment_text(domain_, chains_.edges[other.seen_at].segment) : "the outside"));
  }

  [[nodiscard]] Witness nearest_segment(Point p) const {
    Witness nearest = "a segment";
    double least = std::numeric_limits<double>::infinity();
    for (const ChainEdge& edge : chains_.edges) {
      const Point a = subject_.mesh.points[edge.from], b = subject_.mesh.points[edge.to];
      const double off = std::abs(doubled_area(a, b, p)) / distance(a, b);
      const double away = off + std::max(0.0, distance(a, p) + distance(p, b) - distance(a, b));
      if (away < least) {
        least = away;
        nearest = segment_text(domain_, edge.segment);
      }
    }
    return nearest;
  }

  const Subject& subject_;
  const Domain& domain_;
  const Chains& chains_;
  const ChainGraph& graph_;
  std::vector<Index> place_of_face_;
  std::vector<Partner> of_input_, of_mesh_;
};

}  // namespace

void check_faces(const Subject& subject, const Domain& domain, const Chains& chains, const ChainGraph& graph,
                 Findings& found) {
  using enum ViolationKind;
  // Faces have no meaning where chains are missing, or where edges cross or are covered on the wrong side.
  for (const ViolationKind kind : {degenerate_triangle, missing_input_vertex, broken_segment, overlap, uncovered_domain,
                                   covered_exterior, chains_meet, wrong_chain_order})
    if (found.count(kind) > 0) return;
  FaceComparison comparison(subject, domain, chains, graph);
  comparison.check_sides(found);
  if (found.count(wrong_face) == 0) comparison.check_isolated_points(found);
}

}  // namespace pardel::checker
