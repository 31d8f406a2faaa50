#include "piece_of_points.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "../../core/support/message.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "../../parallel/triangulation/triangle_shape.hpp"
#include "shared_hull.hpp"

namespace pardel::engine {
namespace {

/// What the owner of a vertex tells a rank whose piece has it.
struct TravellingVertex {
  std::uint64_t position, number;
  int marker;
  std::uint32_t pieces;  ///< the number of pieces that have it
};

class PointsPieceMaker {
 public:
  PointsPieceMaker(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads)
      : delaunay_(delaunay),
        t_(delaunay.triangulation()),
        own_(own),
        ranks_(ranks),
        threads_(threads),
        hull_(delaunay, own, ranks) {}

  [[nodiscard]] MeshPiece make() {
    triangle_ = numbered(t_.slots.size(), [&](std::size_t id) {
      const Slot& slot = t_.slots[id];
      return !slot.is_ghost() && owner_of_triangle(slot) == ranks_.rank();
    });
    find_pieces();
    number_vertices();
    add_vertices();
    ask_owners();
    add_shared_vertices();
    add_edges();
    add_triangles();
    add_totals();
    return std::move(piece_);
  }

 private:
  /// For all slots or vertices: the place in the piece, or no_index.
  struct Places {
    Array<Index> kept;
    Array<Index> place;
  };
  template <class IsKept>
  [[nodiscard]] Places numbered(std::size_t n, const IsKept& is_kept) const {
    Array<Index> kept = indices_where(threads_, n, is_kept);
    Array<Index> place = places_in(threads_, kept.span(), n);
    return {std::move(kept), std::move(place)};
  }

  [[nodiscard]] int owner_of_triangle(const Slot& slot) const {
    const VertexId v = least_corner(t_, slot);
    return delaunay_.is_own(v) ? ranks_.rank() : own_.owner(delaunay_.site(v).position);
  }

  /// Of the own vertices, those that are in pieces of other ranks. All triangles around them are known.
  void find_pieces() {
    const Array<Index> at_border = indices_where(threads_, t_.slots.size(), [&](std::size_t id) {
      const Slot& slot = t_.slots[id];
      return !slot.is_ghost() && delaunay_.has_own_corner(static_cast<TriangleId>(id)) &&
             !std::ranges::all_of(slot.v, [&](VertexId v) { return delaunay_.is_own(v); });
    });
    for (const Index id : at_border) {
      const int rank = owner_of_triangle(t_.slots[id]);
      if (rank == ranks_.rank()) continue;
      for (const VertexId v : t_.slots[id].v)
        if (delaunay_.is_own(v)) pieces_[v].push_back(rank);
    }
    for (auto& [v, ranks] : pieces_) {
      std::ranges::sort(ranks);
      ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
    }
  }

  /// As in a mesh of one process: the marker of the input or, if that is 0, 1 on the boundary.
  [[nodiscard]] int marker(VertexId v) const {
    const int given = own_.marker.empty() ? 0 : own_.marker[v];
    return given == 0 && hull_.has(delaunay_.site(v).position) ? 1 : given;
  }

  void number_vertices() {
    Array<char> is_used = Array<char>::zeroes(t_.points.size());
    for (const Index id : triangle_.kept)
      for (const VertexId v : t_.slots[id].v) is_used[v] = 1;
    vertex_ = numbered(t_.points.size(), [&](std::size_t v) { return is_used[v] != 0; });
  }

  /// Points, and what the rank knows about its own ones.
  void add_vertices() {
    Mesh& mesh = piece_.mesh;
    const std::size_t n = vertex_.kept.size(), k = mesh.attributes_per_point = own_.attributes_per_point;
    mesh.points = make_array(threads_, n, [&](std::size_t i) { return t_.points[vertex_.kept[i]]; });
    mesh.origin = make_array(threads_, n, [](std::size_t) { return input_vertex; });
    mesh.point_markers = Array<int>::zeroes(n);
    mesh.point_attributes.resize(n * k);
    piece_.number.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const VertexId v = vertex_.kept[i];
      if (!delaunay_.is_own(v)) continue;
      piece_.number[i] = own_.number[v];
      mesh.point_markers[i] = marker(v);
      std::copy_n(own_.attributes.begin() + v * k, k, mesh.point_attributes.begin() + i * k);
      const auto others = pieces_.find(v);
      if (others == pieces_.end()) continue;
      for (const int rank : others->second) shared_[rank].push_back(static_cast<Index>(i));
    }
  }

