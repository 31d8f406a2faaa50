#include "kept_piece.hpp"

#include "../stages/verdict.hpp"

namespace pardel::checker {
namespace {

/// True if no stage finds anything without chains.
bool is_clear_without_chains(const Piece& piece, const InputOfPieces& input) {
  const Subject& subject = piece.subject;
  Chains none;
  none.segment_of.resize(piece.mesh().points.size(), no_index);
  none.on_chain.resize(piece.mesh().triangles.size(), 0);
  Findings found(0);
  std::vector<Justified> justified;
  if (piece.sanity.labels && subject.pslg.regions.empty()) check_regions(subject, input.domain, {}, found);
  check_delaunay(subject, *piece.adjacency, none, piece.scanned, found);
  check_goal(subject, input.domain, *piece.adjacency, none, InputVertices::by_index(0, 0), {}, input.wanted,
             piece.scanned, found, justified);
  return justified.empty() && std::ranges::all_of(found.counts(), [](std::uint64_t count) { return count == 0; });
}

}  // namespace

KeptPiece kept_piece(const Piece& piece, const InputOfPieces* input, NumberSet& settled) {
  const Mesh& mesh = piece.mesh();
  KeptPiece kept;
  kept.points = mesh.points.size();
  kept.triangles = mesh.triangles.size();
  kept.listed_edges = mesh.constrained_edges.size();
  kept.has_geometry = piece.sanity.geometry;
  kept.has_labels = piece.sanity.labels;
  const LabelsOfMesh labels = labels_of(mesh);
  kept.has_regions = labels.regions;
  kept.has_attributes = labels.attributes;
  kept.has_markers = labels.markers;
  kept.is_described = piece.found > 0;
  if (!piece.sanity.geometry || input == nullptr) return kept;
  kept.is_counter_clockwise = piece.is_counter_clockwise;
  kept.is_clear = piece.found == 0 && is_clear_without_chains(piece, *input);
  kept.open = piece.scanned.open.size();
  kept.measures = piece.scanned.measures;
  if (piece.sanity.labels) kept.digest = digest(mesh);
  kept.part = part_to_keep(piece, input->places, input->free, input->ranges, settled);
  return kept;
}

}  // namespace pardel::checker
