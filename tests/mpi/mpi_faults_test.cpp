// Whatever happens to one rank, the job ends by itself, with a message and an exit code, and leaves no file under its
// final name that is not complete.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>

#include "../../core/formats.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../properties/domains/generators/random.hpp"
#include "../cli/program.hpp"
#include "../faults/selection.hpp"

namespace pardel {
namespace {

using testing::fault_cases;
using testing::fault_seed;
using testing::Files;
using testing::holds;
using testing::Ran;

constexpr int ranks = 3;
constexpr int most_seconds = 60;
constexpr const char* earlier = "an earlier file\n";
const Files outputs = {"out.pvtu", "out_0000.vtu", "out_0001.vtu", "out_0002.vtu"};

class MpiFaults : public testing::Workshop {
 protected:
  MpiFaults() {
    // Open MPI does not start as root unless it is told to.
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("PARDEL_FAILING_CALLS", PARDEL_FAILING_CALLS, 1);
    EXPECT_TRUE(write_poly(domains::pipe(), folder_ / "work" / "pipe.poly"));
  }

  /// Starts the ranks with a prefix before the program. A job that does not end in time gives exit code 137.
  Ran job(const std::vector<std::string>& prefix, const std::string& max_area = "1e-4",
          const std::string& reading = "auto") const {
    for (const std::string& file : outputs) write(file, earlier);
    std::vector<std::string> all{
        "--signal=KILL",      std::to_string(most_seconds), PARDEL_MPIRUN, "--oversubscribe", "--bind-to", "none", "-n",
        std::to_string(ranks)};
    all.insert(all.end(), prefix.begin(), prefix.end());
    for (const char* word : {PARDEL_MPI_PROGRAM, "mesh", "pipe.poly", "-o", "out.pvtu", "--threads", "1", "--max-area"})
      all.emplace_back(word);
    all.insert(all.end(), {max_area, "--read", reading});
    return run("timeout", all);
  }
  Ran with_faulty_rank(const std::string& how, const std::string& amount, const std::string& max_area = "1e-4") const {
    return job({PARDEL_FAULTY_RANK, "1", how, amount}, max_area);
  }
  Ran with_messages(const std::string& wrong, const std::string& max_area = "1e-4",
                    const std::string& reading = "auto") const {
    return job({"env", "LD_PRELOAD=" PARDEL_WRONG_MESSAGES, "PARDEL_WRONG=" + wrong}, max_area, reading);
  }

  void expect_earlier_files() const {
    for (const std::string& file : outputs) EXPECT_TRUE(read(file) == earlier) << file;
  }
  void expect_no_other_files() const {
    Files expected = outputs;
    expected.insert("pipe.poly");
    EXPECT_EQ(files(), expected);
  }
};

TEST_F(MpiFaults, a_rank_that_gets_a_signal_at_a_random_moment_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "the library for messages is not built with the sanitizer";
  using Clock = std::chrono::steady_clock;
  const std::string max_area = "3e-5";
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  auto start = Clock::now();
  const Ran normal = job({}, max_area);
  double seconds = seconds_since(start);  // of a whole job
  ASSERT_EQ(normal.exit_code, 0) << normal;
  std::map<std::string, std::string> complete;
  for (const std::string& file : outputs) complete[file] = read(file);

  generators::Random random(fault_seed());
  std::uint64_t ended = 0;
  const std::uint64_t cases = fault_cases(4);
  for (std::uint64_t i = 0; i < cases; ++i)
    for (const int signal : {SIGINT, SIGKILL, SIGTERM}) {
      const auto after = static_cast<long>(1e6 * random.uniform(0, seconds));
      const auto victim = static_cast<int>(random.below(ranks));
      const std::string wrong =
          "signal" + std::to_string(signal) + ":" + std::to_string(victim) + ":" + std::to_string(after);
      SCOPED_TRACE(wrong);
      start = Clock::now();
      const Ran ran = with_messages(wrong, max_area);
      EXPECT_LT(seconds_since(start), most_seconds) << "the job did not end";
      for (const std::string& file : outputs) {
        // The .pvtu is removed while the pieces get their names.
        if (file == "out.pvtu" && !exists(file)) continue;
        const std::string text = read(file);
        EXPECT_TRUE(text == earlier || text == complete[file]) << file << '\n' << ran;
      }
      for (const std::string& file : outputs)
        EXPECT_TRUE(!exists("out.pvtu") || (read(file) == earlier) == (read("out.pvtu") == earlier)) << ran;
      if (ran.exit_code == 0) {
        // A whole job takes no longer; other work may have slowed down the first one.
        seconds = std::min(seconds, seconds_since(start));
        continue;
      }
      ++ended;
      EXPECT_TRUE(ran.exit_code == 128 + signal || ran.exit_code == 130) << ran;
      EXPECT_NE(ran.err, "");
      if (HasFailure()) return;
    }
  EXPECT_GT(ended, 0U) << "all jobs ended before the signal";
}

TEST_F(MpiFaults, a_rank_without_memory_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  const Ran ran = with_faulty_rank("memory", "340000", "1e-6");
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi: rank 1: ", "memory"})) << ran;
  EXPECT_EQ(ran.err.find("interrupted"), std::string::npos) << ran;
  expect_earlier_files();
  expect_no_other_files();
}

TEST_F(MpiFaults, a_rank_with_a_full_disk_ends_the_job) {
  const Ran ran = with_faulty_rank("disk", "9000", "1e-5");
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"rank 1: ", "out_0001.vtu", "File too large"}));
  expect_earlier_files();
  expect_no_other_files();
}

