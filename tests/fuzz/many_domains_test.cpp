// The parts of many_domains: cases are drawn by number and have no fault, processes that crash or hang cost one case,
// and the log contains all that the summary needs.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include "../../fuzz/many_domains/generated_case.hpp"
#include "../../fuzz/many_domains/judge_case.hpp"
#include "../../fuzz/many_domains/log.hpp"
#include "../../fuzz/many_domains/record.hpp"
#include "../../fuzz/many_domains/watched_cases.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/domains/generators/lattice_domain.hpp"

namespace pardel::fuzz {
namespace {

using Verdict = Record::Verdict;

TEST(GeneratedCases, have_no_fault) {
  for (std::uint64_t number = 0; number < 600; ++number)
    EXPECT_EQ(judge(generated_case(1, number)).fault, "") << "many_domains --seed 1 --first " << number << " --cases 1";
}

TEST(GeneratedCases, depend_on_the_seed_and_the_number_only) {
  const GeneratedCase one = generated_case(7, 11), again = generated_case(7, 11);
  EXPECT_EQ(one.pslg, again.pslg);
  EXPECT_EQ(one.kinds, again.kinds);
  EXPECT_NE(generated_case(7, 12).pslg, one.pslg);
  EXPECT_NE(generated_case(8, 11).pslg, one.pslg);
}

TEST(GeneratedCases, are_valid_and_of_every_kind) {
  constexpr int cases = 2'000;
  std::map<std::string, int> of_kind;
  for (std::uint64_t number = 0; number < cases; ++number) {
    const GeneratedCase drawn = generated_case(3, number);
    EXPECT_TRUE(find_problems(drawn.pslg, {.convex_hull = drawn.goal.convex_hull, .threads = 1}).empty()) << number;
    for (const std::string& kind : drawn.kinds) ++of_kind[kind];
  }
  for (const generators::Family family : generators::all_families())
    EXPECT_GT(of_kind[name(family)], cases / 20) << name(family);
  for (const char* kind :
       {"angle0",        "angle20",  "angle28",        "angle33",  "area",     "edge",   "caps",
        "conforming",    "hull",     "field",          "grading",  "features", "search", "lattice",
        "quadtree",      "paper",    "paper_quadtree", "one_tile", "cells",    "fill",   "threads1",
        "threads2",      "threads3", "ranks1",         "ranks2",   "ranks3",   "ranks4", "floor",
        "kept_segments", "limit",    "refined_again",  "turned",   "far",      "nudged", "kept_markers"})
    EXPECT_GT(of_kind[kind], cases / 200) << kind;
}

/// Two segments of length 1 that meet at this angle, at this distance from the origin.
GeneratedCase corner_at(double x, double angle) {
  GeneratedCase drawn;
  drawn.pslg.points = {{x, 0}, {x + 1, 0}, {x + std::cos(angle), std::sin(angle)}};
  drawn.pslg.segments = {{0, 1}, {2, 0}};
  return drawn;
}

TEST(GeneratedCases, may_miss_bounds_at_small_angles_far_from_the_origin_only) {
  EXPECT_TRUE(corner_at(0x1p30, 0.01).may_miss());
  EXPECT_FALSE(corner_at(0x1p30, 0.5).may_miss());
  EXPECT_FALSE(corner_at(0x1p20, 0.01).may_miss());
}

TEST(GeneratedCases, may_need_edges_that_are_shorter_than_the_mesher_makes_far_from_the_origin) {
  const GeneratedCase drawn = generated_case(4, 858'010);
  EXPECT_TRUE(drawn.has_angles_of_rounding());
  EXPECT_EQ(judge(drawn).fault, "");
}

Record some_record(std::uint64_t number, Verdict verdict = Verdict::right, double seconds = 0.25) {
  Record record;
  record.number = number;
  record.verdict = verdict;
  record.seconds = seconds;
  record.triangles = 10;
  record.listed = 1;
  record.kinds = "cracks,angle28";
  if (verdict != Verdict::right) record.fault = "a fault, with words";
  return record;
}

TEST(Records, come_back_from_their_lines) {
  for (const Verdict verdict : {Verdict::right, Verdict::wrong, Verdict::crash, Verdict::time_out})
    EXPECT_EQ(to_record(to_line(some_record(123'456'789'012, verdict))), some_record(123'456'789'012, verdict));
  Record two_lines = some_record(1, Verdict::wrong);
  two_lines.fault = "first\nsecond";
  EXPECT_EQ(to_line(two_lines).find('\n'), std::string::npos);
}

TEST(Records, of_lines_that_were_cut_off_are_none) {
  const std::string line = to_line(some_record(17, Verdict::wrong));
  for (std::size_t length = 0; length < line.size(); ++length) EXPECT_FALSE(to_record(line.substr(0, length)));
}

class Logs : public testing::Test {
 protected:
  ~Logs() override { std::filesystem::remove(file_); }

  const std::string file_ = testing::TempDir() + "many_domains_" + std::to_string(getpid()) + ".log";
};

TEST_F(Logs, have_the_first_record_of_each_case) {
  Log(file_, 5).append(some_record(1, Verdict::right));
  Log(file_, 5).append(some_record(2, Verdict::wrong));
  Log(file_, 5).append(some_record(1, Verdict::crash));
  EXPECT_EQ(Log(file_, 5).records(), (std::vector{some_record(1, Verdict::right), some_record(2, Verdict::wrong)}));
}

TEST_F(Logs, go_on_after_a_line_that_was_cut_off) {
  Log(file_, 5).append(some_record(1, Verdict::right));
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 3);
  Log(file_, 5).append(some_record(2, Verdict::right));
  EXPECT_EQ(Log(file_, 5).records(), std::vector{some_record(2, Verdict::right)});
}

TEST_F(Logs, of_another_seed_or_in_no_folder_are_errors) {
  Log(file_, 5).append(some_record(1, Verdict::right));
  EXPECT_THROW(Log(file_, 6), std::runtime_error);
  EXPECT_EQ(Log(file_, 5).records().size(), 1U);
  EXPECT_THROW(Log("/no/such/folder/log", 5), std::runtime_error);
}

TEST_F(Logs, belong_to_one_process_at_a_time) {
  const Log log(file_, 5);
  const pid_t other = fork();
  if (other == 0) {
    try {
      const Log second(file_, 5);
      _exit(1);
    } catch (const std::runtime_error&) {
      _exit(0);
    }
  }
  int status = 0;
  ASSERT_EQ(waitpid(other, &status, 0), other);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Summary, counts_verdicts_and_kinds_and_lists_the_slowest_and_the_faults) {
  const std::vector<Record> records{some_record(1, Verdict::right, 3), some_record(2, Verdict::wrong, 1),
                                    some_record(3, Verdict::crash, 2), some_record(4, Verdict::time_out, 9)};
  const std::string text = summary_text(records, 2, "many_domains --seed 5");
  EXPECT_NE(text.find("4 cases, 40 triangles in 15.0 s"), std::string::npos) << text;
  EXPECT_NE(text.find("violations 1, crashes 1, time-outs 1"), std::string::npos) << text;
  EXPECT_NE(text.find("  angle28                      4\n  cracks                       4\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("case 4: 9.000 s, 10 triangles, cracks,angle28\n  case 1: 3.000 s"), std::string::npos) << text;
  EXPECT_NE(
      text.find("crash in case 3 (cracks,angle28): a fault, with words\n  many_domains --seed 5 --first 3 --cases"),
      std::string::npos)
      << text;
  const std::string json = summary_json(records, 2, "many_domains --seed 5");
  EXPECT_NE(json.find("\"time_outs\": 1"), std::string::npos) << json;
}

/// Runs the cases 0 to count - 1. Case 3 ends as `end` says.
std::map<std::uint64_t, Record> run_with(const std::function<void()>& end, std::uint64_t count, int jobs) {
  std::vector<std::uint64_t> numbers(count);
  for (std::uint64_t i = 0; i < count; ++i) numbers[i] = i;
  std::map<std::uint64_t, Record> found;
  const auto run = [&](std::uint64_t number, const auto& announce) {
    announce("kind" + std::to_string(number));
    if (number == 3) end();
    Record record = some_record(number);
    record.kinds = "kind" + std::to_string(number);
    return record;
  };
  run_watched(numbers, {.jobs = jobs, .seconds = 0.2, .per_process = 4}, run, [&](const Record& record) {
    EXPECT_TRUE(found.emplace(record.number, record).second) << record.number << " was run twice";
  });
  return found;
}

TEST(WatchedCases, are_all_run_once) {
  for (const int jobs : {1, 3}) {
    const auto found = run_with([] {}, 18, jobs);
    ASSERT_EQ(found.size(), 18U);
    for (const auto& [number, record] : found) EXPECT_EQ(record.verdict, Verdict::right);
  }
}

void expect_one_loss(const std::function<void()>& end, Verdict verdict, const std::string& fault) {
  const auto found = run_with(end, 10, 2);
  ASSERT_EQ(found.size(), 10U);
  for (const auto& [number, record] : found)
    EXPECT_EQ(record.verdict, number == 3 ? verdict : Verdict::right) << number;
  EXPECT_EQ(found.at(3).kinds, "kind3");
  EXPECT_EQ(found.at(3).fault, fault);
}

TEST(WatchedCases, that_crash_or_exit_cost_one_case) {
  expect_one_loss([] { std::abort(); }, Verdict::crash, "signal Aborted");
  expect_one_loss([] { _exit(7); }, Verdict::crash, "exit status 7");
}

TEST(WatchedCases, that_compute_or_wait_for_too_long_are_ended) {
  expect_one_loss(
      [] {
        for (volatile bool goes_on = true; goes_on;) {
        }
      },
      Verdict::time_out, "computes");
  expect_one_loss([] { pause(); }, Verdict::time_out, "waits");
}

}  // namespace
}  // namespace pardel::fuzz
