// Helpers for the properties of the engine: random meshing problems, and functions that mesh and check them.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>

#include "../../../parallel/mesher.hpp"
#include "../../checker/check.hpp"
#include "../../domains/generators/goals.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"

namespace pardel::properties {

inline constexpr const char* every_family = "lattice domains of every family, random goals";

struct Problem {
  Pslg pslg;
  Goal goal;
};

/// A random domain with a random goal. Tags the case with its family, for the catalogue.
inline generators::Case some_case(Exhibit& exhibit) {
  const auto simpler = [](const generators::Case& c) { return generators::shrinks(c); };
  const generators::Case c = *generators::generator(generators::any_case, simpler);
  RC_TAG(std::string(generators::name(c.domain.family)));
  exhibit.show(to_pslg(c.domain));
  return c;
}
inline Problem to_problem(const generators::Case& c) { return {to_pslg(c.domain), to_goal(c.goal, c.domain)}; }
inline Problem some_problem(Exhibit& exhibit) { return to_problem(some_case(exhibit)); }

/// The width of the domain, or its height, whichever is larger.
inline double extent_of(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  return std::max(right.x - left.x, high.y - low.y);
}

/// The value of `meshed`; an error fails the case.
inline Meshed value_of(Result<Meshed> meshed) {
  if (!meshed) RC_FAIL(meshed.error().message);
  return std::move(meshed).value();
}
inline Meshed meshed(const Problem& problem, Exhibit& exhibit, const Options& options = {}) {
  Meshed result = value_of(mesh(problem.pslg, problem.goal, options));
  exhibit.show(problem.pslg, result.mesh);
  return result;
}

/// Fails the case with the text of the certificate if the certificate is not valid.
inline void require_valid(const Certificate& certificate) {
  if (!certificate.valid) RC_FAIL(to_text(certificate));
}

/// Random options for one thread: the placement of points, the decomposition of the plane, and the number of triangles
/// per tile. With a small number, even small domains have many tiles and several levels of lattices.
inline Options some_options() {
  constexpr auto tiny = 4U;
  Options options{.threads = 1};
  options.placement = *rc::gen::element(Placement::off_centre, Placement::circumcentre, Placement::search);
  options.decomposition = *rc::gen::element(Decomposition::automatic, Decomposition::paper, Decomposition::none);
  options.triangles_per_tile = *rc::gen::element(options.triangles_per_tile, tiny);
  return options;
}

}  // namespace pardel::properties
