// The names of tests whose parameter is the name of a domain.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace pardel::engine {

/// Names of tests may not contain hyphens.
inline std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace pardel::engine
