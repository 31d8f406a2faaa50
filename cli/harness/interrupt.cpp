#include "interrupt.hpp"

namespace pardel::harness {
namespace {

// A signal handler may write to no other type of variable.
volatile std::sig_atomic_t received = 0;

void handle(int /*signal*/) { received = 1; }

}  // namespace

Interrupt::Interrupt() {
  sigaction(SIGINT, nullptr, &before_);
  if (before_.sa_handler == SIG_IGN) return;  // a shell starts background processes so
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
}

Interrupt::~Interrupt() { sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::requested() const { return received != 0; }

}  // namespace pardel::harness
