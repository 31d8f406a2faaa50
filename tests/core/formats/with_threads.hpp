// Tests of code that runs on as many threads as OpenMP offers.
#pragma once

#include <omp.h>

namespace pardel {

/// Calls test(n) for n = 1, 2 and 5, with n threads each time.
template <class Test>
void with_threads(const Test& test) {
  const int threads = omp_get_max_threads();
  for (const int n : {1, 2, 5}) {
    omp_set_num_threads(n);
    test(n);
  }
  omp_set_num_threads(threads);
}

}  // namespace pardel
