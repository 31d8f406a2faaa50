// Several ranks make and judge the mesh of one process, where scales are mixed.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../../checker/check_pieces.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "mixed_scales.hpp"
#include "problems_to_fill.hpp"

namespace pardel::properties {
namespace {

using Counts = std::vector<std::uint64_t>;

Counts counts_of(const Certificate& certificate) {
  return {certificate.violation_counts.begin(), certificate.violation_counts.end()};
}

/// What the ranks find when they check their pieces for another goal.
struct MixedFindings {
  Counts violations{};
  std::size_t triangles = 0;  ///< of the piece
};

Result<MixedFindings> judge(const MeshPiece& piece, const Problem& judged, pardel::Ranks& ranks) {
  const NumberedMesh numbered{piece.mesh, piece.number};
  const Result<Certificate> certificate = check(judged.pslg, numbered, judged.goal, {}, ranks);
  if (!certificate) return certificate.error();
  return MixedFindings{counts_of(*certificate), piece.mesh.triangles.size()};
}

PARDEL_PROPERTY(
    Ranks, make_and_judge_the_mesh_of_one_process_where_scales_are_mixed,
    {.statement = "Where scales are mixed, two to five ranks make the mesh of one process, triangle by triangle, also "
                  "if each of them has only a part of the points and segments. Together they find as many violations "
                  "in it as the checker in one process: none, or for a stricter goal, the same numbers.",
     .source = "properties/THEORY_OF_RANKS.md, Ranks",
     .families = mixed_families}) {
  MixedProblem drawn = some_mixed_problem(exhibit);
  Problem& problem = drawn.problem;
  if (!drawn.mixed.enlarges) problem.goal.max_area = box_area(drawn.mixed.parts.front()) / *rc::gen::inRange(100, 500);
  Options options = some_options();
  options.triangles_per_tile = *rc::gen::inRange(4U, 40U);
  // Most of a mesh with far points lies in one cell of a lattice.
  if (*rc::gen::inRange(0, 3) != 0) options.decomposition = Decomposition::quadtree;
  const int count = *rc::gen::inRange(2, 6);
  const bool is_dealt = can_divide_points(problem.goal, options) && *rc::gen::arbitrary<bool>();
  classify(is_dealt, "no rank has all points", 8);

  const Mesh whole = meshed(problem, exhibit, options).mesh;
  Problem judged = problem;
  judged.goal.min_angle_deg += *rc::gen::element(0, 10);
  const Certificate certificate = check(problem.pslg, whole, judged.goal);
  classify(!certificate.valid, "judged for a stricter goal that is missed", 15);
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  std::vector<MixedFindings> findings(count);
  const auto make = [&](pardel::Ranks& ranks) -> Result<MeshPiece> {
    Result<MeshPiece> piece = is_dealt ? mesh(domains::equal_part(problem.pslg, ranks), problem.goal, options, ranks)
                                       : mesh(domain, problem.goal, options, ranks);
    if (!piece) return piece;
    Result<MixedFindings> found = judge(*piece, judged, ranks);
    if (!found) return found.error();
    findings[ranks.rank()] = std::move(found).value();
    return piece;
  };
  const std::string difference = difference_on_ranks(whole, count, make);
  RC_ASSERT(difference == "");
  const std::size_t most = std::ranges::max(findings, {}, &MixedFindings::triangles).triangles;
  classify(4 * most < 3 * whole.triangles.size(), "divided among ranks", 20);
  for (const MixedFindings& found : findings) RC_ASSERT(found.violations == counts_of(certificate));
}

/// The domain without segments, holes and regions.
Pslg points_of(Pslg pslg) {
  pslg.segments.clear();
  pslg.holes.clear();
  pslg.regions.clear();
  return pslg;
}

PARDEL_PROPERTY(GivenPoints, of_mixed_scales_make_the_triangulation_of_one_process,
                {.statement = "Where scales are mixed, two to five ranks, each of which has read a part of the points, "
                              "make the Delaunay triangulation of one process.",
                 .source = "properties/THEORY_OF_RANKS.md, GivenPoints",
                 .families = mixed_families}) {
  const Pslg points = points_of(some_mixed_problem(exhibit).problem.pslg);
  const Mesh whole = value_of(triangulate(points)).mesh;
  const int count = *rc::gen::inRange(2, 6);
  const std::string difference = difference_on_ranks(whole, count, [&](pardel::Ranks& ranks) {
    return triangulate(domains::equal_part(points, ranks).points, {.threads = 1}, ranks);
  });
  RC_ASSERT(difference == "");
}

}  // namespace
}  // namespace pardel::properties
