#include <cstdio>
#include <cstdlib>

#include "fuzz_one.hpp"

namespace pardel::fuzz {

void fail(std::string_view explanation) {
  std::fprintf(stderr, "fuzz: the property failed: %.*s\n", static_cast<int>(explanation.size()), explanation.data());
  std::abort();
}

}  // namespace pardel::fuzz
