#include "piece.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../../core/support/point_order.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../parallel/sizing/background.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "../../parallel/triangulation/compact.hpp"
#include "members.hpp"
#include "numbering.hpp"
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

/// Uses the storage of the triangulation for the piece.
class PieceMaker {
 public:
  PieceMaker(DomainTriangulation& domain, const Distribution& distribution, InputData input, const Threads& threads)
      : domain_(domain),
        t_(domain.triangulation),
        distribution_(distribution),
        ranks_(distribution.network()),
        part_(distribution.part()),
        input_(std::move(input)),
        threads_(threads),
        members_(t_, distribution, threads),
        vertex_moves_(members_.vertices()),
        data_(vertex_data(domain, distribution, members_)) {}

  [[nodiscard]] MeshPiece make(std::vector<Exemption>& exempt) {
    name_apexes(exempt);
    list_edges();
    cut_at_border();
    compact_all(exempt);
    name_input_segments(domain_, threads_);  // of the vertices in the piece: those of others may have no origin
    add_attributes();
    add_shared_vertices();
    piece_.mesh.region_attributes = std::move(input_.region_attributes);
    take_arrays();
    add_totals();
    return std::move(piece_);
  }

 private:
  /// Makes the apexes points of the input. One that this rank does not know as a point of the input, although it has
  /// the vertex, is known to the rank that has read it. Collective.
  void name_apexes(std::vector<Exemption>& exempt) const {
    const auto is_unknown = [&](const Exemption& e) {
      return e.apex != no_index && e.apex >= distribution_.known_inputs();
    };
    std::vector<Point> asked;
    for (const Exemption& e : exempt)
      if (is_unknown(e)) asked.push_back(t_.points[e.apex]);
    std::ranges::sort(asked, lexicographically_less);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    std::vector<std::uint64_t> numbers;  // ranks that begin with the whole input know all its points
    if (distribution_.is_input_divided()) numbers = numbers_of(asked);
    for (Exemption& e : exempt) {
      if (is_unknown(e))
        e.apex = static_cast<Index>(
            numbers[std::ranges::lower_bound(asked, t_.points[e.apex], lexicographically_less) - asked.begin()]);
      else if (e.apex != no_index)
        e.apex = static_cast<Index>(distribution_.input_point(e.apex).number);
    }
  }

