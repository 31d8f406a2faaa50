#include "piece.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "../model/number_set.hpp"

namespace pardel::checker {
namespace {

std::uint64_t count_of(const Findings& found) {
  const std::vector<std::uint64_t> counts = found.counts();
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

Piece examined(std::shared_ptr<const NumberedMesh> source, const Task& task, const Numbering& names, Findings& found) {
  const Mesh& mesh = source->mesh;
  Piece piece{std::move(source), {task.pslg, mesh, task.goal, task.options, names}, {}, {}, {}};
  const std::uint64_t before = count_of(found), degenerate = found.count(ViolationKind::degenerate_triangle);
  ScanBounds bounds = bounds_of(piece.subject);
  bounds.boundary = !lacks_neighbours(piece.subject);
  piece.scanned = scan(mesh.points.span(), mesh.triangles.span(), bounds);
  piece.sanity = check_sanity(piece.subject, piece.scanned, found);
  if (piece.sanity.geometry)
    piece.adjacency.emplace(check_topology_of_piece(piece.subject, piece.sanity.neighbours, piece.scanned, found));
  piece.found = count_of(found) - before;
  piece.is_counter_clockwise = found.count(ViolationKind::degenerate_triangle) == degenerate;
  return piece;
}

bool lacks_regions(const NumberedMesh& piece) { return piece.mesh.region.empty() && !piece.mesh.triangles.empty(); }

std::shared_ptr<const NumberedMesh> without_regions(const NumberedMesh& piece) {
  NumberedMesh copy = piece;
  copy.mesh.region.resize(copy.mesh.triangles.size(), no_index);
  return std::make_shared<const NumberedMesh>(std::move(copy));
}

/// True if several points of a piece have one number.
bool repeats_a_number(const NumberedMesh& piece) {
  NumberSet numbers;
  return std::ranges::any_of(piece.number,
                             [&](std::uint64_t number) { return number < no_index && !numbers.insert(number); });
}

bool has_corners_of_its_own(const Mesh& mesh) {
  const auto n = static_cast<Index>(mesh.points.size());
  return std::ranges::all_of(mesh.triangles, [&](const Triangle& t) { return std::ranges::max(t.v) < n; }) &&
         std::ranges::all_of(mesh.constrained_edges, [&](const ConstrainedEdge& e) { return std::max(e.a, e.b) < n; });
}

/// Points with one number are one vertex: the neighbours of its triangles, and the chains through it, depend on that.
/// (A piece with corners that do not exist is refused anyway.)
Result<std::shared_ptr<const NumberedMesh>> with_joined_points(std::shared_ptr<const NumberedMesh> source) {
  if (!repeats_a_number(*source) || !has_corners_of_its_own(source->mesh)) return source;
  Result<NumberedMesh> joined = join_points(*source);
  if (!joined) return joined.error();
  return std::make_shared<const NumberedMesh>(std::move(*joined));
}

}  // namespace

Result<Piece*> PieceReader::open(std::size_t i, const Numbering& names, Findings& found) {
  const auto named = [&](const NumberedMesh& mesh) {
    Numbering all = names;
    all.vertices = mesh.number.span();
    return all;
  };
  if (!open_ || number_ != i || open_->found > 0 || (expects_regions_ && lacks_regions(*open_->source))) {
    open_.reset();
    Result<std::shared_ptr<const NumberedMesh>> source = pieces_.read(i);
    if (!source) return source.error();
    if (expects_regions_ && lacks_regions(**source)) source = without_regions(**source);
    if ((*source)->number.size() != (*source)->mesh.points.size())
      return Error{ErrorKind::invalid_input, "a piece has points without numbers"};
    source = with_joined_points(std::move(*source));
    if (!source) return source.error();
    const Numbering all = named(**source);
    open_.emplace(examined(std::move(*source), task_, all, found));
    number_ = i;
  }
  open_->subject.names = named(*open_->source);
  return &*open_;
}

void PieceReader::close() {
  if (pieces_.count != 1) open_.reset();
}

}  // namespace pardel::checker
