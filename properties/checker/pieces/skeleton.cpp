#include "skeleton.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "../../../core/support/agree.hpp"
#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/message.hpp"
#include "../../../core/support/point_order.hpp"
#include "../../../core/support/same_attribute.hpp"

namespace pardel::checker {
namespace {

/// Which of these points are at one of the places.
class Places {
 public:
  explicit Places(std::span<const Point> places) : sorted_(places.begin(), places.end()) {
    std::ranges::sort(sorted_, lexicographically_less);
  }
  [[nodiscard]] bool contains(Point p) const {
    const auto at = std::ranges::lower_bound(sorted_, p, lexicographically_less);
    return at != sorted_.end() && *at == p;
  }

 private:
  std::vector<Point> sorted_;
};

Array<char> special_in_piece(const Piece& piece, std::span<const BorderSide> border) {
  const Mesh& mesh = piece.mesh();
  const std::vector<Point>& inputs = piece.subject.pslg.points;
  const Places places(inputs);
  const bool has_markers = mesh.point_markers.size() == mesh.points.size();
  const bool has_origins = mesh.origin.size() == mesh.points.size();
  Array<char> is_special(mesh.points.size(), 0);
  for_each_index(mesh.points.size(), nullptr, [&](std::size_t v, std::size_t) {
    if (!piece.adjacency.has_triangle(static_cast<Index>(v)) || piece.number[v] < inputs.size() ||
        places.contains(mesh.points[v]) || (has_markers && mesh.point_markers[v] != 0) ||
        (has_origins && mesh.origin[v] != interior_vertex))
      is_special[v] = 1;
  });
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    for (const Index end : {edge.a, edge.b})
      if (end < is_special.size()) is_special[end] = 1;
  for (const auto& [edge, across] : border)
    if (!across.exists()) is_special[edge.from] = is_special[edge.to] = 1;
  return is_special;
}

struct TravellingVertex {
  std::uint64_t number;
  Point at;
  Index origin;
  std::int32_t marker;
  bool is_special;
};

struct TravellingTriangle {
  std::array<std::uint64_t, 3> v;
  Index name;
};

struct TravellingEdge {
  std::uint64_t a, b;
  Index segment;
  std::int32_t marker;
};

/// What one rank contributes.
Ranks::Bytes contribution(const Piece& piece, const SpecialVertices& special) {
  const Mesh& mesh = piece.mesh();
  const bool has_labels = mesh.point_markers.size() == mesh.points.size();
  const bool has_origins = mesh.origin.size() == mesh.points.size();
  const std::size_t k = mesh.attributes_per_point;
  const bool has_attributes = mesh.point_attributes.size() == k * mesh.points.size();
  std::vector<char> is_in(mesh.points.size(), 0);
  std::vector<TravellingTriangle> triangles;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t].v;
    if (!std::ranges::any_of(v, [&](Index corner) { return special.contains(corner); })) continue;
    for (const Index corner : v) is_in[corner] = 1;
    triangles.push_back(
        {{piece.number[v[0]], piece.number[v[1]], piece.number[v[2]]}, piece.subject.names.triangle(t)});
  }
  std::vector<TravellingVertex> vertices;
  std::vector<double> attributes;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    if (is_in[v] == 0 && !special.contains(v)) continue;
    vertices.push_back({piece.number[v], mesh.points[v], has_origins ? mesh.origin[v] : interior_vertex,
                        has_labels ? mesh.point_markers[v] : 0, special.contains(v)});
    for (std::size_t i = 0; has_attributes && i < k; ++i) attributes.push_back(mesh.point_attributes[v * k + i]);
  }
  std::vector<TravellingEdge> edges;
  for (const ConstrainedEdge& edge : mesh.constrained_edges)
    if (std::max(edge.a, edge.b) < mesh.points.size())
      edges.push_back({piece.number[edge.a], piece.number[edge.b], edge.segment, edge.marker});
  Writer message;
  message.list(std::vector<std::uint64_t>{has_labels, has_origins, has_attributes ? k : 0});
  message.list(vertices);
  message.list(attributes);
  message.list(triangles);
  message.list(edges);
  return message.take();
}

