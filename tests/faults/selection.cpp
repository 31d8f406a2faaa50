#include "selection.hpp"

#include <algorithm>
#include <cstdlib>

#include "../../properties/domains/generators/random.hpp"

namespace pardel::testing {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace

std::uint64_t fault_cases(std::uint64_t usual) { return from_environment("PARDEL_FAULT_CASES", usual); }
std::uint64_t fault_seed() { return from_environment("PARDEL_FAULT_SEED", 1); }

std::vector<std::uint64_t> selection(std::uint64_t all, std::uint64_t usual) {
  const std::uint64_t cases = std::min(all, fault_cases(usual));
  generators::Random random(fault_seed());
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const std::uint64_t begin = all * i / cases, end = all * (i + 1) / cases;
    numbers.push_back(begin + 1 + random.below(end - begin));
  }
  return numbers;
}

}  // namespace pardel::testing
