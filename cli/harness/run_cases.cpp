#include "run_cases.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

namespace pardel::harness {

namespace fs = std::filesystem;

Status run_tasks(std::size_t count, int threads, const std::function<Status(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  std::mutex guard;
  std::optional<Error> first;  // protected by guard
  const auto run = [&] {
    omp_set_num_threads(1);  // for this thread: the checker's parallel loops must not compete for the cores
    for (std::size_t i; (i = next++) < count;) {
      const Status status = task(i);
      if (status) continue;
      next = count;
      const std::lock_guard<std::mutex> lock(guard);
      if (!first) first = status.error();
    }
  };
  std::vector<std::jthread> pool;
  pool.reserve(static_cast<std::size_t>(threads));
  for (int k = 0; k < threads; ++k) pool.emplace_back(run);
  pool.clear();  // joins the threads
  if (first) return *first;
  return Done{};
}

Result<std::vector<Outcome>> run_cases(const Trials& trials, std::span<const CaseId> cases, int threads,
                                       const fs::path& folder, bool keep,
                                       const std::function<void(std::size_t)>& done) {
  std::vector<Outcome> outcomes(cases.size());
  std::atomic<std::size_t> finished = 0;
  const Status status = run_tasks(cases.size(), threads, [&](std::size_t i) -> Status {
    const CaseId& id = cases[i];
    const fs::path own = folder / fmt::format("{}-{}-{}", id.seed, name(id.family), id.index);
    Result<Outcome> outcome = try_mesher(trials, make_case(id), own);
    std::error_code ignored;
    if (!keep) fs::remove_all(own, ignored);
    if (!outcome) return outcome.error();
    outcomes[i] = std::move(*outcome);
    done(++finished);
    return Done{};
  });
  if (!status) return status.error();
  return outcomes;
}

}  // namespace pardel::harness
