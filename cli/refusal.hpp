// An input that is refused: the error, the problems that cause it, and the JSON file that lists them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../core/result.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

/// A problem, with the numbers of its file.
struct NumberedProblem {
  NumberedProblem(const Problem& problem, const NumbersInMessages& of_file)
      : kind(problem.kind),
        numbers(problem.numbers_of_ids(of_file)),
        where(problem.where),
        message(problem.message(of_file)) {}

  ProblemKind kind;
  std::vector<std::uint64_t> numbers;
  Point where;
  std::string message;
};

struct Refusal {
  Refusal(Error why) : error(std::move(why)) {}
  Refusal(Error why, std::span<const Problem> of_domain, const NumbersInMessages& numbers) : error(std::move(why)) {
    for (const Problem& problem : of_domain) problems.emplace_back(problem, numbers);
  }

  Error error;
  std::vector<NumberedProblem> problems;  ///< empty if the error is not about points, segments, holes or regions
};

[[nodiscard]] nlohmann::ordered_json problem_json(const NumberedProblem& problem);

/// Writes the refusal of an invalid input to the file `json`, schema pardel.error/1, if `json` is not empty. `input`:
/// the input as on the command line. Returns the error that the command ends with. Other errors are only returned.
[[nodiscard]] Error refused(const Refusal& refusal, const std::filesystem::path& input,
                            const std::filesystem::path& json);

}  // namespace pardel::cli
