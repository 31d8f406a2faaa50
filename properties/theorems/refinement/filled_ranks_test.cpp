// Several ranks make the filled mesh of one process, piece after piece.
#include <string>
#include <vector>

#include "../../checker/check_pieces.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "problems_to_fill.hpp"

namespace pardel::properties {
namespace {

/// Makes the pieces of this rank, and joins them to one.
Result<MeshPiece> own_piece(const ValidPslg& domain, const Goal& goal, const Options& options, int pieces,
                            pardel::Ranks& ranks) {
  std::vector<NumberedMesh> made;
  MeshPiece own;
  const Status status = mesh_in_pieces(domain, goal, options, ranks, pieces, [&](MeshPiece&& piece, int) -> Status {
    own.points = piece.points;
    own.triangles = piece.triangles;
    made.push_back({std::move(piece.mesh), std::move(piece.number)});
    return Done{};
  });
  if (!status) return status.error();
  Result<NumberedMesh> joined = join_some_pieces(std::move(made));
  if (!joined) return joined.error();
  own.mesh = std::move(joined->mesh);
  own.number = std::move(joined->number);
  return own;
}

PARDEL_PROPERTY(
    Ranks, make_the_filled_mesh_of_one_process,
    {.statement =
         "Where the interior is filled with equilateral triangles, one to five ranks that make one to several "
         "pieces each make the mesh that one process makes, triangle by triangle, and come to the same verdict "
         "on it.",
     .source = "properties/THEORY.md, Fill; properties/THEORY_OF_RANKS.md, Ranks",
     .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  const Options options = filling_options();
  const int count = *rc::gen::inRange(1, 6);
  const int pieces = count + *rc::gen::inRange(0, 20);

  const Meshed whole = meshed(problem, exhibit, options);
  const bool is_valid = check(problem.pslg, whole.mesh, problem.goal).valid;
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  std::vector<char> verdicts(count);
  const auto make = [&](pardel::Ranks& ranks) -> Result<MeshPiece> {
    Result<MeshPiece> piece = own_piece(domain, problem.goal, options, pieces, ranks);
    if (!piece) return piece;
    const Result<Certificate> certificate =
        check(problem.pslg, NumberedMesh{piece->mesh, piece->number}, problem.goal, {}, ranks);
    if (!certificate) return certificate.error();
    verdicts[ranks.rank()] = certificate->valid;
    return piece;
  };
  const std::string difference = difference_on_ranks(whole.mesh, count, make);
  classify(whole.report.laid > 500 && pieces > 1, "more than 500 equilateral triangles in several pieces", 20);
  RC_ASSERT(difference == "");
  for (const bool verdict : verdicts) RC_ASSERT(verdict == is_valid);
}

}  // namespace
}  // namespace pardel::properties
