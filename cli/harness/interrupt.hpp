// Handling of SIGINT (Ctrl-C): the work polls for it and stops without leaving anything half done.
#pragma once

#include <csignal>

namespace pardel::harness {

/// While an object of this class exists, the first SIGINT makes requested() true and does nothing else. The second one
/// ends the process. A SIGINT that the process ignores stays ignored.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] bool requested() const;

 private:
  struct sigaction before_ {};
};

}  // namespace pardel::harness
