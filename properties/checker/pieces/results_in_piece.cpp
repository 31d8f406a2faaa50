#include "results_in_piece.hpp"

#include <numeric>

#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/message.hpp"

namespace pardel::checker {

Chains chains_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special) {
  Chains chains;
  chains.segment_of.resize(piece.mesh().points.size(), no_index);
  chains.on_chain.resize(piece.mesh().triangles.size(), 0);
  std::vector<char> is_input(piece.mesh().points.size(), 0);
  for (const std::uint64_t number : judgement.vertex_of_input)
    if (const Index v = special.find(number); v != no_index) is_input[v] = 1;
  for (const auto& [from_number, to_number, segment] : judgement.chains) {
    const Index from = special.find(from_number), to = special.find(to_number);
    if (from != no_index && is_input[from] == 0) chains.segment_of[from] = segment;
    if (from == no_index || to == no_index) continue;
    const ChainEdge edge{from, to, segment, piece.adjacency.left_of(from, to), piece.adjacency.left_of(to, from)};
    if (!edge.left.exists() && !edge.right.exists()) continue;
    chains.edges.push_back(edge);
    for (const TriangleEdge side : {edge.left, edge.right})
      if (side.exists())
        chains.on_chain[side.triangle] = static_cast<std::uint8_t>(chains.on_chain[side.triangle] | 1 << side.edge);
  }
  return chains;
}

InputVertices input_vertices_in_piece(const Piece& piece, const Judgement& judgement, const SpecialVertices& special) {
  Array<Index> vertex;
  for (const std::uint64_t number : judgement.vertex_of_input) vertex.push_back(special.find(number));
  return {std::move(vertex), piece.mesh().points.size()};
}

namespace {

/// Sets of triangles of one piece that are joined without crossing a chain. Each set has a number.
struct Regions {
  std::vector<Index> of_triangle;
  std::vector<Index> face;  ///< per set: the face of the domain at its chain edges, or no_index
};

Regions regions_in_piece(const Piece& piece, const Domain& domain, const Chains& chains) {
  Regions regions;
  const auto triangles = piece.adjacency.triangles();
  regions.of_triangle.assign(triangles.size(), no_index);
  std::vector<Index> stack;
  for (Index first = 0; first < triangles.size(); ++first) {
    if (regions.of_triangle[first] != no_index) continue;
    const auto number = static_cast<Index>(regions.face.size());
    regions.face.push_back(no_index);
    regions.of_triangle[first] = number;
    for (stack.push_back(first); !stack.empty();) {
      const Index t = stack.back();
      stack.pop_back();
      for (int side = 0; side < 3; ++side) {
        const Index n = triangles[t].n[side];
        if (n == no_index || chains.has(t, side) || regions.of_triangle[n] != no_index) continue;
        regions.of_triangle[n] = number;
        stack.push_back(n);
      }
    }
  }
  for (const ChainEdge& edge : chains.edges)
    for (const Side side : {Side::left, Side::right}) {
      const TriangleEdge triangle = side == Side::left ? edge.left : edge.right;
      if (!triangle.exists()) continue;
      Index& face = regions.face[regions.of_triangle[triangle.triangle]];
      if (face == no_index) face = domain.faces().face(edge.segment, side);
    }
  return regions;
}

/// Two sets of different pieces that are joined across a border.
struct Link {
  std::int32_t rank, other_rank;
  Index set, other_set;
};

/// Each rank tells the ranks across its border which set lies there.
std::vector<Link> links_of_piece(const Piece& piece, const Chains& chains, const Regions& regions,
                                 std::span<const BorderSide> border) {
  struct Told {
    Index triangle, set;
  };
  const auto count = static_cast<std::size_t>(piece.ranks.count());
  std::vector<std::vector<Told>> told(count);
  for (const auto& [edge, across] : border)
    if (across.exists() && !chains.has(edge.left.triangle, edge.left.edge))
      told[across.rank].push_back({across.place, regions.of_triangle[edge.left.triangle]});
  std::vector<Link> links;
  const std::vector<std::vector<Told>> arrived = exchange_lists(told, piece.ranks);
  for (int rank = 0; rank < piece.ranks.count(); ++rank)
    for (const auto& [triangle, set] : arrived[rank])
      links.push_back({piece.ranks.rank(), rank, regions.of_triangle.at(triangle), set});
  return links;
}

/// On the first rank: the faces of all sets, after sets that are joined have told each other their faces.
class Unions {
 public:
  explicit Unions(const std::vector<Ranks::Bytes>& messages) {
    std::vector<Link> links;
    for (const Ranks::Bytes& message : messages) {
      Reader reader(message);
      first_.push_back(static_cast<Index>(face_.size()));
      const auto faces = reader.list<Index>();
      face_.insert(face_.end(), faces.begin(), faces.end());
      const auto more = reader.list<Link>();
      links.insert(links.end(), more.begin(), more.end());
    }
    first_.push_back(static_cast<Index>(face_.size()));
    parent_.resize(face_.size());
    std::iota(parent_.begin(), parent_.end(), Index{0});
    for (const Link& link : links) join(first_.at(link.rank) + link.set, first_.at(link.other_rank) + link.other_set);
  }

  [[nodiscard]] std::vector<Index> faces_of(std::size_t rank) {
    std::vector<Index> faces;
    for (Index set = first_[rank]; set < first_[rank + 1]; ++set) faces.push_back(face_[find(set)]);
    return faces;
  }

 private:
  Index find(Index set) {
    while (parent_.at(set) != set) set = parent_[set] = parent_[parent_[set]];
    return set;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a == b) return;
    if (face_[a] == no_index) std::swap(a, b);
    parent_[b] = a;
  }

  std::vector<Index> first_;  ///< per rank: its first set
  std::vector<Index> face_, parent_;
};

}  // namespace

std::vector<Index> faces_in_piece(const Piece& piece, const Domain& domain, const Chains& chains,
                                  std::span<const BorderSide> border) {
  Regions regions = regions_in_piece(piece, domain, chains);
  Writer message;
  message.list(regions.face);
  message.list(links_of_piece(piece, chains, regions, border));
  const std::vector<Ranks::Bytes> messages = to_first(message.take(), piece.ranks);
  std::vector<std::vector<Index>> answers(static_cast<std::size_t>(piece.ranks.count()));
  if (piece.ranks.rank() == 0) {
    Unions unions(messages);
    for (std::size_t rank = 0; rank < answers.size(); ++rank) answers[rank] = unions.faces_of(rank);
  }
  const std::vector<Index> faces = std::move(exchange_lists(answers, piece.ranks).front());
  std::vector<Index> result = std::move(regions.of_triangle);
  for (Index& set : result) set = faces.at(set);
  return result;
}

}  // namespace pardel::checker
