#include "interrupt.hpp"

namespace pardel::cli {
namespace {

// A signal handler can speak to the rest of the program only through an object like this.
volatile std::sig_atomic_t asked_to_stop = 0;

void remember(int /*signal*/) { asked_to_stop = 1; }

}  // namespace

Interrupt::Interrupt() {
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_);
}

Interrupt::~Interrupt() { sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::requested() const { return asked_to_stop != 0; }

}  // namespace pardel::cli
