#include "filled_pieces.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "../../core/support/shortest.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "../../parallel/triangulation/limits.hpp"

namespace pardel::engine {
namespace {

/// Per constrained edge of an exported mesh, the first triangle beside it. The edges are listed in the order of these
/// triangles.
std::vector<Index> first_triangles(const Mesh& mesh, const Threads& threads) {
  std::vector<Index> result;
  result.reserve(mesh.constrained_edges.size());
  SparseAsk ask(threads.stop);
  for (Index id = 0; id < mesh.triangles.size(); ++id) {
    ask();
    const auto& v = mesh.triangles[id].v;
    const auto is_corner = [&](Index point) { return std::ranges::find(v, point) != v.end(); };
    while (result.size() < mesh.constrained_edges.size()) {
      const ConstrainedEdge& next = mesh.constrained_edges[result.size()];
      if (!is_corner(next.a) || !is_corner(next.b)) break;
      result.push_back(id);
    }
  }
  return result;
}

std::vector<char> corners_of(const Mesh& mesh, const Threads& threads) {
  std::vector<char> result(mesh.points.size(), 0);
  SparseAsk ask(threads.stop);
  for (const Triangle& triangle : mesh.triangles) {
    ask();
    for (const Index v : triangle.v) result[v] = 1;
  }
  return result;
}

}  // namespace

/// The numbers in a piece of the points with consecutive numbers in the mesh, from `first` on.
class LocalNumbers {
 public:
  LocalNumbers(std::size_t first, std::size_t count) : first_(first), local_(Array<Index>::zeroes(count)) {}

  [[nodiscard]] bool covers(Index point) const { return point >= first_ && point - first_ < local_.size(); }
  /// Thread-safe.
  void mark(Index point) { std::atomic_ref<Index>(local_[point - first_]).store(is_marked, std::memory_order_relaxed); }
  /// Numbers the marked points, and appends them to the list.
  void number(Array<std::uint64_t>& points) {
    for (std::size_t i = 0; i < local_.size(); ++i) {
      if (local_[i] != is_marked) {
        local_[i] = no_index;
        continue;
      }
      local_[i] = static_cast<Index>(points.size());
      points.push_back(first_ + i);
    }
  }
  [[nodiscard]] Index operator[](std::size_t point) const { return local_[point - first_]; }

 private:
  static constexpr Index is_marked = 1;
  std::size_t first_;
  Array<Index> local_;
};

/// The strips of a patch that belong to a piece, and the range of the inner points at them.
struct StripsOfPiece {
  std::span<const Strip> strips;
  std::size_t first_triangle = 0, end_triangle = 0;  ///< in the mesh
};

namespace {

/// Calls visit(row) for the rows of points at the strips.
template <class Visit>
void for_each_row(std::span<const Strip> strips, const Visit& visit) {
  if (strips.empty()) return;
  for (int row = strips.front().row; row <= strips.back().row + 1; ++row) visit(row);
}

}  // namespace

/// Makes one piece.
class FilledPieceMaker {
 public:
  FilledPieceMaker(const FilledPieces& all, std::size_t number, const Threads& threads)
      : all_(all),
        number_(number),
        first_(all.division_.begin_of(number)),
        end_(all.division_.end_of(number)),
        around_end_(std::clamp(all.around_.triangles.size(), first_, end_)),
        threads_(threads),
        around_points_(0, all.around_.points.size()) {}

  [[nodiscard]] MeshPiece make() {
    find_strips();
    write_triangles();
    number_points();
    use_local_numbers();
    write_points();
    write_attributes();
    write_regions();
    list_edges();
    list_shared_points();
    describe();
    return std::move(piece_);
  }

 private:
  [[nodiscard]] const Patch& patch(std::size_t i) const { return all_.filling_.patches()[i].patch; }

  void find_strips() {
    for (std::size_t i = 0; i < all_.places_.size(); ++i) {
      const std::size_t at = all_.places_[i].first_triangle, n = patch(i).triangles();
      const auto from_patch = [&](std::size_t triangle) { return std::clamp(triangle, at, at + n) - at; };
      const auto strip = [&](std::size_t triangle) {
        return std::ranges::lower_bound(patch(i).strips(), triangle, {}, &Strip::first);
      };
      const std::size_t first = from_patch(first_), end = from_patch(end_);
      strips_.push_back({{strip(first), strip(end)}, at + first, at + end});
    }
  }

  void write_triangles() {
    Array<Triangle>& triangles = piece_.mesh.triangles;
    triangles.resize_uninitialised(end_ - first_);
    for (std::size_t id = first_; id < around_end_; ++id) triangles[id - first_] = all_.around_.triangles[id];
    const TriangleRange to{triangles.span(), static_cast<Index>(first_)};
    for (std::size_t i = 0; i < strips_.size(); ++i)
      write_strips(patch(i), all_.places_[i], strips_[i].strips, to, threads_);
    for (const Seam& seam : all_.seams_)
      if (seam.laid >= first_ && seam.laid < end_) to[seam.laid].n[seam.side] = seam.around;
  }

