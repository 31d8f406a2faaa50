#include "piece.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../concurrency/parallel_arrays.hpp"
#include "../interpolation/background.hpp"
#include "../triangulation/compact.hpp"
#include "members.hpp"
#include "vertex_data.hpp"

namespace pardel::engine {
namespace {

/// True if the edge belongs to the piece of the triangle on this side: the triangle on the left of the edge, directed
/// from its lexicographically lesser end, or, if there is none, the only one.
bool lists_edge(const Triangulation& t, EdgeRef e) {
  const Slot& slot = t.slot(e);
  const Point a = t.points[slot.from(e.side())], b = t.points[slot.to(e.side())];
  return slot.n[e.side()].none() || lexicographically_less(a, b);
}

/// An allocator in which the indices that do not belong to the piece are unused.
template <class IsIn>
IndexAllocator used_indices(std::size_t n, const IsIn& is_in) {
  std::vector<IndexRange> unused;
  for (Index i = 0; i < n; ++i) {
    if (is_in(i)) continue;
    if (unused.empty() || unused.back().end != i) unused.push_back({i, i});
    unused.back().end = i + 1;
  }
  IndexAllocator indices(static_cast<Index>(n), static_cast<Index>(n));
  indices.release(IndexPool(std::move(unused)));
  indices.settle();
  return indices;
}

/// Where compact() moves vertices or triangles.
class Moved {
 public:
  explicit Moved(const IndexAllocator& indices) : moves_(moves_into_holes(indices)) {}
  [[nodiscard]] Index now(Index before) const {
    const auto move = std::ranges::lower_bound(moves_, before, {}, &IndexMove::from);
    return move != moves_.end() && move->from == before ? move->to : before;
  }
  template <class T>
  void apply(Array<T>& values, std::size_t count) const {
    for (const IndexMove move : moves_) values[move.to] = values[move.from];
    values.resize(count);
    values.shrink_to_fit();
  }

 private:
  std::vector<IndexMove> moves_;
};

/// Uses the storage of the triangulation for the piece.
class PieceMaker {
 public:
  PieceMaker(DomainTriangulation& domain, const Distribution& distribution, InputData input, const Threads& threads)
      : domain_(domain),
        t_(domain.triangulation),
        ranks_(distribution.network()),
        part_(distribution.part()),
        input_(std::move(input)),
        threads_(threads),
        members_(t_, domain.input_of_vertex.size(), distribution, threads),
        data_(vertex_data(domain, distribution, members_, input_.points.markers, threads)) {}

  [[nodiscard]] MeshPiece make(std::vector<Exemption>& exempt) {
    list_edges();
    cut_at_border();
    name_input_segments(domain_, threads_);
    note_inputs();
    compact_all(exempt);
    add_attributes();
    add_shared_vertices();
    piece_.mesh.region_attributes = std::move(input_.region_attributes);
    take_arrays();
    add_totals();
    return std::move(piece_);
  }

 private:
  void list_edges() {
    for (const EdgeRef e : members_.constrained_sides())
      if (members_.has_triangle(e.triangle()) && lists_edge(t_, e))
        piece_.mesh.constrained_edges.push_back(constrained_edge(domain_, t_.slot(e), e.side()).value());
  }

  /// The triangles of the piece no longer refer to others. Only triangles at the border do.
  void cut_at_border() {
    for (const TriangleId id : members_.at_border())
      for (EdgeRef& across : t_.slots[id].n) {
        if (across.none()) continue;
        if (members_.has_triangle(id)) {
          if (part_.is_beyond(across)) across = EdgeRef();
        } else if (members_.has_triangle(across.triangle())) {
          t_.slots[across.triangle()].n[across.side()] = EdgeRef();
        }
      }
  }

  /// Compaction moves vertices, so the input points among them are noted before, if they are needed.
  void note_inputs() {
    if (input_.points.attributes_per_point == 0) return;
    input_point_ = make_array(threads_, t_.points.size(), [&](std::size_t v) {
      return v < domain_.input_of_vertex.size() ? domain_.input_of_vertex[v] : no_index;
    });
  }

