#include "judge_case.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "../../parallel/mesher.hpp"
#include "../../parallel/sizes.hpp"
#include "../../properties/theorems/framework/mesh_of_ranks.hpp"
#include "../judgement.hpp"

namespace pardel::fuzz {
namespace {

std::string fault_on_one_thread(const ValidPslg& domain, const GeneratedCase& drawn, const Meshed& meshed) {
  if (drawn.options.threads == 1) return {};
  Options options = drawn.options;
  options.threads = 1;
  const Result<Meshed> one = mesh(domain, drawn.goal, options);
  if (!one) return "an error on one thread only: " + one.error().message;
  if (one->mesh != meshed.mesh) return "another mesh on one thread";
  if (one->report.exempt != meshed.report.exempt) return "another report on one thread";
  return {};
}

std::string fault_on_ranks(const ValidPslg& domain, const GeneratedCase& drawn, const Meshed& meshed) {
  if (drawn.ranks == 0) return {};
  const auto make = [&](Ranks& ranks) { return mesh(domain, drawn.goal, drawn.options, ranks); };
  try {
    return properties::difference_on_ranks(meshed.mesh, drawn.ranks, make, drawn.delays ? 1 : 0);
  } catch (const Stopped& stopped) {
    return "on " + std::to_string(drawn.ranks) + " ranks: " + stopped.error.message;
  }
}

/// The meshes of the parts of a mixture: the number of their triangles; nothing if a limit on vertices was reached.
std::optional<std::size_t> triangles_of_parts(const GeneratedCase& drawn, const Options& options) {
  std::size_t triangles = 0;
  for (const Pslg& part : drawn.parts) {
    const Result<Meshed> alone = mesh(part, drawn.goal, options);
    if (!alone || alone->report.count(ExemptReason::budget) > 0) return {};
    triangles += alone->mesh.triangles.size();
  }
  return triangles;
}

/// The largest number for one of the orders in which the parts may be refined: in tiles or not, with patches or not.
std::optional<std::size_t> most_triangles_of_parts(const GeneratedCase& drawn) {
  std::size_t most = 0;
  for (const Decomposition decomposition : {drawn.options.decomposition, Decomposition::none})
    for (const Interior interior : {drawn.options.interior, Interior::refine}) {
      Options options = drawn.options;
      options.threads = 1;
      options.decomposition = decomposition;
      options.interior = interior;
      const std::optional<std::size_t> triangles = triangles_of_parts(drawn, options);
      if (!triangles) return {};
      most = std::max(most, *triangles);
    }
  return most;
}

/// Points in no triangle make the mesh no larger. They do change the tiles, which patches of equilateral triangles give
/// way, and the order of insertion, and so which of many equally good points are inserted: measured, the number of
/// triangles exceeds the largest one of the parts by up to 6 % and 20. Above 28 degrees, and with lengths that grow
/// with the distance, the number depends more on this order. Mixtures with other components are judged by the
/// certificate alone: the faces between components are in no part.
std::string fault_of_mixture(const GeneratedCase& drawn, const Meshed& meshed) {
  const Goal& goal = drawn.goal;
  const bool is_comparable = drawn.mixtures == std::vector{generators::Mixture::far_points_outside} &&
                             goal.min_angle_deg <= 28 && goal.feature_edges == 0 &&
                             goal.grading == std::numeric_limits<double>::infinity();
  if (!is_comparable || meshed.report.count(ExemptReason::budget) > 0) return {};
  const std::optional<std::size_t> alone = most_triangles_of_parts(drawn);
  const std::size_t triangles = meshed.mesh.triangles.size();
  if (!alone || static_cast<double>(triangles) <= 1.1 * static_cast<double>(*alone) + 20) return {};
  return "far points in no triangle: " + std::to_string(triangles) + " triangles instead of " + std::to_string(*alone);
}

}  // namespace

Verdict judge(const GeneratedCase& drawn) {
  const auto domain = validate(drawn.pslg, {.convex_hull = drawn.goal.convex_hull, .threads = 1});
  if (!domain) return {"a valid domain was rejected: " + domain.error().front().message()};
  const Result<Meshed> meshed = mesh(*domain, drawn.goal, drawn.options);
  if (!meshed) return {"a valid problem was rejected: " + meshed.error().message};
  const auto longest_edge = allowed_size(*domain, drawn.goal, drawn.options);
  if (!longest_edge) return {"no lengths: " + longest_edge.error().message};

  Verdict verdict{{}, meshed->mesh.triangles.size(), meshed->report.exempt.size()};
  verdict.fault = fault_of(*meshed, {.pslg = drawn.pslg,
                                     .goal = drawn.goal,
                                     .options = drawn.options,
                                     .may_miss = drawn.may_miss(),
                                     .longest_edge = *longest_edge});
  if (verdict.fault.empty()) verdict.fault = fault_of_mixture(drawn, *meshed);
  if (verdict.fault.empty()) verdict.fault = fault_on_one_thread(*domain, drawn, *meshed);
  if (verdict.fault.empty()) verdict.fault = fault_on_ranks(*domain, drawn, *meshed);
  if (verdict.fault.empty() && drawn.refine_again)
    verdict.fault = fault_of_refining(meshed->mesh, drawn.goal, drawn.options, drawn.may_miss());
  return verdict;
}

}  // namespace pardel::fuzz
