#include "skeleton.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/message.hpp"

namespace pardel::checker {

NumberSet special_numbers(const PiecesRead& read, const Border& border, Ranks& ranks) {
  std::vector<Index> here;
  for (std::size_t i = 0; i < read.pieces.size(); ++i) {
    const KeptPart& part = read.pieces[i].part;
    for (const KeptVertex& vertex : part.vertices)
      if (vertex.is_special) here.push_back(vertex.number);
    const std::span<const Across> across = border.of(i);
    for (std::size_t s = 0; s < across.size(); ++s)
      if (!across[s].exists())
        for (const Index end : {part.sides[s].from, part.sides[s].to}) here.push_back(part.vertices[end].number);
  }
  NumberSet special;
  for (const std::vector<Index>& of_rank : lists_of_all(here, ranks))
    for (const Index number : of_rank) special.insert(number);
  return special;
}

NumberSet settled_inputs(const PiecesRead& read, std::size_t inputs, Ranks& ranks) {
  // Each rank puts together a range of words, so that none gets more than all words.
  const std::vector<std::uint64_t> here = read.settled.words(0, inputs);
  const std::size_t share = here.size() / static_cast<std::size_t>(ranks.count()) + 1;
  std::vector<std::vector<std::uint64_t>> ranges(static_cast<std::size_t>(ranks.count()));
  for (std::size_t i = 0; i < here.size(); ++i) ranges[i / share].push_back(here[i]);
  std::vector<std::uint64_t> range;
  const std::vector<std::vector<std::uint64_t>> of_ranks = exchange_lists(std::move(ranges), ranks);
  for (const std::vector<std::uint64_t>& of_rank : of_ranks) {
    range.resize(of_rank.size());
    std::ranges::transform(range, of_rank, range.begin(), std::bit_or<>());
  }
  Writer message;
  message.list(range);
  std::vector<std::uint64_t> all;
  for (const Ranks::Bytes& from : to_first(message.take(), ranks)) {
    if (from.empty()) continue;  // on the other ranks
    const auto words = Reader(from).list<std::uint64_t>();
    all.insert(all.end(), words.begin(), words.end());
  }
  return NumberSet(all);
}

namespace {

/// A triangle of the skeleton. Its corners are the numbers of vertices.
struct TravellingTriangle {
  std::array<Index, 3> v;
  Index name;
};

/// What one piece contributes.
void contribute(const KeptPiece& piece, Index first_triangle, const NumberSet& special, Writer& message) {
  const KeptPart& part = piece.part;
  std::vector<char> is_special, is_in;
  for (const KeptVertex& vertex : part.vertices) is_special.push_back(special.contains(vertex.number) ? 1 : 0);
  is_in = is_special;
  std::vector<TravellingTriangle> triangles;
  for (const auto& [v, triangle] : part.triangles) {
    if ((is_special[v[0]] | is_special[v[1]] | is_special[v[2]]) == 0) continue;
    for (const Index corner : v) is_in[corner] = 1;
    triangles.push_back({{part.vertices[v[0]].number, part.vertices[v[1]].number, part.vertices[v[2]].number},
                         first_triangle + triangle});
  }
  const std::size_t k = part.kinds.attributes_per_point;
  std::vector<KeptVertex> vertices;
  std::vector<double> attributes;
  for (std::size_t v = 0; v < part.vertices.size(); ++v) {
    if (is_in[v] == 0) continue;
    vertices.push_back(part.vertices[v]);
    vertices.back().is_special = is_special[v] != 0;
    const auto first = part.attributes.begin() + static_cast<std::ptrdiff_t>(v * k);
    attributes.insert(attributes.end(), first, first + static_cast<std::ptrdiff_t>(k));
  }
  message.list(std::vector{part.kinds});
  message.list(vertices);
  message.list(attributes);
  message.list(triangles);
  message.list(part.edges);
}

/// Puts the contributions together. A vertex at a border comes from several pieces, which agree on its data.
class Assembly {
 public:
  void read(const Ranks::Bytes& message) {
    for (Reader reader(message); !reader.empty();) read_piece(reader);
  }

  [[nodiscard]] Skeleton assembled() {
    Skeleton skeleton;
    Mesh& mesh = skeleton.mesh;
    mesh.attributes_per_point = kinds_ ? kinds_->attributes_per_point : 0;
    std::ranges::stable_sort(vertices_, {}, [](const Vertex& v) { return v.what.number; });
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const KeptVertex& vertex = vertices_[i].what;
      if (i > 0 && vertices_[i - 1].what.number == vertex.number) continue;
      skeleton.vertices.push_back(vertex.number);
      skeleton.is_special.push_back(vertex.is_special ? 1 : 0);
      mesh.points.push_back(vertex.at);
      if (kinds_->markers != 0) mesh.point_markers.push_back(vertex.marker);
      if (kinds_->origins != 0) mesh.origin.push_back(vertex.origin);
      for (const double attribute : attributes_of(vertices_[i])) mesh.point_attributes.push_back(attribute);
    }
    const auto place = [&](Index number) {
      return static_cast<Index>(std::ranges::lower_bound(skeleton.vertices, number) - skeleton.vertices.begin());
    };
    for (const auto& [v, name] : triangles_) {
      mesh.triangles.push_back({{place(v[0]), place(v[1]), place(v[2])}});
      skeleton.triangles.push_back(name);
    }
    for (const auto& [a, b, segment, marker] : edges_)
      mesh.constrained_edges.push_back({place(a), place(b), segment, marker});
    return skeleton;
  }

 private:
  struct Vertex {
    KeptVertex what;
    std::size_t first_attribute;
  };

  void read_piece(Reader& reader) {
    const KindsOfData kinds = reader.list<KindsOfData>().at(0);
    const auto vertices = reader.list<KeptVertex>();
    const auto attributes = reader.list<double>();
    const auto triangles = reader.list<TravellingTriangle>();
    const auto edges = reader.list<KeptEdge>();
    if (!vertices.empty()) kinds_ = kinds;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices_.push_back({vertices[i], attributes_.size() + i * kinds.attributes_per_point});
    attributes_.insert(attributes_.end(), attributes.begin(), attributes.end());
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
  }

  [[nodiscard]] std::span<const double> attributes_of(const Vertex& vertex) const {
    return std::span(attributes_).subspan(vertex.first_attribute, kinds_->attributes_per_point);
  }

  std::optional<KindsOfData> kinds_;  ///< the same for all pieces with vertices
  std::vector<Vertex> vertices_;
  std::vector<double> attributes_;
  std::vector<TravellingTriangle> triangles_;
  std::vector<KeptEdge> edges_;
};

}  // namespace

std::optional<Skeleton> gather_skeleton(const PiecesRead& read, const NumberSet& special, Ranks& ranks) {
  Writer message;
  for (std::size_t i = 0; i < read.pieces.size(); ++i)
    contribute(read.pieces[i], read.first_triangle[i], special, message);
  const std::vector<Ranks::Bytes> messages = to_first(message.take(), ranks);
  if (ranks.rank() != 0) return {};
  Assembly assembly;
  for (const Ranks::Bytes& from : messages) assembly.read(from);
  return assembly.assembled();
}

}  // namespace pardel::checker
