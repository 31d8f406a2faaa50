#include "refusal.hpp"

#include <nlohmann/json.hpp>

#include "exit_code.hpp"
#include "json_text.hpp"
#include "output.hpp"

namespace pardel::cli {

nlohmann::ordered_json problem_json(const NumberedProblem& problem) {
  return {{"kind", name(problem.kind)},
          {"ids", problem.numbers},
          {"where", {problem.where.x, problem.where.y}},
          {"message", problem.message}};
}

Error refused(const Refusal& refusal, const std::filesystem::path& input, const std::filesystem::path& json) {
  if (json.empty() || refusal.error.kind != ErrorKind::invalid_input) return refusal.error;
  nlohmann::ordered_json text = {
      {"schema", "pardel.error/1"},       {"version", PARDEL_VERSION},
      {"file", input.string()},           {"exit_code", static_cast<int>(exit_code(refusal.error.kind))},
      {"message", refusal.error.message}, {"problems", nlohmann::ordered_json::array()}};
  for (const NumberedProblem& problem : refusal.problems) text["problems"].push_back(problem_json(problem));
  if (Status written = write_text(json_text(text), json); !written) return written.error();
  return refusal.error;
}

}  // namespace pardel::cli
