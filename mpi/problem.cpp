#include "problem.hpp"

#include <algorithm>
#include <utility>

#include "../cli/input.hpp"
#include "../cli/kept_segments.hpp"
#include "../cli/refusal.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/stopwatch.hpp"

namespace pardel::mpi {

using namespace cli;

Status check_inputs(std::span<const std::filesystem::path> inputs, const Ranks& ranks) {
  if (ranks.count() > 1 && std::ranges::any_of(inputs, is_standard_input))
    return Error{ErrorKind::usage, "-: standard input goes to one rank only; several ranks need the name of a file"};
  return Done{};
}

Result<Problem, Refusal> read_problem(const std::filesystem::path& file, const GoalOptions& options,
                                      const HowToRead& how) {
  Result<Domain> domain = read_domain(file);
  if (!domain) return Refusal(domain.error());
  const Result<GivenSizes> sizes = read_given_sizes(options, how.in_sources);
  if (!sizes) return Refusal(sizes.error());
  const Stopwatch watch;
  Result<MaybeRepaired, Refusal> valid =
      valid_domain(std::move(*domain), how.repair, {.snap = how.snap, .convex_hull = options.convex_hull}, how.threads);
  if (!valid) return valid.error();
  if (Status kept = check_kept_segments(*valid, how.kept_markers); !kept)
    return Refusal(with_name(kept.error(), file.string()));
  if (Status fits = check_sizes_of(*valid, sizes->field); !fits) return Refusal(fits.error());
  const double validate_seconds = watch.seconds();
  Result<Goal> goal = make_goal(options, *sizes, valid->domain);
  if (!goal) return Refusal(goal.error());
  return Problem{std::move(valid->domain), std::move(*goal), std::move(valid->log), validate_seconds};
}

std::optional<Refusal> common_refusal(const Result<Problem, Refusal>& problem, Job& job) {
  const Status all = job.agree(problem ? Status(Done{}) : problem.error().error);
  if (all) return std::nullopt;
  Refusal refusal = problem ? Refusal(all.error()) : problem.error();
  refusal.error = all.error();
  return refusal;
}

}  // namespace pardel::mpi
