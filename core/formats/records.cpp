#include "records.hpp"

#include <omp.h>

#include <atomic>

#include "../support/exception_of.hpp"

namespace pardel::files {

void Bytes::grow(std::size_t size) {
  const std::size_t used = this->size();
  buffer_.resize_uninitialised(used + size);
  end_ = buffer_.data() + used;
}

void write_blocks(OutputFile& out, std::size_t blocks, const std::function<void(Bytes&, std::size_t)>& format) {
  constexpr std::size_t few = 4;
  const int threads = blocks <= few ? 1 : omp_get_max_threads();
  std::exception_ptr failure;  // of the first block that has one
  std::atomic<bool> stopped = !out.ok();
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    Bytes bytes;
#pragma omp for ordered schedule(dynamic, 1)
    for (std::size_t b = 0; b < blocks; ++b) {
      std::exception_ptr mine;
      bytes.clear();
      if (!stopped) mine = exception_of([&] { format(bytes, b); });
#pragma omp ordered
      if (!stopped) {
        if (!mine) mine = exception_of([&] { out.write(bytes.view()); });
        failure = mine;
        stopped = failure || !out.ok();
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace pardel::files
