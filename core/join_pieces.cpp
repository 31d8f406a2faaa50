#include "join_pieces.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "join_fields.hpp"
#include "neighbours.hpp"
#include "support/same_attribute.hpp"
#include "support/shortest.hpp"

namespace pardel {
namespace {

Error invalid(const std::string& message) { return {ErrorKind::invalid_input, message}; }

class Join {
 public:
  /// `names`: what messages call the numbers; empty if it is the numbers themselves, counted from `first_id`. A rank
  /// without triangles has an empty piece, which says nothing about the kinds of data.
  explicit Join(std::span<const NumberedMesh> pieces, FirstId first_id, std::span<const std::uint64_t> names = {})
      : first_id_(first_id), names_(names) {
    for (const NumberedMesh& piece : pieces)
      if (!piece.mesh.points.empty()) pieces_.push_back(&piece);
  }

  Result<Mesh> join() {
    if (pieces_.empty()) return mesh_;
    if (Status fit = make_room(); !fit) return fit.error();
    for (const NumberedMesh* piece : pieces_) {
      if (Status fits = check_kind(*piece); !fits) return fits.error();
      if (Status added = add_points(*piece); !added) return added.error();
      add_cells(*piece);
    }
    const auto missing = std::ranges::find(is_known_, 0);
    if (missing != is_known_.end())
      return invalid("no piece has the point with the number " +
                     name(static_cast<std::uint64_t>(missing - is_known_.begin())));
    rebuild_neighbours(mesh_.triangles, mesh_.points.size());
    mesh_.fields = join_fields(pieces_, mesh_.points.size());
    mesh_.names = join_names(pieces_);
    for (const NumberedMesh* piece : pieces_)
      for (const std::string& thing : piece->mesh.left_out.things()) mesh_.left_out.add(thing);
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::string name(std::uint64_t number) const {
    return std::to_string(names_.empty() ? number + static_cast<unsigned>(first_id_.value) : names_[number]);
  }

  /// The largest number determines the number of points. It is less than the number of points of all pieces, because no
  /// number is missing.
  Status make_room() {
    std::uint64_t largest = 0, listed = 0, triangles = 0;
    for (const NumberedMesh* piece : pieces_) {
      for (const std::uint64_t number : piece->number) largest = std::max(largest, number);
      listed += piece->number.size();
      triangles += piece->mesh.triangles.size();
    }
    if (largest >= listed)
      return invalid("a point has the number " + (names_.empty() ? name(largest) : std::to_string(largest)) +
                     ", but the pieces have only " + std::to_string(listed) + " points");
    const std::uint64_t points = largest + 1;
    if (points >= no_index || !can_be_a_mesh(triangles))
      return Error{ErrorKind::resources, "the pieces have " + std::to_string(triangles) + " triangles and " +
                                             std::to_string(points) + " points, more than one mesh can hold"};
    const Mesh& first = pieces_.front()->mesh;
    is_known_.resize(points);
    mesh_.points.resize(points);
    if (!first.point_markers.empty()) mesh_.point_markers.resize(points);
    if (!first.origin.empty()) mesh_.origin.resize(points);
    mesh_.attributes_per_point = first.attributes_per_point;
    mesh_.point_attributes.resize(points * first.attributes_per_point);
    mesh_.triangles.reserve(triangles);
    return Done{};
  }

  /// A piece without triangles says nothing about regions.
  Status check_kind(const NumberedMesh& piece) {
    const Mesh &first = pieces_.front()->mesh, &mesh = piece.mesh;
    const std::size_t n = mesh.points.size();
    const auto has_all = [](const auto& values, std::size_t count, bool should_exist) {
      return values.size() == (should_exist ? count : 0);
    };
    if (piece.number.size() != n) return invalid("a piece has points without numbers");
    bool same = mesh.attributes_per_point == first.attributes_per_point &&
                mesh.point_attributes.size() == n * first.attributes_per_point &&
                has_all(mesh.point_markers, n, !first.point_markers.empty()) &&
                has_all(mesh.origin, n, !first.origin.empty());
    if (!mesh.triangles.empty()) {
      if (mesh_.triangles.empty()) {
        have_regions_ = !mesh.region.empty();
        mesh_.region_attributes = mesh.region_attributes;
      }
      same = same && has_all(mesh.region, mesh.triangles.size(), have_regions_);
    }
    if (!same) return invalid("the pieces do not have the same kinds of data");
    return Done{};
  }

  [[nodiscard]] Error different(std::uint64_t number, Point a, Point b) const {
    if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
    return invalid("different points have the number " + name(number) + ", at " + shortest(a) + " and " + shortest(b));
  }

  Status add_points(const NumberedMesh& piece) {
    const std::size_t k = mesh_.attributes_per_point;
    for (std::size_t v = 0; v < piece.number.size(); ++v) {
      const std::uint64_t number = piece.number[v];
      const Point p = piece.mesh.points[v];
      if (is_known_[number] != 0) {
        if (p.x != mesh_.points[number].x || p.y != mesh_.points[number].y)
          return different(number, mesh_.points[number], p);
        if (!has_same_data(piece.mesh, v, number))
          return invalid("there are different data of the point with the number " + name(number));
        continue;
      }
      is_known_[number] = 1;
      mesh_.points[number] = p;
      if (!mesh_.point_markers.empty()) mesh_.point_markers[number] = piece.mesh.point_markers[v];
      if (!mesh_.origin.empty()) mesh_.origin[number] = piece.mesh.origin[v];
      std::copy_n(piece.mesh.point_attributes.begin() + v * k, k, mesh_.point_attributes.begin() + number * k);
    }
    return Done{};
  }

  /// The point v of the piece has the data of the point of the whole mesh that is known already.
  [[nodiscard]] bool has_same_data(const Mesh& piece, std::size_t v, std::uint64_t number) const {
    const std::size_t k = mesh_.attributes_per_point;
    return (mesh_.point_markers.empty() || piece.point_markers[v] == mesh_.point_markers[number]) &&
           (mesh_.origin.empty() || piece.origin[v] == mesh_.origin[number]) &&
           std::ranges::equal(piece.point_attributes.span().subspan(v * k, k),
                              mesh_.point_attributes.span().subspan(number * k, k), is_same_attribute);
  }

  void add_cells(const NumberedMesh& piece) {
    const auto whole = [&](Index v) { return static_cast<Index>(piece.number[v]); };
    for (const Triangle& triangle : piece.mesh.triangles)
      mesh_.triangles.push_back({{whole(triangle.v[0]), whole(triangle.v[1]), whole(triangle.v[2])}});
    mesh_.region.append(piece.mesh.region.span());
    for (const ConstrainedEdge& e : piece.mesh.constrained_edges)
      mesh_.constrained_edges.push_back({whole(e.a), whole(e.b), e.segment, e.marker});
  }

  std::vector<const NumberedMesh*> pieces_;
  FirstId first_id_;
  std::span<const std::uint64_t> names_;
  Array<char> is_known_;  ///< per point
  bool have_regions_ = false;
  Mesh mesh_;
};

/// Makes one piece, whose points are in the order of their numbers.
Result<NumberedMesh> joined(std::vector<NumberedMesh> pieces) {
  std::vector<std::uint64_t> numbers;
  for (const NumberedMesh& piece : pieces) numbers.insert(numbers.end(), piece.number.begin(), piece.number.end());
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (NumberedMesh& piece : pieces)
    for (std::uint64_t& number : piece.number)
      number = static_cast<std::uint64_t>(std::ranges::lower_bound(numbers, number) - numbers.begin());
  Result<Mesh> mesh = Join(pieces, {}, numbers).join();
  if (!mesh) return mesh.error();
  return NumberedMesh{std::move(*mesh), Array<std::uint64_t>(numbers)};
}

}  // namespace

Result<Mesh> join_pieces(std::span<const NumberedMesh> pieces, FirstId first_id) {
  return Join(pieces, first_id).join();
}

Result<NumberedMesh> join_some_pieces(std::vector<NumberedMesh> pieces) {
  if (pieces.size() == 1) return std::move(pieces.front());
  return joined(std::move(pieces));
}

Result<NumberedMesh> join_points(NumberedMesh piece) {
  std::vector<NumberedMesh> pieces;
  pieces.push_back(std::move(piece));
  return joined(std::move(pieces));
}

}  // namespace pardel