  void compact_all(std::vector<Exemption>& exempt) {
    const IndexAllocator vertices = used_indices(t_.points.size(), [&](Index v) { return members_.has_vertex(v); });
    const IndexAllocator triangles = used_indices(t_.slots.size(), [&](Index id) { return members_.has_triangle(id); });
    const Moved moved(vertices), moved_triangles(triangles);
    for (Exemption& e : exempt) e.triangle = moved_triangles.now(e.triangle);
    compact(t_, vertices, triangles, threads_);
    const std::size_t count = t_.points.size();
    moved.apply(data_.number, count);
    moved.apply(data_.marker, count);
    if (!input_point_.empty()) moved.apply(input_point_, count);
    for (ConstrainedEdge& e : piece_.mesh.constrained_edges) e = {moved.now(e.a), moved.now(e.b), e.segment, e.marker};
    for (const auto& [v, ranks] : data_.pieces)
      if (members_.has_vertex(v))
        for (const int rank : ranks)
          if (rank != ranks_.rank()) with_rank_[rank].push_back(moved.now(v));
  }

  void add_attributes() {
    const PointData& data = input_.points;
    const std::size_t k = data.attributes_per_point;
    if (k == 0) return;
    Mesh& mesh = piece_.mesh;
    mesh.attributes_per_point = k;
    const Background on(data.points, std::move(input_.background), threads_);
    LocationHint hint;
    for (VertexId v = 0; v < t_.points.size(); ++v)
      if (const Index point = input_point_[v]; point != no_index)
        mesh.point_attributes.append(data.attributes.subspan(point * k, k));
      else
        append_attributes(on.locate(t_.points[v], hint), data, mesh.point_attributes);
  }

  void add_shared_vertices() {
    for (int rank = 0; rank < ranks_.count(); ++rank) {
      std::vector<Index>& vertices = with_rank_[rank];
      if (vertices.empty()) continue;
      std::ranges::sort(vertices, {}, [&](Index v) { return data_.number[v]; });
      piece_.shared.push_back({rank, std::move(vertices)});
    }
  }

  void take_arrays() {
    Mesh& mesh = piece_.mesh;
    mesh.triangles = Array<Triangle>::recast(std::move(t_.slots));
    parallel_blocks(threads_, mesh.triangles.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id) {
        const auto slot = std::bit_cast<Slot>(mesh.triangles[id]);
        for (unsigned i = 0; i < 3; ++i) mesh.triangles[id].n[i] = slot.n[i].none() ? no_index : slot.n[i].triangle();
      }
    });
    mesh.points = std::move(t_.points);
    mesh.origin = std::move(t_.origin);
    mesh.region = std::move(t_.region);
    mesh.point_markers = std::move(data_.marker);
    piece_.number = std::move(data_.number);
  }

  void add_totals() {
    const ShareOfRank triangles = share_of_rank(piece_.mesh.triangles.size(), ranks_);
    piece_.first_triangle = triangles.before;
    piece_.triangles = triangles.all;
    piece_.first_point = data_.first;
    piece_.points = data_.count;
    piece_.constrained_edges = piece_.mesh.constrained_edges.size();
    ranks_.add_up({&piece_.constrained_edges, 1});
  }

  DomainTriangulation& domain_;
  Triangulation& t_;
  Ranks& ranks_;
  const HeldPart& part_;
  InputData input_;
  Threads threads_;
  Members members_;
  VertexData data_;
  Array<Index> input_point_;  ///< per vertex, if there are attributes: the input point, or no_index
  std::vector<std::vector<Index>> with_rank_ = std::vector<std::vector<Index>>(ranks_.count());
  MeshPiece piece_;
};

}  // namespace

MeshPiece make_piece(DomainTriangulation& domain, const Distribution& distribution, InputData input,
                     std::vector<Exemption>& exempt, const Threads& threads) {
  return PieceMaker(domain, distribution, std::move(input), threads).make(exempt);
}

}  // namespace pardel::engine
