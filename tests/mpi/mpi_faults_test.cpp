// Whatever happens to one rank, the job ends by itself, with a message and an exit code, and leaves no file under its
// final name that is not complete.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <ostream>
#include <tuple>

#include "../../core/formats.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../properties/domains/generators/random.hpp"
#include "../cli/program.hpp"
#include "../faults/selection.hpp"
#include "mpi_workshop.hpp"

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
    testing::prepare_for_jobs(folder_);
    setenv("PARDEL_FAILING_CALLS", PARDEL_FAILING_CALLS, 1);
    EXPECT_TRUE(write_poly(domains::pipe(), folder_ / "work" / "pipe.poly"));
  }

  /// Starts the ranks with a prefix before the program. A job that does not end in time gives exit code 137.
  Ran job(const std::vector<std::string>& prefix, const std::vector<std::string>& command) const {
    std::vector<std::string> all{
        "--signal=KILL",      std::to_string(most_seconds), PARDEL_MPIRUN, "--oversubscribe", "--bind-to", "none", "-n",
        std::to_string(ranks)};
    all.insert(all.end(), prefix.begin(), prefix.end());
    all.emplace_back(PARDEL_MPI_PROGRAM);
    all.insert(all.end(), command.begin(), command.end());
    return run("timeout", all);
  }
  /// The pipe, on many tiles.
  static std::vector<std::string> mesh(const std::string& max_area = "1e-4", const std::string& reading = "auto") {
    return {"mesh",       "pipe.poly", "-o",     "out.pvtu", "--triangles-per-tile", "300", "--threads", "1",
            "--max-area", max_area,    "--read", reading};
  }
  Ran with_faulty_rank(const std::string& how, const std::string& amount,
                       const std::vector<std::string>& command = mesh()) const {
    write_earlier_files();
    return job({PARDEL_FAULTY_RANK, "1", how, amount}, command);
  }
  Ran with_messages(const std::string& wrong, const std::vector<std::string>& command = mesh()) const {
    write_earlier_files();
    return job({"env", "LD_PRELOAD=" PARDEL_WRONG_MESSAGES, "PARDEL_WRONG=" + wrong}, command);
  }

  void write_earlier_files() const {
    for (const std::string& file : outputs) write(file, earlier);
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
  const std::vector<std::string> command = mesh("3e-5");
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  auto start = Clock::now();
  const Ran normal = job({}, command);
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
      const Ran ran = with_messages(wrong, command);
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
  // A rank that is killed while files replace others can leave partial names. The next job removes them.
  ASSERT_EQ(job({}, command).exit_code, 0);
  expect_no_other_files();
}

/// The common files have no names before they are complete, unless a rank cannot open them then. The rank 0 makes them.
TEST_F(MpiFaults, ranks_write_common_files_also_where_files_need_names) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  const std::vector<std::string> command = {"mesh", "pipe.poly", "-o", "out.node", "--max-area", "1e-4"};
  ASSERT_EQ(job({}, command).exit_code, 0);
  const Files common = {"out.node", "out.ele", "out.poly"};
  const Files all = files();
  std::map<std::string, std::string> complete;
  for (const std::string& file : common) complete[file] = read(file);
  for (const std::string rank : {"0", "1"}) {
    for (const std::string& file : common) write(file, earlier);
    const Ran ran = job({PARDEL_FAULTY_RANK, rank, "call", rank == "0" ? "unnamed:1+" : "open:1"}, command);
    EXPECT_EQ(ran.exit_code, 0) << ran;
    for (const std::string& file : common) EXPECT_TRUE(read(file) == complete[file]) << file << '\n' << ran;
    EXPECT_EQ(files(), all);
  }
}