  /// The numbers of points of the input in the input; no_index if no rank knows the point. Collective.
  [[nodiscard]] std::vector<std::uint64_t> numbers_of(const std::vector<Point>& points) const {
    const std::vector<std::vector<Point>> questions = lists_of_all(points, ranks_);
    std::vector<std::vector<std::uint64_t>> answers;
    for (const std::vector<Point>& asked : questions) answers.emplace_back(asked.size(), no_index);
    for (std::size_t rank = 0; rank < questions.size(); ++rank)
      for (VertexId v = 0; v < distribution_.known_inputs() && !questions[rank].empty(); ++v) {
        const auto place = std::ranges::lower_bound(questions[rank], t_.points[v], lexicographically_less);
        if (place != questions[rank].end() && *place == t_.points[v])
          answers[rank][place - questions[rank].begin()] = distribution_.input_point(v).number;
      }
    std::vector<std::uint64_t> least(points.size(), no_index);
    for (const std::vector<std::uint64_t>& of_rank : exchange_lists(std::move(answers), ranks_))
      for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], of_rank[i]);
    return least;
  }

  void list_edges() {
    for (const EdgeRef e : members_.constrained_sides())
      if (members_.triangles().uses(e.triangle()) && lists_edge(t_, e))
        piece_.mesh.constrained_edges.push_back(constrained_edge(domain_, t_.slot(e), e.side()).value());
  }

  /// The triangles of the piece no longer refer to others. (Neither do others that will be removed.)
  void cut_at_border() {
    for (const TriangleId id : members_.of_others())
      for (const EdgeRef across : t_.slots[id].n)
        if (!across.none()) t_.slots[across.triangle()].n[across.side()] = EdgeRef();
    for (const TriangleId id : members_.at_border())
      for (EdgeRef& across : t_.slots[id].n)
        if (part_.is_beyond(across)) across = EdgeRef();
  }

  /// First the memory that others need no longer is released, so that arrays for the result take its place.
  void compact_all(std::vector<Exemption>& exempt) {
    const IndexMoves triangles(members_.triangles());
    for (Exemption& e : exempt) e.triangle = triangles.now(e.triangle);
    for (ConstrainedEdge& e : piece_.mesh.constrained_edges)
      e = {vertex_moves_.now(e.a), vertex_moves_.now(e.b), e.segment, e.marker};
    std::erase_if(data_.markers, [&](VertexData::Marker m) { return !members_.has_vertex(m.v); });
    for (VertexData::Marker& m : data_.markers) m.v = vertex_moves_.now(m.v);
    for (const auto& [v, ranks] : data_.pieces)
      if (members_.has_vertex(v))
        for (const int rank : ranks)
          if (rank != ranks_.rank()) with_rank_[rank].push_back(vertex_moves_.now(v));
    for (VertexId v = 0; v < distribution_.known_inputs(); ++v)
      if (members_.has_vertex(v)) inputs_.push_back({vertex_moves_.now(v), distribution_.input_point(v).number});
    members_.forget_vertices();
    compact_but_corners(t_, vertex_moves_, triangles, threads_);
    number();
    piece_.mesh.point_markers = Array<int>::zeroes(t_.points.size());
    for (const VertexData::Marker m : data_.markers) piece_.mesh.point_markers[m.v] = m.marker;
  }

  /// Vertices that are not in the piece get numbers, too, which those that have moved into their places overwrite.
  void number() {
    piece_.number.resize_uninitialised(vertex_moves_.in_use());
    const auto number_range = [&](Index begin, Index end) {
      parallel_blocks(threads_, end - begin, [&](std::size_t first, std::size_t last, std::size_t) {
        data_.numbers.for_each(begin + static_cast<Index>(first), begin + static_cast<Index>(last),
                               [&](VertexId v, std::uint64_t number) {
                                 if (const Index now = vertex_moves_.now(v); now != no_index)
                                   piece_.number[now] = number;
                               });
      });
    };
    number_range(0, vertex_moves_.in_use());
    number_range(vertex_moves_.in_use(), vertex_moves_.end());
    for (const InputVertex& input : inputs_) piece_.number[input.v] = input.point;
  }

  void add_attributes() {
    const PointData& data = input_.points;
    const std::size_t k = data.attributes_per_point;
    if (k == 0) return;
    Mesh& mesh = piece_.mesh;
    mesh.attributes_per_point = k;
    const Background on(data.points, std::move(input_.background), threads_);
    Array<Index> input_point(t_.points.size(), no_index);
    for (const InputVertex& input : inputs_) input_point[input.v] = static_cast<Index>(input.point);
    std::vector<Point> inserted;
    for (VertexId v = 0; v < t_.points.size(); ++v)
      if (input_point[v] == no_index) inserted.push_back(t_.points[v]);
    const std::vector<double> interpolated = interpolated_attributes(on, inserted, data, threads_);
    std::size_t next = 0;
    for (const Index point : input_point)
      mesh.point_attributes.append(point != no_index ? data.attributes.subspan(point * k, k)
                                                     : std::span(interpolated).subspan(k * next++, k));
    interpolate_along_segments(t_.points.span(), t_.origin.span(), data, mesh.point_attributes.span(), threads_);
  }

  void add_shared_vertices() {
    for (int rank = 0; rank < ranks_.count(); ++rank) {
      std::vector<Index>& vertices = with_rank_[rank];
      if (vertices.empty()) continue;
      std::ranges::sort(vertices, {}, [&](Index v) { return piece_.number[v]; });
      piece_.shared.push_back({rank, std::move(vertices)});
    }
  }

  void take_arrays() {
    Mesh& mesh = piece_.mesh;
    mesh.triangles = Array<Triangle>::recast(std::move(t_.slots));
    parallel_blocks(threads_, mesh.triangles.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id) {
        const auto slot = std::bit_cast<Slot>(mesh.triangles[id]);
        for (unsigned i = 0; i < 3; ++i) {
          mesh.triangles[id].v[i] = vertex_moves_.now(slot.v[i]);
          mesh.triangles[id].n[i] = slot.n[i].none() ? no_index : slot.n[i].triangle();
        }
      }
    });
    mesh.points = std::move(t_.points);
    mesh.origin = std::move(t_.origin);
    mesh.region = std::move(t_.region);
  }

  void add_totals() {
    const ShareOfRank triangles = share_of_rank(piece_.mesh.triangles.size(), ranks_);
    piece_.first_triangle = triangles.before;
    piece_.triangles = triangles.all;
    piece_.first_point = data_.first;
    piece_.points = data_.count;
    piece_.constrained_edges = piece_.mesh.constrained_edges.size();
    ranks_.add_up({&piece_.constrained_edges, 1});
    piece_.margin = members_.of_others().size();
  }

  DomainTriangulation& domain_;
  Triangulation& t_;
  const Distribution& distribution_;
  Ranks& ranks_;
  const Subdomain& part_;
  InputData input_;
  Threads threads_;
  Members members_;
  IndexMoves vertex_moves_;
  VertexData data_;
  /// The input points of the piece: indices in the piece, and in the input.
  struct InputVertex {
    VertexId v;
    std::uint64_t point;
  };
  std::vector<InputVertex> inputs_;
  std::vector<std::vector<Index>> with_rank_ = std::vector<std::vector<Index>>(ranks_.count());
  MeshPiece piece_;
};

}  // namespace

MeshPiece make_piece(DomainTriangulation& domain, const Distribution& distribution, InputData input,
                     std::vector<Exemption>& exempt, const Threads& threads) {
  return PieceMaker(domain, distribution, std::move(input), threads).make(exempt);
}

}  // namespace pardel::engine
