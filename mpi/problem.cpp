#include "problem.hpp"

#include <algorithm>
#include <utility>

#include "../cli/input.hpp"
#include "../cli/refusal.hpp"
#include "../core/support/open_file.hpp"

namespace pardel::mpi {

using namespace cli;

Status check_inputs(std::span<const std::filesystem::path> inputs, const Ranks& ranks) {
  if (ranks.count() > 1 && std::ranges::any_of(inputs, is_standard_input))
    return Error{ErrorKind::usage, "-: standard input goes to one rank only; several ranks need the name of a file"};
  return Done{};
}

Result<Problem> read_problem(const std::filesystem::path& file, const GoalOptions& options, int threads) {
  Result<Domain> domain = read_domain(file);
  if (!domain) return domain.error();
  const Result<GivenSizes> sizes = read_given_sizes(options);
  if (!sizes) return sizes.error();
  Result<ValidPslg, Refusal> valid =
      validated(std::move(*domain), {.convex_hull = options.convex_hull, .threads = threads});
  if (!valid) return valid.error().error;
  Result<Goal> goal = make_goal(options, *sizes, *valid);
  if (!goal) return goal.error();
  return Problem{std::move(*valid), std::move(*goal)};
}

}  // namespace pardel::mpi
