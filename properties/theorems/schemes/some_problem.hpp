// Random problems for the schemes, and what every scheme has to keep.
#pragma once

#include <memory>
#include <string>

#include "../../../ref/schemes/mesh/domain_mesh.hpp"
#include "../../../ref/schemes/workers/problem.hpp"
#include "../../checker/check.hpp"
#include "../../domains/generators/goals.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"

namespace pardel::properties {

inline constexpr const char* scheme_families =
    "lattice domains of every family without attributes, random goals up to "
    "20.7 degrees, 1 to 9 workers";

/// A domain with a goal, and simulated workers. The Problem refers to it, so it must live longer.
struct SchemeCase {
  Pslg pslg;
  Goal goal;
  int workers = 1;
  std::uint64_t seed = 1;
  [[nodiscard]] schemes::Problem problem() const { return {pslg, goal, workers, seed}; }
};

/// A random case. Tags it with its family. The schemes carry no attributes, and their proofs end at 20.7 degrees.
inline SchemeCase some_scheme_case(Exhibit& exhibit) {
  const auto simpler = [](const generators::Case& c) { return generators::shrinks(c); };
  generators::Case c = *generators::generator(generators::any_case, simpler);
  RC_TAG(std::string(generators::name(c.domain.family)));
  c.goal.min_angle_deg = std::min(c.goal.min_angle_deg, Goal{}.min_angle_deg);
  SchemeCase result{to_pslg(c.domain), to_goal(c.goal, c.domain)};
  result.pslg.attributes_per_point = 0;
  result.pslg.point_attributes.clear();
  result.workers = *rc::gen::inRange(1, 10);
  result.seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
  exhibit.show(result.pslg);
  return result;
}

/// The value; an error fails the case.
template <class T>
[[nodiscard]] T required(Result<T> result) {
  if (!result) RC_FAIL(result.error().message);
  return std::move(result).value();
}

/// Fails the case unless the checker certifies the mesh.
inline void certify(const schemes::LinkedMesh& mesh, const SchemeCase& c, Exhibit& exhibit) {
  const Mesh made = schemes::to_mesh(mesh, c.pslg);
  exhibit.show(c.pslg, made);
  const Certificate certificate = check(c.pslg, made, c.goal);
  if (!certificate.valid) RC_FAIL(to_text(certificate));
}

/// The mesh before any refinement.
[[nodiscard]] inline schemes::Start some_start(const SchemeCase& c) { return required(schemes::start_of(c.problem())); }

}  // namespace pardel::properties