  [[nodiscard]] std::vector<Ranks::Bytes> told() const {
    struct Told {
      std::vector<TravellingVertex> vertices;
      std::vector<int> pieces;
      std::vector<double> attributes;
    };
    std::vector<Told> to(static_cast<std::size_t>(ranks_.count()));
    const std::size_t k = own_.attributes_per_point;
    for (const auto& [v, ranks] : pieces_) {
      std::vector<int> all = ranks;
      if (vertex_.place[v] != no_index) all.push_back(ranks_.rank());
      for (const int rank : ranks) {
        to[rank].vertices.push_back(
            {delaunay_.site(v).position, own_.number[v], marker(v), static_cast<std::uint32_t>(all.size())});
        to[rank].pieces.insert(to[rank].pieces.end(), all.begin(), all.end());
        const auto row = own_.attributes.begin() + v * k;
        to[rank].attributes.insert(to[rank].attributes.end(), row, row + k);
      }
    }
    std::vector<Ranks::Bytes> messages;
    for (const Told& each : to) {
      Writer writer;
      if (!each.vertices.empty()) {
        writer.list(each.vertices);
        writer.list(each.pieces);
        writer.list(each.attributes);
      }
      messages.push_back(writer.take());
    }
    return messages;
  }

  /// The owners tell the ranks about the vertices that these have, but do not own.
  void ask_owners() {
    std::unordered_map<std::uint64_t, Index> place_of;
    for (std::size_t i = 0; i < vertex_.kept.size(); ++i)
      if (!delaunay_.is_own(vertex_.kept[i]))
        place_of[delaunay_.site(vertex_.kept[i]).position] = static_cast<Index>(i);
    std::size_t known = 0;
    for (const Ranks::Bytes& message : ranks_.exchange(told())) {
      if (message.empty()) continue;
      Reader reader(message);
      const auto vertices = reader.list<TravellingVertex>();
      const auto pieces = reader.list<int>();
      const auto attributes = reader.list<double>();
      const std::size_t k = own_.attributes_per_point;
      if (attributes.size() != k * vertices.size()) throw Reader::does_not_match();
      std::size_t next = 0;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto at = place_of.find(vertices[i].position);
        if (at == place_of.end() || vertices[i].pieces > pieces.size() - next) throw Reader::does_not_match();
        const Index place = at->second;
        piece_.number[place] = vertices[i].number;
        piece_.mesh.point_markers[place] = vertices[i].marker;
        std::copy_n(attributes.begin() + static_cast<std::ptrdiff_t>(i * k), k,
                    piece_.mesh.point_attributes.begin() + place * k);
        for (std::uint32_t p = 0; p < vertices[i].pieces; ++p)
          if (const int rank = pieces[next++]; rank != ranks_.rank()) shared_[rank].push_back(place);
        ++known;
      }
    }
    if (known != place_of.size()) throw Reader::does_not_match();
  }

  void add_shared_vertices() {
    for (auto& [rank, vertices] : shared_) {
      std::ranges::sort(vertices, {}, [&](Index v) { return piece_.number[v]; });
      piece_.shared.push_back({rank, std::move(vertices)});
    }
  }

  /// The edges of the convex hull, which are the sides of triangles of the piece.
  void add_edges() {
    for (const Slot& slot : t_.slots) {
      if (!slot.is_ghost()) continue;
      const unsigned corner = slot.corner_of(ghost);
      const VertexId from = slot.to(corner), to = slot.from(corner);
      if (triangle_.place[slot.n[corner].triangle()] == no_index) continue;
      if (hull_.has_edge(delaunay_.site(from).position, delaunay_.site(to).position))
        piece_.mesh.constrained_edges.push_back({vertex_.place[from], vertex_.place[to], no_index, 1});
    }
    std::ranges::sort(piece_.mesh.constrained_edges, {}, [](const ConstrainedEdge& e) { return std::pair(e.a, e.b); });
  }

  void add_triangles() {
    piece_.mesh.triangles = make_array(threads_, triangle_.kept.size(), [&](std::size_t i) {
      const Slot& slot = t_.slots[triangle_.kept[i]];
      Triangle triangle;
      for (unsigned k = 0; k < 3; ++k) {
        triangle.v[k] = vertex_.place[slot.v[k]];
        triangle.n[k] = triangle_.place[slot.n[k].triangle()];
      }
      return triangle;
    });
  }

  void add_totals() {
    const ShareOfRank triangles = share_of_rank(piece_.mesh.triangles.size(), ranks_);
    piece_.first_triangle = triangles.before;
    piece_.triangles = triangles.all;
    piece_.points = piece_.first_point = own_.first.back();
    piece_.constrained_edges = piece_.mesh.constrained_edges.size();
    ranks_.add_up({&piece_.constrained_edges, 1});
  }

  LocalDelaunay& delaunay_;
  const Triangulation& t_;
  const OwnPoints& own_;
  Ranks& ranks_;
  Threads threads_;
  SharedHull hull_;
  Places triangle_, vertex_;
  std::map<VertexId, std::vector<int>> pieces_;  ///< the ranks of other pieces, ascending
  std::map<int, std::vector<Index>> shared_;
  MeshPiece piece_;
};

}  // namespace

MeshPiece make_piece_of_points(LocalDelaunay& delaunay, const OwnPoints& own, Ranks& ranks, const Threads& threads) {
  return PointsPieceMaker(delaunay, own, ranks, threads).make();
}

}  // namespace pardel::engine
