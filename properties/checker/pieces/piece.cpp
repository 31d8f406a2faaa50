#include "piece.hpp"

#include <numeric>
#include <utility>

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
