// A point as ranks tell each other about it.
#pragma once

#include <cstdint>

#include "../../core/pslg.hpp"

namespace pardel::engine {

/// One of the given points. Its position along the curve tells who owns it, and when it counts as inserted.
struct Site {
  Point at;
  std::uint64_t position = 0;
};

}  // namespace pardel::engine
