// Every stage of the engine does today what it did when the file `runs` was written: it makes the same mesh in the same
// order, asks as often whether to go on, uses as many tiles, tasks and sweeps, and finds the same problems and gaps.
// After a change that is meant to change one of these:
//   cmake --build BUILD --target recorded_runs
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <string>

#include "run_record.hpp"

namespace pardel::recorded {
namespace {

const std::multiset<std::string>& recorded_lines() {
  static const std::multiset<std::string> lines = [] {
    std::ifstream file(PARDEL_RECORDED_RUNS);
    std::multiset<std::string> read;
    for (std::string line; std::getline(file, line);) read.insert(line);
    return read;
  }();
  return lines;
}

template <class What>
void expect_as_recorded(const What& what) {
  const std::vector<std::string> stages = record(what), lines = kept(what, stages);
  for (const std::string& line : lines)
    EXPECT_TRUE(recorded_lines().contains(line)) << "not in " PARDEL_RECORDED_RUNS ": " << line;
  const auto known = std::ranges::count_if(recorded_lines(),
                                           [&](const std::string& line) { return line.starts_with(what.name + ", "); });
  EXPECT_EQ(static_cast<std::size_t>(known), lines.size()) << "lines of " << what.name;
  if (::testing::Test::HasFailure() && what.summary)
    for (const std::string& line : stages) std::cout << line << '\n';
}

/// All of a group.
template <class What>
void expect_as_recorded(const std::vector<What>& all, const std::string& group) {
  for (const What& each : all)
    if (each.group == group) expect_as_recorded(each);
}

std::string test_name(const ::testing::TestParamInfo<std::string>& group) {
  std::string name = group.param;
  std::erase_if(name, [](char c) { return c == '\''; });
  std::ranges::replace(name, ' ', '_');
  return name;
}

class RunOn : public ::testing::TestWithParam<std::string> {};
TEST_P(RunOn, takes_the_steps_that_are_recorded) { expect_as_recorded(runs(), GetParam()); }
INSTANTIATE_TEST_SUITE_P(Every, RunOn, ::testing::ValuesIn(groups_of_runs()), test_name);

class TriangulationOf : public ::testing::TestWithParam<std::string> {};
TEST_P(TriangulationOf, takes_the_steps_that_are_recorded) { expect_as_recorded(clouds(), GetParam()); }
INSTANTIATE_TEST_SUITE_P(Every, TriangulationOf, ::testing::ValuesIn(groups_of_clouds()), test_name);

class RepairOf : public ::testing::TestWithParam<std::string> {};
TEST_P(RepairOf, takes_the_steps_that_are_recorded) { expect_as_recorded(messes(), GetParam()); }
INSTANTIATE_TEST_SUITE_P(Every, RepairOf, ::testing::ValuesIn(groups_of_messes()), test_name);

}  // namespace
}  // namespace pardel::recorded