  /// Points of the input that belong to no triangle belong to the first piece.
  void number_points() {
    std::size_t low = std::numeric_limits<std::size_t>::max(), high = 0;
    for_each_list_of_inner_points([&](std::size_t i, const Piece& points) {
      low = std::min(low, all_.places_[i].first_inner + points.first);
      high = std::max(high, all_.places_[i].first_inner + points.first + points.count());
    });
    inner_points_ = LocalNumbers(low, high > low ? high - low : 0);
    if (number_ == 0)
      for (Index v = 0; v < all_.is_corner_.size(); ++v)
        if (all_.is_corner_[v] == 0) around_points_.mark(v);
    for_each_block([&](Triangle& triangle) {
      for (const Index v : triangle.v) numbers_of(v).mark(v);
    });
    around_points_.number(piece_.number);
    points_around_ = piece_.number.size();
    inner_points_.number(piece_.number);
    piece_.number.shrink_to_fit();
  }

  void use_local_numbers() {
    for_each_block([&](Triangle& triangle) {
      for (Index& v : triangle.v) v = numbers_of(v)[v];
      for (Index& n : triangle.n) n = n >= first_ && n < end_ ? n - static_cast<Index>(first_) : no_index;
    });
  }

  void write_points() {
    Mesh& mesh = piece_.mesh;
    const Mesh& around = all_.around_;
    const std::size_t count = piece_.number.size();
    mesh.points.resize_uninitialised(count);
    mesh.origin = Array<Index>::zeroes(count);
    static_assert(interior_vertex == 0);
    mesh.point_markers = Array<int>::zeroes(count);
    for (std::size_t v = 0; v < points_around_; ++v) {
      const std::size_t number = piece_.number[v];
      mesh.points[v] = around.points[number];
      if (around.origin[number] != interior_vertex) mesh.origin[v] = around.origin[number];
      if (around.point_markers[number] != 0) mesh.point_markers[v] = around.point_markers[number];
    }
    for_each_list_of_inner_points([&](std::size_t i, const Piece& points) {
      std::size_t number = all_.places_[i].first_inner + points.first;
      for (int x = points.low; x <= points.high; x += 2, ++number)
        if (const Index v = inner_points_[number]; v != no_index) mesh.points[v] = patch(i).lattice().at(x, points.row);
    });
  }

  void write_attributes() {
    Mesh& mesh = piece_.mesh;
    const std::size_t k = mesh.attributes_per_point = all_.around_.attributes_per_point;
    if (k == 0) return;
    for (std::size_t v = 0; v < points_around_; ++v)
      mesh.point_attributes.append(all_.around_.point_attributes.span().subspan(piece_.number[v] * k, k));
    mesh.point_attributes.append(interpolated_attributes(*all_.background_, mesh.points.span().subspan(points_around_),
                                                         all_.input_.points, threads_));
  }

  void write_regions() {
    Mesh& mesh = piece_.mesh;
    mesh.region_attributes = all_.around_.region_attributes;
    if (all_.around_.region.empty()) return;
    mesh.region.reserve(end_ - first_);
    for (std::size_t id = first_; id < around_end_; ++id) mesh.region.push_back(all_.around_.region[id]);
    for (std::size_t i = 0; i < strips_.size(); ++i)
      mesh.region.resize(mesh.region.size() + strips_[i].end_triangle - strips_[i].first_triangle,
                         all_.filling_.patches()[i].region);
  }

  void list_edges() {
    const std::vector<Index>& first_triangle = all_.first_triangle_;
    for (auto at = std::ranges::lower_bound(first_triangle, first_); at != first_triangle.end() && *at < end_; ++at) {
      const ConstrainedEdge& e = all_.around_.constrained_edges[at - first_triangle.begin()];
      piece_.mesh.constrained_edges.push_back({around_points_[e.a], around_points_[e.b], e.segment, e.marker});
    }
  }

  void list_shared_points() {
    std::vector<std::vector<Index>> with(all_.division_.pieces());
    const auto belongs_here = [&](const PointOfPiece& p) { return p.piece == number_; };
    for (auto begin = all_.shared_.begin(), end = begin; begin != all_.shared_.end(); begin = end) {
      end = std::find_if(begin, all_.shared_.end(), [&](const PointOfPiece& p) { return p.point != begin->point; });
      if (std::none_of(begin, end, belongs_here)) continue;
      for (auto p = begin; p != end; ++p)
        if (!belongs_here(*p)) with[p->piece].push_back(numbers_of(p->point)[p->point]);
    }
    for (std::size_t other = 0; other < with.size(); ++other)
      if (!with[other].empty()) piece_.shared.push_back({static_cast<int>(other), std::move(with[other])});
  }

