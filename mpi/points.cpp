#include "points.hpp"

#include <utility>
#include <vector>

#include "../cli/problems_text.hpp"
#include "../distributed/distributed.hpp"

namespace pardel::mpi {

Error fault_of_points(const Error& error, const std::filesystem::path& file, int threads, Job& job) {
  if (error.kind != ErrorKind::invalid_input) job.abort(error);
  Result<PartOfPslg> input = read_part_of_pslg(file, job.ranks());
  if (!input) return input.error();
  PartOfPoints& points = input->points;
  const int first_id = points.first_id.value;
  const std::vector<pardel::Problem> problems = find_problems(std::move(points), threads, job.ranks());
  if (problems.empty()) return {error.kind, file.string() + ": " + error.message};  // the file has changed
  return {error.kind, file.string() + ": " + cli::problems_text(problems, {.base = first_id}) +
                          cli::advice({}, problems, file.string(), false)};
}

}  // namespace pardel::mpi
