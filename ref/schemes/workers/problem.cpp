#include "problem.hpp"

namespace pardel::schemes {

Result<Start> start_of(const Problem& problem) {
  if (auto error = unsupported(problem.pslg, problem.goal)) return *error;
  Result<Triangulated> triangulated = triangulation_of(problem.pslg);
  if (!triangulated) return triangulated.error();
  Account account;
  account.sequential = account.critical = triangulated->work;
  Bounds bounds(problem.pslg, problem.goal, triangulated->mesh);
  return Start{std::move(triangulated->mesh), std::move(bounds), account};
}

Error too_many_points(const Problem& problem) {
  return {ErrorKind::resources, "The mesh would have more than " + std::to_string(problem.most_points) + " points."};
}

}  // namespace pardel::schemes
