#include "validate.hpp"

#include "domain/find_problems.hpp"
#include "threads/parallel_for.hpp"

namespace pardel {

using namespace engine;

std::vector<Problem> find_problems(const Pslg& pslg, const ValidateOptions& options) try {
  StopSignal stop(StopSignal::unless(options.go_on));
  return find_problems(pslg, options,
                       Threads(thread_count(options.threads, static_cast<double>(pslg.points.size())), &stop));
} catch (const Stopped&) {
  return {{ProblemKind::cancelled, {}, {}}};
}

Result<ValidPslg, std::vector<Problem>> validate(Pslg&& pslg, const ValidateOptions& options) {
  std::vector<Problem> problems = find_problems(pslg, options);
  if (!problems.empty()) return problems;
  const bool convex_hull = options.convex_hull || pslg.segments.empty();
  return ValidPslg(std::move(pslg), convex_hull);
}

Result<ValidPslg, std::vector<Problem>> validate(const Pslg& pslg, const ValidateOptions& options) {
  std::vector<Problem> problems = find_problems(pslg, options);
  if (!problems.empty()) return problems;
  return ValidPslg(pslg, options.convex_hull || pslg.segments.empty());
}

}  // namespace pardel