  /// The inner points are numbered row by row. The other points are divided as evenly as the triangles among them.
  [[nodiscard]] std::uint64_t first_point() const {
    const std::uint64_t inputs = all_.input_.points.points.size(), around = all_.around_.triangles.size();
    std::uint64_t point = inputs;
    if (first_ < around) return point + (all_.around_.points.size() - inputs) * first_ / around;
    for (std::size_t i = 0; i < strips_.size(); ++i) {
      point = all_.places_[i].first_inner + patch(i).inner_points();
      if (strips_[i].strips.empty()) continue;
      for (const Piece& points : patch(i).pieces())
        if (points.row >= strips_[i].strips.front().row && !points.on_border)
          return all_.places_[i].first_inner + points.first;
      return point;
    }
    return first_ > 0 ? point : inputs;
  }

  void describe() {
    piece_.first_triangle = first_;
    piece_.first_point = first_point();
    piece_.points = all_.around_.points.size() + all_.filling_.inner_points();
    piece_.triangles = all_.division_.triangles();
    piece_.constrained_edges = all_.around_.constrained_edges.size();
    piece_.report = all_.report_;
    std::vector<Exemption>& exempt = piece_.report.exempt;
    piece_.missed = static_cast<std::uint64_t>(
        std::ranges::count_if(exempt, [](const Exemption& e) { return !justified(e.reason); }));
    std::erase_if(exempt, [&](const Exemption& e) { return e.triangle < first_ || e.triangle >= end_; });
    for (Exemption& e : exempt) e.triangle -= static_cast<Index>(first_);
  }

  template <class Visit>
  void for_each_block(const Visit& visit) {
    Array<Triangle>& triangles = piece_.mesh.triangles;
    parallel_blocks(threads_, triangles.size(), [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t id = first; id < last; ++id) visit(triangles[id]);
    });
  }
  /// Calls visit(patch, points) for the inner points in the rows at the strips of the piece; some of them may belong to
  /// other strips.
  template <class Visit>
  void for_each_list_of_inner_points(const Visit& visit) const {
    for (std::size_t i = 0; i < strips_.size(); ++i)
      for_each_row(strips_[i].strips, [&](int row) {
        for (const Piece& points : patch(i).pieces_of(row))
          if (!points.on_border) visit(i, points);
      });
  }
  [[nodiscard]] LocalNumbers& numbers_of(Index point) {
    return around_points_.covers(point) ? around_points_ : inner_points_;
  }

  const FilledPieces& all_;
  std::size_t number_, first_, end_;
  std::size_t around_end_;  ///< the first triangle of the piece that belongs to a patch
  Threads threads_;
  std::vector<StripsOfPiece> strips_;  ///< per patch
  LocalNumbers around_points_;
  LocalNumbers inner_points_{0, 0};
  std::size_t points_around_ = 0;
  MeshPiece piece_;
};

Result<FilledPieces> FilledPieces::make(FilledRound round, InputData input, Report report, std::size_t pieces,
                                        const Threads& threads) {
  Mesh around = round.take_mesh_around(input, threads);
  Filling filling = round.take_filling();
  const std::uint64_t triangles = around.triangles.size() + filling.triangles();
  const std::uint64_t points = around.points.size() + filling.inner_points();
  if (std::max(triangles, points) > no_index)
    return Error{ErrorKind::resources, "the mesh has " + shortest(static_cast<double>(triangles) / 1e6) +
                                           " million triangles; a mesh in pieces can have 2^32 - 1"};
  std::vector<PlacesOfPatch> places =
      places_of(filling.patches(), filling.first_border(), around.points.size(), around.triangles.size());
  std::optional<std::vector<Seam>> seams = join_to_patches(around, filling.patches(), filling.first_border(), threads);
  if (!seams) return border_missing();
  FilledPieces all(std::move(filling), std::move(around), std::move(places), std::move(*seams), std::move(input),
                   std::move(report), pieces, threads);
  for (std::size_t i = 0; i < pieces; ++i)
    if (all.division_.end_of(i) - all.division_.begin_of(i) > max_engine_triangles) return too_many_triangles();
  return all;
}

FilledPieces::FilledPieces(Filling filling, Mesh around, std::vector<PlacesOfPatch> places, std::vector<Seam> seams,
                           InputData input, Report report, std::size_t pieces, const Threads& threads)
    : filling_(std::move(filling)),
      around_(std::move(around)),
      places_(std::move(places)),
      seams_(std::move(seams)),
      input_(std::move(input)),
      report_(std::move(report)),
      division_(filling_.patches(), places_, around_.triangles.size(), pieces),
      shared_(shared_points(around_.triangles.span(), around_.points.size(), filling_.patches(), places_, division_,
                            threads)),
      first_triangle_(first_triangles(around_, threads)),
      is_corner_(corners_of(around_, threads)) {
  if (input_.points.attributes_per_point > 0)
    background_.emplace(input_.points.points, std::move(input_.background), threads);
}

MeshPiece FilledPieces::piece(std::size_t number, const Threads& threads) const {
  return FilledPieceMaker(*this, number, threads).make();
}

}  // namespace pardel::engine
