// Several ranks make the filled mesh of one process, piece after piece.
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../parallel/distributed.hpp"
#include "../../checker/check_pieces.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "problems_to_fill.hpp"

namespace pardel::properties {
namespace {

/// What the ranks find out about their pieces.
struct Findings {
  std::string error;
  Digest sum;
  bool valid = false;
};

/// Makes the pieces of this rank, joins them, and checks the mesh together with the other ranks.
Findings find(const ValidPslg& domain, const Goal& goal, const Options& options, int pieces, pardel::Ranks& ranks) {
  std::vector<NumberedMesh> made;
  const Status status = mesh_in_pieces(domain, goal, options, ranks, pieces, [&](MeshPiece&& piece, int) -> Status {
    made.push_back({std::move(piece.mesh), std::move(piece.number)});
    return Done{};
  });
  if (!status) return {status.error().message, {}, false};
  MeshPiece own;
  Result<NumberedMesh> joined = join_some_pieces(std::move(made));
  if (!joined) return {joined.error().message, {}, false};
  own.mesh = joined->mesh;
  Findings findings{{}, digest(own, ranks), false};
  const Result<Certificate> certificate = check(domain.pslg(), *joined, goal, {}, ranks);
  if (!certificate) findings.error = certificate.error().message;
  findings.valid = certificate && certificate->valid;
  return findings;
}

PARDEL_PROPERTY(
    Ranks, make_the_filled_mesh_of_one_process,
    {.statement = "Where the interior is filled with equilateral triangles, one to five ranks that make one to several "
                  "pieces each make the mesh that one process makes, triangle by triangle, and come to the same verdict "
                  "on it.",
     .source = "properties/THEORY.md, Fill; Ranks",
     .families = filled_families}) {
  const Problem problem = some_problem_to_fill(exhibit);
  const Options options = filling_options();
  const int count = *rc::gen::inRange(1, 6);
  const int pieces = count + *rc::gen::inRange(0, 20);

  const Meshed whole = meshed(problem, exhibit, options);
  const bool is_valid = check(problem.pslg, whole.mesh, problem.goal).valid;
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  std::vector<Findings> findings(count);
  on_ranks(count,
           [&](pardel::Ranks& ranks) { findings[ranks.rank()] = find(domain, problem.goal, options, pieces, ranks); });
  classify(whole.report.laid > 500 && pieces > 1, "more than 500 equilateral triangles in several pieces", 20);
  for (const Findings& found : findings) {
    RC_ASSERT(found.error == "");
    RC_ASSERT(found.sum == digest(whole.mesh));
    RC_ASSERT(found.valid == is_valid);
  }
}

}  // namespace
}  // namespace pardel::properties
