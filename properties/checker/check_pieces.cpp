#include "check_pieces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../../core/support/agree.hpp"
#include "../../core/support/collective.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "pieces/border.hpp"
#include "pieces/border_delaunay.hpp"
#include "pieces/judgement.hpp"
#include "pieces/merge.hpp"
#include "pieces/numbers.hpp"
#include "pieces/results_in_piece.hpp"
#include "pieces/skeleton.hpp"
#include "stages/stages.hpp"
#include "stages/verdict.hpp"

namespace pardel {

using namespace checker;

namespace {

/// The sides across which a triangle with a smaller number lies in another piece.
std::vector<std::pair<Index, int>> earlier_neighbours(std::span<const BorderSide> border, const Numbering& names) {
  std::vector<std::pair<Index, int>> sides;
  for (const auto& [edge, across] : border)
    if (across.exists() && across.triangle < names.triangle(edge.left.triangle))
      sides.emplace_back(edge.left.triangle, edge.left.edge);
  std::ranges::sort(sides);
  return sides;
}

class PieceCheck {
 public:
  PieceCheck(const Pslg& pslg, const NumberedMesh& piece, const Goal& goal, const CheckOptions& options, Ranks& ranks)
      : subject_{pslg, piece.mesh, goal, options},
        piece_(piece),
        ranks_(ranks),
        found_(options.max_violations),
        certificate_(empty_certificate(pslg, goal)) {
    subject_.names.vertices = piece.number.span();
  }

  Result<Certificate> run() {
    if (Status fits = agree(count(), ranks_); !fits) return fits.error();
    if (Status judged = run_stages(); !judged) return judged.error();
    set_verdict(certificate_, merged(found_, ranks_));
    return std::move(certificate_);
  }

 private:
  /// Counts triangles and listed edges, which determines their names.
  Status count() {
    const ShareOfRank triangles = share_of_rank(piece_.mesh.triangles.size(), ranks_);
    const ShareOfRank listed = share_of_rank(piece_.mesh.constrained_edges.size(), ranks_);
    certificate_.triangles = triangles.all;
    certificate_.constrained_edges = listed.all;
    if (piece_.number.size() != piece_.mesh.points.size())
      return Error{ErrorKind::invalid_input, "a piece has points without numbers"};
    if (std::max(triangles.all, listed.all) >= no_index)
      return Error{ErrorKind::resources, "the mesh has more triangles than can be checked at once"};
    subject_.names.first_triangle = static_cast<Index>(triangles.before);
    subject_.names.first_listed_edge = static_cast<Index>(listed.before);
    return Done{};
  }

  /// True if it is true on all ranks.
  bool everywhere(bool here) { return sum_of(here ? 0 : 1, ranks_) == 0; }

  Status run_stages() {
    const Mesh& mesh = piece_.mesh;
    ScanBounds bounds = bounds_of(subject_);
    bounds.boundary = !lacks_neighbours(subject_);
    Scan scanned = scan(mesh.points.span(), mesh.triangles.span(), bounds);
    // All ranks have the same input, so one of them reports what is wrong with it.
    Findings of_others(0);
    const bool input = check_input(subject_.pslg, ranks_.rank() == 0 ? found_ : of_others);
    const Sanity sanity = check_sanity(subject_, scanned, found_);
    if (!everywhere(input && sanity.geometry)) return Done{};
    const bool labels = everywhere(sanity.labels);

    const Adjacency adjacency = check_topology_of_piece(subject_, sanity.neighbours, scanned, found_);
    const Result<std::uint64_t> points = check_numbers(mesh.points.span(), piece_.number.span(), adjacency, ranks_);
    if (!points) return points.error();
    certificate_.vertices = *points;
    const Piece piece{subject_, piece_.number.span(), *points, adjacency, ranks_};
    const std::vector<BorderSide> border = join_border(piece);
    const std::vector<std::pair<Index, int>> earlier = earlier_neighbours(border, subject_.names);
    subject_.names.earlier_neighbours = earlier;

    const Domain domain(subject_.pslg, subject_.goal.convex_hull);
    const SpecialVertices special(piece, border);
    const Result<Judgement> judgement = judge_skeleton(piece, special, domain, labels);
    if (!judgement) return judgement.error();
    check_piece(piece, border, special, domain, *judgement, scanned, labels);
    subject_.names.earlier_neighbours = {};
    return Done{};
  }

  Result<Judgement> judge_skeleton(const Piece& piece, const SpecialVertices& special, const Domain& domain,
                                   bool labels) {
    const Result<std::optional<Skeleton>> skeleton = gather_skeleton(piece, special);
    if (!skeleton) return skeleton.error();
    Ranks::Bytes message;
    if (skeleton->has_value()) message = judge(**skeleton, subject_, domain, labels, found_).message();
    return Judgement::read(from_first(message, ranks_));
  }

  void check_piece(const Piece& piece, std::span<const BorderSide> border, const SpecialVertices& special,
                   const Domain& domain, const Judgement& judgement, const Scan& scanned, bool labels) {
    const Chains chains = chains_in_piece(piece, judgement, special);
    const InputVertices inputs = input_vertices_in_piece(piece, judgement, special);
    check_holes(subject_, domain, judgement.suspects, found_);
    std::vector<Index> faces;
    if (!subject_.pslg.regions.empty()) faces = faces_in_piece(piece, domain, chains, border);
    if (labels) check_regions(subject_, domain, faces, found_);
    check_delaunay(subject_, piece.adjacency, chains, scanned, found_);
    const std::uint64_t open = check_border_delaunay(piece, border, chains, scanned, found_);
    std::vector<Justified> justified;
    check_goal(subject_, domain, piece.adjacency, chains, inputs, faces, scanned, found_, justified);

    scanned.measures.report(certificate_);
    merge_measures(certificate_, subject_.names.first_triangle, ranks_);
    certificate_.justified = merged(justified, ranks_);
    certificate_.area = judgement.area;
    certificate_.decided_exactly = sum_of(scanned.open.size() + open, ranks_);
    if (labels) certificate_.digest = sum_of(digest(piece_.mesh), ranks_);
  }

  Subject subject_;
  const NumberedMesh& piece_;
  Ranks& ranks_;
  Findings found_;
  Certificate certificate_;
};

}  // namespace

Result<Certificate> check(const Pslg& pslg, const NumberedMesh& piece, const Goal& goal, const CheckOptions& options,
                          Ranks& ranks) {
  return PieceCheck(pslg, piece, goal, options, ranks).run();
}

}  // namespace pardel
