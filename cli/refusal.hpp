// An input that is refused: the error, the problems that cause it, and the JSON file that lists them.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "../core/result.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

struct Refusal {
  Refusal(Error why) : error(std::move(why)) {}
  Refusal(Error why, std::vector<Problem> of_domain, int base)
      : error(std::move(why)), problems(std::move(of_domain)), first_id(base) {}

  Error error;
  std::vector<Problem> problems;  ///< empty if the error is not about points, segments, holes or regions
  int first_id = 0;               ///< the number of the first point in the file
};

/// One problem, with the numbering of its file.
[[nodiscard]] nlohmann::ordered_json problem_json(const Problem& problem, int first_id);

/// Writes the refusal of an invalid input to the file `json`, schema pardel.error/1, if `json` is not empty. `input`:
/// the input as on the command line. Returns the error that the command ends with. Other errors are only returned.
[[nodiscard]] Error refused(const Refusal& refusal, const std::filesystem::path& input,
                            const std::filesystem::path& json);

}  // namespace pardel::cli
