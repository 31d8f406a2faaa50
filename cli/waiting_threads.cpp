// Threads that wait for others soon sleep.
//
// The OpenMP library of GCC lets a waiting thread check for work 300,000 times, some milliseconds, before it sleeps. On
// a machine with other work such threads take the time of those they wait for: a mesh took two and a half times as long
// on two threads as on one. Threads that sleep after 1,000 checks lose nothing on an idle machine.
#include <cstdlib>

namespace {

// The OpenMP library reads its settings when it is loaded. It is part of the program (CMakeLists.txt), and this
// constructor has a priority, so it comes first. A setting of the user stays.
[[gnu::constructor(101)]] void let_waiting_threads_sleep() {
  if (std::getenv("OMP_WAIT_POLICY") == nullptr) setenv("GOMP_SPINCOUNT", "1000", 0);
}

}  // namespace
