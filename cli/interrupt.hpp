// SIGINT as a question instead of a sudden end: work that asks now and then can stop and leave nothing half done.
#pragma once

#include <csignal>

namespace pardel::cli {

/// While one lives, the first SIGINT only makes requested() true; a second one ends the process as usual.
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

}  // namespace pardel::cli
