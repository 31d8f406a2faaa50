// Lattice: the engine's decomposition `paper`, compared with the reference, in which each cell is refined to the end.
#include <algorithm>

#include "../framework/shares.hpp"
#include "meshing.hpp"
#include "refined_channels.hpp"

namespace pardel::properties {
namespace {

PARDEL_PROPERTY(
    EngineAgainstReference, on_the_papers_lattice_neither_hands_on_a_circumcentre,
    {.statement = "Refine a domain on the paper's lattice with the engine, and with the reference, which refines each "
                  "cell of a phase to the end. In the engine, no point of a face leaves the box of its cell: no "
                  "triangle with such a split point is handed on to a larger box. Both meshes are certified without "
                  "exempt triangles. The engine makes at most twice as many triangles as the reference, and the "
                  "reference at most 1.5 times as many as the engine. (The most in 4,000 cases: 1.74 and 1.4 times.)",
     .source = "[CC], the uniform lattice; properties/THEORY.md, Lattice (c)",
     .families = "channels; meshes of 24 triangles or more"}) {
  const Channel channel = some_channel(exhibit);
  const Pslg pslg = to_pslg(channel);
  const Goal goal = goal_of(channel);
  const ref::LatticeRefinement reference = refined_in_turns(channel, ref::one_after_the_other);
  const Options options{.placement = Placement::circumcentre,
                        .threads = 1,
                        .decomposition = Decomposition::paper,
                        .triangles_per_tile = 1};
  const Meshed engine = value_of(mesh(pslg, goal, options));
  exhibit.show(pslg, engine.mesh);
  std::uint64_t beyond = 0;
  Index cells = 0;
  for (const Sweep& sweep : engine.report.tiling.sweeps) {
    RC_ASSERT(sweep.against_promise == 0U);
    beyond += sweep.beyond_box;
    cells = std::max(cells, sweep.columns * sweep.rows);
  }
  for (const Mesh& result : {engine.mesh, reference.mesh}) {
    const Certificate certificate = check(pslg, result, goal);
    require_valid(certificate);
    RC_ASSERT(certificate.justified.empty());
  }
  const std::size_t ours = engine.mesh.triangles.size(), theirs = reference.mesh.triangles.size();
  RC_PRE(theirs >= 24U);
  RC_ASSERT(ours <= 2 * theirs);
  RC_ASSERT(2 * theirs <= 3 * ours);
  classify(cells >= 4, "the engine's lattice has four cells or more", 15);
  classify(beyond == 0, "the engine hands no triangle on to a larger box, for any reason", 99);
}

}  // namespace
}  // namespace pardel::properties
