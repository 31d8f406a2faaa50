#include "faces_in_pieces.hpp"

#include <numeric>
#include <utility>

#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/message.hpp"

namespace pardel::checker {

JoinedTriangles joined_triangles(const Piece& piece, const Domain& domain, const Chains& chains) {
  JoinedTriangles sets;
  const auto triangles = piece.adjacency->triangles();
  sets.set_of_triangle.assign(triangles.size(), no_index);
  std::vector<Index> stack;
  for (Index first = 0; first < triangles.size(); ++first) {
    if (sets.set_of_triangle[first] != no_index) continue;
    const auto set = static_cast<Index>(sets.face.size());
    sets.face.push_back(no_index);
    sets.set_of_triangle[first] = set;
    for (stack.push_back(first); !stack.empty();) {
      const Index t = stack.back();
      stack.pop_back();
      for (int side = 0; side < 3; ++side) {
        const Index n = triangles[t].n[side];
        if (n == no_index || chains.has(t, side) || sets.set_of_triangle[n] != no_index) continue;
        sets.set_of_triangle[n] = set;
        stack.push_back(n);
      }
    }
  }
  for (const ChainEdge& edge : chains.edges)
    for (const Side side : {Side::left, Side::right}) {
      const TriangleEdge triangle = side == Side::left ? edge.left : edge.right;
      if (!triangle.exists()) continue;
      Index& face = sets.face[sets.set_of_triangle[triangle.triangle]];
      if (face == no_index) face = domain.faces().face(edge.segment, side);
    }
  return sets;
}

namespace {

/// Two sets of different pieces that are joined across a border.
struct Link {
  std::int32_t rank, other_rank;
  Index set, other_set;
};

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

void FacesOfPieces::add(const JoinedTriangles& sets, const KeptPart& part, const Chains& chains) {
  const auto first = static_cast<Index>(face_.size());
  first_.push_back(first);
  face_.insert(face_.end(), sets.face.begin(), sets.face.end());
  for (const KeptSide& side : part.sides)
    at_side_.push_back({first + sets.set_of_triangle[side.triangle], chains.has(side.triangle, side.side)});
}

void FacesOfPieces::unite(const Border& border, Ranks& ranks) {
  struct Told {
    Index side, set;
  };
  const auto count = static_cast<std::size_t>(ranks.count());
  std::vector<std::vector<Told>> told(count);
  for (std::size_t piece = 0; piece < first_.size(); ++piece) {
    const std::span<const Across> across = border.of(piece);
    for (std::size_t s = 0; s < across.size(); ++s) {
      const SetAtSide& here = at_side_[border.first(piece) + s];
      if (across[s].exists() && !here.on_chain)
        told[static_cast<std::size_t>(across[s].rank)].push_back({across[s].side, here.set});
    }
  }
  const std::vector<std::vector<Told>> arrived = exchange_lists(std::move(told), ranks);
  std::vector<Link> links;
  for (int rank = 0; rank < ranks.count(); ++rank)
    for (const auto& [side, set] : arrived[static_cast<std::size_t>(rank)])
      links.push_back({ranks.rank(), rank, at_side_.at(side).set, set});
  Writer message;
  message.list(face_);
  message.list(links);
  const std::vector<Ranks::Bytes> messages = to_first(message.take(), ranks);
  std::vector<std::vector<Index>> answers(count);
  if (ranks.rank() == 0) {
    Unions unions(messages);
    for (std::size_t rank = 0; rank < count; ++rank) answers[rank] = unions.faces_of(rank);
  }
  face_ = std::move(exchange_lists(std::move(answers), ranks).front());
}

std::vector<Index> FacesOfPieces::faces_of(std::size_t piece, JoinedTriangles sets) const {
  std::vector<Index> faces = std::move(sets.set_of_triangle);
  for (Index& set : faces) set = face_.at(first_[piece] + set);
  return faces;
}

}  // namespace pardel::checker
