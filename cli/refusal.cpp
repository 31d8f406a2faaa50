#include "refusal.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "exit_code.hpp"
#include "json_text.hpp"
#include "output.hpp"

namespace pardel::cli {

nlohmann::ordered_json problem_json(const Problem& problem, int first_id) {
  std::vector<std::uint64_t> ids;
  for (const Index id : problem.ids) ids.push_back(std::uint64_t{id} + static_cast<unsigned>(first_id));
  return {{"kind", name(problem.kind)},
          {"ids", ids},
          {"where", {problem.where.x, problem.where.y}},
          {"message", problem.message(first_id)}};
}

Error refused(const Refusal& refusal, const std::filesystem::path& input, const std::filesystem::path& json) {
  if (json.empty() || refusal.error.kind != ErrorKind::invalid_input) return refusal.error;
  nlohmann::ordered_json text = {
      {"schema", "pardel.error/1"},       {"version", PARDEL_VERSION},
      {"file", input.string()},           {"exit_code", static_cast<int>(exit_code(refusal.error.kind))},
      {"message", refusal.error.message}, {"problems", nlohmann::ordered_json::array()}};
  for (const Problem& problem : refusal.problems) text["problems"].push_back(problem_json(problem, refusal.first_id));
  if (Status written = write_text(json_text(text), json); !written) return written.error();
  return refusal.error;
}

}  // namespace pardel::cli
