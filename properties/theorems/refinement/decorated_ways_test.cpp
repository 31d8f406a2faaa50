// Data on the ways that a domain and its mesh can take: repair, ranks, files, a further refinement.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/join_pieces.hpp"
#include "../../../distributed/distributed.hpp"
#include "../../../parallel/repair.hpp"
#include "../../comparison/all_arrays.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "decorated.hpp"
#include "mesh_file.hpp"
#include "repeated_points.hpp"

namespace pardel::properties {
namespace {

/// What files say: no origins, and the attributes of regions, 0 where there is none.
Mesh as_in_a_file(Mesh mesh) {
  mesh.origin.clear();
  mesh.left_out = {};
  for (ConstrainedEdge& edge : mesh.constrained_edges) edge.segment = no_index;
  std::vector<double> attributes;
  for (const Index r : mesh.region) attributes.push_back(r == no_index ? 0 : mesh.region_attributes[r]);
  mesh.region_attributes = attributes;
  std::ranges::sort(mesh.region_attributes);
  mesh.region_attributes.erase(std::unique(mesh.region_attributes.begin(), mesh.region_attributes.end()),
                               mesh.region_attributes.end());
  if (mesh.region_attributes == std::vector<double>{0}) mesh.region_attributes.clear();
  if (mesh.region_attributes.empty()) mesh.region.clear();
  for (std::size_t t = 0; t < mesh.region.size(); ++t)
    mesh.region[t] = static_cast<Index>(std::ranges::lower_bound(mesh.region_attributes, attributes[t]) -
                                        mesh.region_attributes.begin());
  return mesh;
}

Mesh made_by_ranks(const DecoratedProblem& drawn) {
  const auto& [pslg, goal] = drawn.problem;
  const ValidPslg domain = std::move(validate(pslg, {.convex_hull = goal.convex_hull})).value();
  std::vector<NumberedMesh> pieces(*rc::gen::inRange<std::size_t>(2, 4));
  on_ranks(static_cast<int>(pieces.size()), [&, &goal = goal](pardel::Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, goal, drawn.options, ranks);
    if (piece) pieces[static_cast<std::size_t>(ranks.rank())] = {std::move(piece->mesh), std::move(piece->number)};
  });
  std::erase_if(pieces, [](const NumberedMesh& piece) { return piece.mesh.points.empty(); });
  Result<Mesh> joined = join_pieces(pieces);
  if (!joined) RC_FAIL(joined.error().message);
  return std::move(joined).value();
}

PARDEL_PROPERTY(Decorated, data_stay_on_every_way,
                {.statement = "Repeat points and segments of a domain, and repair it; let several ranks make the mesh, "
                              "and join their pieces; write the mesh with elements of second order, and read it; "
                              "refine it for a goal that it meets: any of these. The mesh has the markers, attributes "
                              "and regions of the mesh that one process makes of the domain.",
                 .source = "docs/formats.md; parallel/repair.hpp; parallel/mesher.hpp",
                 .families = "lattice domains of every family; markers, attributes, bounds on sizes, options and ways "
                             "on at random and by pairs"}) {
  DecoratedProblem drawn = some_decorated_problem(exhibit);
  Pslg& pslg = drawn.problem.pslg;
  if (drawn.ways.has(Way::repaired)) {
    const Repetitions repetitions = some_repetitions(pslg);
    const RepairOptions exactly{.snap = 0, .convex_hull = drawn.problem.goal.convex_hull};
    const Result<Repaired> repaired = repair(repetitions.with_copies, exactly);
    if (!repaired) RC_FAIL(repaired.error().message);
    RC_ASSERT(repaired->domain.pslg() == repetitions.repaired);
    pslg = repaired->domain.pslg();
  }
  const Mesh whole = meshed(drawn.problem, exhibit, drawn.options).mesh;
  Mesh made = drawn.ways.has(Way::in_pieces) ? made_by_ranks(drawn) : whole;
  if (drawn.ways.has(Way::second_order)) {
    const bool is_vtu = *rc::gen::arbitrary<bool>();
    made = written_and_read(made, pslg, is_vtu ? "mesh.vtu" : "mesh.node", {.elements = ElementOrder::second});
  }
  if (drawn.ways.has(Way::refined)) made = value_of(refine(made, {}, {.min_angle_deg = 0}, {.threads = 1})).mesh;
  classify(drawn.ways.on.count() >= 2, "two ways or more", 40);
  RC_ASSERT(difference(as_in_a_file(whole), as_in_a_file(made)) == "");
}

}  // namespace
}  // namespace pardel::properties