TEST_F(MpiFaults, a_rank_without_memory_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  for (const auto& [how, amount, said] :
       {std::tuple{"memory", "300000", "memory"}, {"call", "large:1000000", "out of memory"}}) {
    const Ran ran = with_faulty_rank(how, amount, mesh("1e-6"));
    EXPECT_EQ(ran.exit_code, 5) << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel-mpi: rank 1: ", said})) << ran;
    EXPECT_EQ(ran.err.find("interrupted"), std::string::npos) << ran;
    expect_earlier_files();
    expect_no_other_files();
  }
}

TEST_F(MpiFaults, a_rank_with_a_full_disk_ends_the_job) {
  const Ran ran = with_faulty_rank("disk", "9000", mesh("1e-5"));
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
    expect_earlier_files();
    expect_no_other_files();
  }
  const Files pieces = {"out_1.msh", "out_2.msh", "out_3.msh"};
  for (const std::string& file : pieces) write(file, earlier);
  const Ran ran = with_faulty_rank("call", "rename:1", {"mesh", "pipe.poly", "-o", "out.msh", "--max-area", "1e-4"});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"rank 1: ", "out_2.msh", "cannot be put in place"})) << ran;
  for (const std::string& file : pieces) EXPECT_TRUE(read(file) == earlier) << file;
}

TEST_F(MpiFaults, a_rank_without_threads_ends_the_job) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  const Ran ran = with_faulty_rank("call", "thread:1");
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel-mpi: ", "cannot be started"}));
  expect_earlier_files();
}

/// A command and the files that it writes.
struct Job {
  const char* name;
  std::vector<std::string> command;
  std::vector<std::string> outputs;
  friend void PrintTo(const Job& job, std::ostream* out) { *out << job.name; }
};