/// Puts the contributions together. A vertex at a border comes from several ranks.
class Assembly {
 public:
  void read(const Ranks::Bytes& message) {
    Reader reader(message);
    const auto kinds = reader.list<std::uint64_t>();
    const auto vertices = reader.list<TravellingVertex>();
    const auto attributes = reader.list<double>();
    const auto triangles = reader.list<TravellingTriangle>();
    const auto edges = reader.list<TravellingEdge>();
    if (!vertices.empty()) {
      has_markers_ = has_markers_ || kinds.at(0) != 0;
      has_origins_ = has_origins_ || kinds.at(1) != 0;
      attributes_per_point_ = std::max<std::size_t>(attributes_per_point_, kinds.at(2));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::size_t k = kinds.at(2);
      const auto first = attributes.begin() + static_cast<std::ptrdiff_t>(i * k);
      vertices_.push_back({vertices[i], {first, first + static_cast<std::ptrdiff_t>(k)}});
    }
    triangles_.insert(triangles_.end(), triangles.begin(), triangles.end());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
  }

  /// Error: pieces do not agree on the data of a vertex.
  [[nodiscard]] Result<Skeleton> assembled() {
    Skeleton skeleton;
    Mesh& mesh = skeleton.mesh;
    mesh.attributes_per_point = attributes_per_point_;
    std::ranges::stable_sort(vertices_, {}, [](const Vertex& v) { return v.what.number; });
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      const TravellingVertex& vertex = vertices_[i].what;
      if (i > 0 && vertices_[i - 1].what.number == vertex.number) {
        if (!has_same_data(vertices_[i - 1], vertices_[i]))
          return Error{ErrorKind::invalid_input,
                       "two pieces have different data of the point with the number " + std::to_string(vertex.number)};
        continue;
      }
      skeleton.vertices.push_back(vertex.number);
      skeleton.is_special.push_back(vertex.is_special ? 1 : 0);
      mesh.points.push_back(vertex.at);
      if (has_markers_) mesh.point_markers.push_back(vertex.marker);
      if (has_origins_) mesh.origin.push_back(vertex.origin);
      std::vector<double> attributes = vertices_[i].attributes;
      attributes.resize(attributes_per_point_);
      for (const double attribute : attributes) mesh.point_attributes.push_back(attribute);
    }
    const auto place = [&](std::uint64_t number) {
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
    TravellingVertex what;
    std::vector<double> attributes;
  };
  static bool has_same_data(const Vertex& a, const Vertex& b) {
    return a.what.marker == b.what.marker && a.what.origin == b.what.origin &&
           std::ranges::equal(a.attributes, b.attributes, is_same_attribute);
  }

  bool has_markers_ = false, has_origins_ = false;
  std::size_t attributes_per_point_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<TravellingTriangle> triangles_;
  std::vector<TravellingEdge> edges_;
};

}  // namespace

SpecialVertices::SpecialVertices(const Piece& piece, std::span<const BorderSide> border)
    : is_special_(special_in_piece(piece, border)) {
  std::vector<std::uint64_t> numbers;
  for (Index v = 0; v < is_special_.size(); ++v)
    if (is_special_[v] != 0) numbers.push_back(piece.number[v]);
  std::vector<bool> is_special_number(piece.points);
  for (const std::uint64_t number : concatenated(lists_of_all(numbers, piece.ranks)))
    is_special_number.at(number) = true;
  for (Index v = 0; v < is_special_.size(); ++v) {
    if (!is_special_number[piece.number[v]]) continue;
    is_special_[v] = 1;
    by_number_.emplace_back(piece.number[v], v);
  }
  std::ranges::sort(by_number_);
}

Index SpecialVertices::find(std::uint64_t number) const {
  const auto at = std::ranges::lower_bound(by_number_, std::pair(number, Index{0}));
  return at != by_number_.end() && at->first == number ? at->second : no_index;
}

Result<std::optional<Skeleton>> gather_skeleton(const Piece& piece, const SpecialVertices& special) {
  const std::vector<Ranks::Bytes> messages = to_first(contribution(piece, special), piece.ranks);
  std::optional<Skeleton> skeleton;
  Status fits = Done{};
  if (piece.ranks.rank() == 0) {
    Assembly assembly;
    for (const Ranks::Bytes& message : messages) assembly.read(message);
    Result<Skeleton> assembled = assembly.assembled();
    if (assembled)
      skeleton = std::move(*assembled);
    else
      fits = assembled.error();
  }
  if (Status all = agree(fits, piece.ranks); !all) return all.error();
  return skeleton;
}

}  // namespace pardel::checker