TEST_F(MpiFaults, a_rank_that_cannot_write_close_or_rename_its_file_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  for (const std::string call : {"write:1+", "short:2", "close:1+", "rename:1"}) {
    const Ran ran = with_faulty_rank("call", call);
    EXPECT_EQ(ran.exit_code, 5) << call << '\n' << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel-mpi: ", "out_0001.vtu"})) << call;
    EXPECT_EQ(read("out.pvtu").find("out_0001"), std::string::npos) << "an index of pieces of two meshes";
    if (call != "rename:1") expect_earlier_files();
  }
}

TEST_F(MpiFaults, a_rank_without_threads_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  const Ran ran = with_faulty_rank("call", "thread:1");
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi: ", "cannot be started"}));
  expect_earlier_files();
}

/// A mistake, and what a rank says about it.
struct Wrong {
  const char* kind;
  const char* said;
};

class WrongMessages : public MpiFaults, public ::testing::WithParamInterface<Wrong> {};

TEST_P(WrongMessages, end_the_job_with_an_internal_error) {
  if (testing::sanitized) GTEST_SKIP() << "the library for messages is not built with the sanitizer";
  const std::string kind = GetParam().kind;
  for (const auto& [rank, reading] : {std::pair{0, "parts"}, {2, "whole"}})
    for (const int number : {2, kind == "repeat" ? 1 : 4}) {
      const std::string wrong = kind + ":" + std::to_string(rank) + ":" + std::to_string(number);
      const Ran ran = with_messages(wrong, "1e-4", reading);
      EXPECT_EQ(ran.exit_code, 6) << wrong << '\n' << ran;
      EXPECT_TRUE(holds(ran.err, {"pardel-mpi: internal error: rank ", GetParam().said})) << wrong << '\n' << ran;
      expect_earlier_files();
      expect_no_other_files();
      if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(
    That, WrongMessages,
    ::testing::Values(Wrong{"byte", "has another checksum"}, Wrong{"damaged", "is announced by damaged numbers"},
                      Wrong{"other_number", "belongs to "}, Wrong{"other_step", "belongs to "},
                      Wrong{"terms", "has another number of terms"}, Wrong{"longer", "has another checksum"},
                      Wrong{"skip", "is announced by damaged numbers"}, Wrong{"repeat", "belongs to "}),
    [](const auto& parameter) { return std::string(parameter.param.kind); });

TEST_F(MpiFaults, messages_in_another_order_and_with_delays_change_nothing) {
  if (testing::sanitized) GTEST_SKIP() << "the library for messages is not built with the sanitizer";
  const auto digest_in = [](const Ran& ran) { return ran.out.substr(ran.out.find("digest"), 40); };
  const Ran normal = job({});
  ASSERT_EQ(normal.exit_code, 0) << normal;
  for (const char* reading : {"parts", "whole"})
    for (const std::string seed : {"1", "2", "3"}) {
      const Ran ran = with_messages("reorder:" + seed + ":0", "1e-4", reading);
      ASSERT_EQ(ran.exit_code, 0) << ran;
      EXPECT_EQ(digest_in(ran), digest_in(normal));
    }
}

}  // namespace
}  // namespace pardel