class FaultsOfOtherJobs : public MpiFaults, public ::testing::WithParamInterface<Job> {
 protected:
  FaultsOfOtherJobs() {
    write_earlier_files();
    const Ran meshed = job({}, {"mesh", "pipe.poly", "-o", "made.pvtu", "--max-area", "1e-5"});
    EXPECT_EQ(meshed.exit_code, 0) << meshed;
    EXPECT_TRUE(write_poly(domains::random_points(100'000, 3), folder_ / "work" / "points.poly"));
    for (const std::string& file : GetParam().outputs) write(file, earlier);
    before_ = files();
  }
  void expect_no_change(const Ran& ran) const {
    EXPECT_EQ(files(), before_) << ran;
    for (const std::string& file : GetParam().outputs) EXPECT_TRUE(read(file) == earlier) << file << '\n' << ran;
  }

 private:
  Files before_;
};

TEST_P(FaultsOfOtherJobs, end_them_with_a_message) {
  if (testing::sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  const Ran poor = job({PARDEL_FAULTY_RANK, "1", "call", "large:200000"}, GetParam().command);
  EXPECT_EQ(poor.exit_code, 5) << poor;
  EXPECT_TRUE(holds(poor.err, {"pardel-mpi: rank 1: ", "out of memory"})) << poor;
  expect_no_change(poor);
  if (!GetParam().outputs.empty()) {
    const Ran full = job({PARDEL_FAULTY_RANK, "1", "disk", "1"}, GetParam().command);
    EXPECT_EQ(full.exit_code, 5) << full;
    EXPECT_TRUE(holds(full.err, {"rank 1: ", "File too large"})) << full;
    expect_no_change(full);
    for (const std::string call : {"write:1+", "close:1+"}) {
      const Ran failed = job({PARDEL_FAULTY_RANK, "1", "call", call}, GetParam().command);
      EXPECT_EQ(failed.exit_code, 5) << call << '\n' << failed;
      EXPECT_TRUE(holds(failed.err, {"rank 1: ", "cannot be written"})) << call << '\n' << failed;
      expect_no_change(failed);
    }
  }
  const Ran killed =
      job({"env", "LD_PRELOAD=" PARDEL_WRONG_MESSAGES, "PARDEL_WRONG=signal9:1:5000"}, GetParam().command);
  EXPECT_EQ(killed.exit_code, 137) << killed;
  EXPECT_TRUE(holds(killed.err, {"signal 9"})) << killed;
  for (const std::string& file : GetParam().outputs) EXPECT_TRUE(read(file) == earlier) << file << '\n' << killed;
}

INSTANTIATE_TEST_SUITE_P(
    Each, FaultsOfOtherJobs,
    ::testing::Values(Job{"to_msh",
                          {"mesh", "pipe.poly", "-o", "out.msh", "--max-area", "1e-5"},
                          {"out_1.msh", "out_2.msh", "out_3.msh"}},
                      Job{"to_node",
                          {"mesh", "pipe.poly", "-o", "out.node", "--max-area", "1e-5"},
                          {"out.node", "out.ele", "out.poly"}},
                      Job{"of_a_divided_domain",
                          {"mesh", "points.poly", "-o", "out.pvtu", "--read", "parts"},
                          {"out.pvtu", "out_0000.vtu", "out_0001.vtu", "out_0002.vtu"}},
                      Job{"in_many_pieces",
                          {"mesh", "pipe.poly", "-o", "out.pvtu", "--max-area", "1e-6", "--interior", "fill",
                           "--pieces", "6"},
                          {"out.pvtu", "out_0000.vtu", "out_0001.vtu", "out_0005.vtu"}},
                      Job{"that_triangulate",
                          {"triangulate", "points.poly", "-o", "out.msh"},
                          {"out_1.msh", "out_2.msh", "out_3.msh"}},
                      Job{"that_check", {"check", "pipe.poly", "made.pvtu", "--max-area", "1e-5"}, {}}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

/// A mistake, and what a rank says about it.
struct Wrong {
  const char* kind;
  const char* said;
  friend void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.kind; }
};

class WrongMessages : public MpiFaults, public ::testing::WithParamInterface<Wrong> {};

TEST_P(WrongMessages, end_the_job_with_an_internal_error) {
  if (testing::sanitized) GTEST_SKIP() << "the library for messages is not built with the sanitizer";
  const std::string kind = GetParam().kind;
  for (const auto& [rank, reading] : {std::pair{0, "parts"}, {2, "whole"}})
    for (const int number : {2, kind == "repeat" ? 4 : 12}) {
      const std::string wrong = kind + ":" + std::to_string(rank) + ":" + std::to_string(number);
      const Ran ran = with_messages(wrong, mesh("1e-4", reading));
      EXPECT_EQ(ran.exit_code, 6) << wrong << '\n' << ran;
      EXPECT_TRUE(holds(ran.err, {"pardel-mpi: internal error: rank ", GetParam().said})) << wrong << '\n' << ran;
      expect_earlier_files();
      expect_no_other_files();
      if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(That, WrongMessages,
                         ::testing::Values(Wrong{"byte", "has another checksum"},
                                           Wrong{"damaged", "is announced by damaged numbers"},
                                           Wrong{"other_number", "belongs to "}, Wrong{"other_step", "belongs to "},
                                           Wrong{"terms", "has another number of terms"},
                                           Wrong{"longer", "has another checksum"}, Wrong{"skip", "belongs to "},
                                           Wrong{"repeat", "belongs to "}),
                         [](const auto& parameter) { return std::string(parameter.param.kind); });

TEST_F(MpiFaults, messages_in_another_order_and_with_delays_change_nothing) {
  if (testing::sanitized) GTEST_SKIP() << "the library for messages is not built with the sanitizer";
  const auto digest_in = [](const Ran& ran) { return ran.out.substr(ran.out.find("digest"), 40); };
  const Ran normal = job({}, mesh());
  ASSERT_EQ(normal.exit_code, 0) << normal;
  for (const char* reading : {"parts", "whole"})
    for (const std::string seed : {"1", "2", "3"}) {
      const Ran ran = with_messages("reorder:" + seed + ":0", mesh("1e-4", reading));
      ASSERT_EQ(ran.exit_code, 0) << ran;
      EXPECT_EQ(digest_in(ran), digest_in(normal));
    }
}

}  // namespace
}  // namespace pardel
