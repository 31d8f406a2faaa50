#include <cstdio>
#include <cstdlib>

#include "fuzz_one.hpp"

namespace pardel::fuzz {

void fail(std::string_view story) {
  std::fprintf(stderr, "fuzz: the property failed: %.*s\n", static_cast<int>(story.size()), story.data());
  std::abort();
}

}  // namespace pardel::fuzz
