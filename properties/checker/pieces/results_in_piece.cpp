#include "results_in_piece.hpp"

#include <algorithm>

namespace pardel::checker {

SpecialVertices::SpecialVertices(const Piece& piece, const NumberSet& special) {
  const std::span<const std::uint64_t> number = piece.number();
  for (Index v = 0; v < number.size(); ++v)
    if (special.contains(number[v])) by_number_.emplace_back(number[v], v);
  std::ranges::sort(by_number_);
}

Index SpecialVertices::find(std::uint64_t number) const {
  const auto at = std::ranges::lower_bound(by_number_, std::pair(number, Index{0}));
  return at != by_number_.end() && at->first == number ? at->second : no_index;
}

Chains chains_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special) {
  Chains chains;
  chains.segment_of.resize(piece.mesh().points.size(), no_index);
  chains.on_chain.resize(piece.mesh().triangles.size(), 0);
  std::vector<char> is_input(piece.mesh().points.size(), 0);
  for (const auto& at : judgement.vertices_of_inputs)
    if (const Index v = special.find(at.number); v != no_index) is_input[v] = 1;
  const Adjacency& adjacency = *piece.adjacency;
  for (const auto& [from_number, to_number, segment] : judgement.chains) {
    const Index from = special.find(from_number), to = special.find(to_number);
    if (from != no_index && is_input[from] == 0) chains.segment_of[from] = segment;
    if (from == no_index || to == no_index) continue;
    const ChainEdge edge{from, to, segment, adjacency.left_of(from, to), adjacency.left_of(to, from)};
    if (!edge.left.exists() && !edge.right.exists()) continue;
    chains.edges.push_back(edge);
    for (const TriangleEdge side : {edge.left, edge.right})
      if (side.exists())
        chains.on_chain[side.triangle] = static_cast<std::uint8_t>(chains.on_chain[side.triangle] | 1 << side.edge);
  }
  return chains;
}

InputVertices input_vertices_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special) {
  Array<Index> vertex(piece.subject.pslg.points.size(), no_index);
  for (const auto& at : judgement.vertices_of_inputs) vertex[at.input] = special.find(at.number);
  return {std::move(vertex), piece.mesh().points.size()};
}

}  // namespace pardel::checker
