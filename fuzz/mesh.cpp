// Decodes the bytes to a case, meshes it and checks the result exactly. Every mesh must be valid. A bound may be missed
// only in triangles that the report lists, and only for a reason that the case allows.
#include <string>

#include "../parallel/mesher.hpp"
#include "../parallel/sizes.hpp"
#include "../parallel/validate.hpp"
#include "fuzz_one.hpp"
#include "judgement.hpp"
#include "mesh_case.hpp"

namespace pardel::fuzz {
namespace {

/// True if the options or the domain are a reason why a bound may be missed: a least edge, segments that may not be
/// split, points a few units in the last place from their neighbours, small angles far off, an angle for which there is
/// no proof.
bool may_miss(const MeshCase& drawn, const Prepared& prepared) {
  return drawn.options.min_edge > 0 || !may_split_all_segments(drawn.options) || drawn.nudged || prepared.far_off ||
         drawn.goal.min_angle_deg > 30;
}

void require(const std::string& fault) {
  if (!fault.empty()) fail(fault);
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const MeshCase drawn = decode_mesh_case(bytes);
  const Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  const auto domain = validate(prepared.pslg, {.convex_hull = drawn.goal.convex_hull});
  if (!domain) fail("the repaired Pslg is not valid: " + domain.error().front().message());
  Options options = drawn.options;
  const auto longest_edge = allowed_size(*domain, drawn.goal, options);
  if (!longest_edge) fail("no lengths: " + longest_edge.error().message);
  for (const Interior interior : {Interior::refine, Interior::fill}) {
    options.interior = interior;
    const Result<Meshed> meshed = mesh(*domain, drawn.goal, options);
    if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
    require(fault_of(*meshed, {.pslg = prepared.pslg,
                               .goal = drawn.goal,
                               .options = options,
                               .may_miss = may_miss(drawn, prepared),
                               .longest_edge = *longest_edge}));
    if (drawn.refine_again && interior == Interior::refine)
      require(fault_of_refining(meshed->mesh, drawn.goal, options, may_miss(drawn, prepared)));
  }
  return 0;
}

}  // namespace pardel::fuzz
