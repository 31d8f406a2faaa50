#include "records.hpp"

#include <omp.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace pardel::files {

void write_blocks(OutputFile& out, std::size_t blocks, const std::function<void(Bytes&, std::size_t)>& format) {
  constexpr std::size_t few = 12, blocks_per_thread = 8;
  const int threads = blocks <= few ? 1 : omp_get_max_threads();
  // The blocks of a round are formatted at the same time and then written.
  std::vector<Bytes> round(std::min(blocks, blocks_per_thread * static_cast<std::size_t>(threads)));
  std::exception_ptr failure;  // no exception may leave a parallel loop
  for (std::size_t first = 0; first < blocks && out.ok(); first += round.size()) {
    const std::size_t count = std::min(round.size(), blocks - first);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) if (threads > 1)
    for (std::size_t b = 0; b < count; ++b) try {
        round[b].clear();
        format(round[b], first + b);
      } catch (...) {
#pragma omp critical(pardel_write_blocks)
        failure = std::current_exception();
      }
    if (failure) std::rethrow_exception(failure);
    for (std::size_t b = 0; b < count; ++b) out.write(round[b].view());
  }
}

}  // namespace pardel::files
