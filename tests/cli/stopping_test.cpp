// SIGINT, SIGTERM and SIGHUP stop every command in every step, with exit code 130, and leave no partial file. Pipes
// that nobody reads or writes hold a command in a step.
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "../is_gone.hpp"
#include "../with_variable.hpp"
#include "program.hpp"

namespace pardel::testing {
namespace {

namespace fs = std::filesystem;

class Stopping : public Workshop {
 protected:
  Stopping() {
    write("square.poly", square_poly);
    pardel({"mesh", "square.poly", "-o", "old.node", "-q"});
    start_ = files();
  }

  void make_pipe(const std::string& name) {
    ASSERT_EQ(mkfifo((folder_ / "work" / name).c_str(), 0600), 0);
    start_.insert(name);
  }

  /// Expects that the signal stops a command as soon as it shows `step`, and that it leaves the files as they were.
  void expect_stop(const std::vector<std::string>& arguments, const RunOptions& how) {
    const Ran ran = pardel(arguments, how);
    EXPECT_EQ(ran.exit_code, 130) << ran;
    EXPECT_TRUE(holds(ran.err, {"pardel: interrupted\n"}));
    EXPECT_EQ(files(), start_);
  }
  /// The same for commands that show their progress on a terminal only, after a second.
  void expect_stop_on_terminal(const std::vector<std::string>& arguments, const std::string& step) {
    if (!terminals_exist()) GTEST_SKIP() << "no pseudo-terminals here (is /dev/pts mounted?)";
    const Ran ran = pardel(arguments, {.interrupt_when = step, .terminal = true});
    EXPECT_EQ(ran.exit_code, 130) << ran;
    EXPECT_TRUE(holds(ran.err, {step, "\r\033[Kpardel: interrupted"}));
    EXPECT_EQ(files(), start_);
  }

  Files start_;
};

TEST_F(Stopping, interrupts_mesh_while_it_reads) {
  make_pipe("pipe.poly");
  expect_stop({"mesh", "pipe.poly", "-o", "out.vtu", "--progress", "always"}, {.interrupt_when = "reading"});
}

TEST_F(Stopping, interrupts_mesh_while_it_refines) {
  expect_stop({"mesh", "square.poly", "-o", "out.vtu", "-o", "out.node", "--max-area", "5e-8", "--interior", "refine",
               "--progress", "always"},
              {.interrupt_when = "triangles"});
}

TEST_F(Stopping, interrupts_mesh_while_a_sequential_mesher_works_and_leaves_no_process_and_no_folder) {
  // The program stops its parent, and would then go on for ever.
  write("stopper", "#!/bin/sh\necho $$ > stopper.pid\nkill -INT $PPID\nexec sleep 600\n");
  fs::permissions(folder_ / "work" / "stopper", fs::perms::owner_all);
  fs::create_directory(folder_ / "work" / "temporary");
  const WithVariable temporary("TMPDIR", folder_ / "work" / "temporary");
  start_.insert({"stopper", "stopper.pid", "temporary"});
  expect_stop({"mesh", "square.poly", "-o", "out.vtu", "--max-area", "1e-3", "--mesher", "./stopper {mesh}"}, {});
  EXPECT_TRUE(fs::is_empty(folder_ / "work" / "temporary"));
  EXPECT_TRUE(is_gone(read("stopper.pid")));
}

TEST_F(Stopping, interrupts_mesh_while_it_checks) {
  expect_stop({"mesh", "square.poly", "-o", "out.vtu", "--max-area", "5e-7", "--check", "--progress", "always"},
              {.interrupt_when = "checking"});
}

TEST_F(Stopping, interrupts_mesh_while_it_writes_and_keeps_the_earlier_files) {
  make_pipe("out.poly");  // written after out.node and out.ele, which get their names together with it
  write("out.node", "earlier");
  start_.insert("out.node");
  expect_stop({"mesh", "square.poly", "-o", "out.ele", "--progress", "always"}, {.interrupt_when = "writing"});
  EXPECT_EQ(read("out.node"), "earlier");
}

TEST_F(Stopping, is_the_same_for_SIGTERM) {
  make_pipe("out.poly");
  expect_stop({"mesh", "square.poly", "-o", "out.ele", "--progress", "always"},
              {.interrupt_when = "writing", .signal = SIGTERM});
}

TEST_F(Stopping, is_the_same_for_SIGHUP) {
  make_pipe("out.poly");
  expect_stop({"mesh", "square.poly", "-o", "out.ele", "--progress", "always"},
              {.interrupt_when = "writing", .signal = SIGHUP});
}

TEST_F(Stopping, does_not_happen_by_a_signal_that_the_program_was_told_to_ignore) {
  for (const int signal : {SIGINT, SIGHUP, SIGTERM}) {
    const Ran ran = pardel(
        {"mesh", "square.poly", "-o", "out.off", "--max-area", "2e-6", "--interior", "refine", "--progress", "always"},
        {.interrupt_when = "triangles", .signal = signal, .ignored_signal = signal});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    EXPECT_TRUE(exists("out.off"));
  }
}

TEST_F(Stopping, at_the_limit_on_processor_time_leaves_no_partial_file) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--max-area", "1e-8", "--interior", "refine"},
                         {.processor_time = 1});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel: the process has reached the limit on its processor time\n"}));
  EXPECT_EQ(files(), start_);
}

TEST_F(Stopping, at_the_limit_on_the_size_of_files_leaves_no_partial_file) {
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu", "--max-area", "0.0001"},
                         {.file_size_limit = 40'000, .file_size_signal = true});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"out.vtu: cannot be written: File too large"}));
  EXPECT_EQ(files(), start_);
}

TEST_F(Stopping, that_cannot_be_watched_for_is_an_error) {
  if (sanitized) GTEST_SKIP() << "a sanitizer's shadow memory alone is larger than the limit";
  const Ran ran = pardel({"mesh", "square.poly", "-o", "out.vtu"},
                         {.address_space = std::uint64_t{8} << 30, .stack_size = std::uint64_t{64} << 30});
  EXPECT_EQ(ran.exit_code, 5) << ran;
  EXPECT_TRUE(holds(ran.err, {"pardel: the thread that watches signals cannot be started: "}));
  EXPECT_EQ(files(), start_);
}

TEST_F(Stopping, interrupts_check_while_it_reads) {
  make_pipe("pipe.off");
  expect_stop({"check", "square.poly", "pipe.off", "--progress", "always"}, {.interrupt_when = "reading pipe.off"});
}

TEST_F(Stopping, interrupts_doctor) {
  make_pipe("pipe.poly");
  expect_stop_on_terminal({"doctor", "pipe.poly", "--repair", "fixed.poly"}, "reading");
}

TEST_F(Stopping, interrupts_convert_while_it_writes) {
  make_pipe("out.off");
  expect_stop_on_terminal({"convert", "old.ele", "out.off"}, "writing");
}

TEST_F(Stopping, interrupts_draw) {
  make_pipe("pipe.off");
  expect_stop_on_terminal({"draw", "pipe.off", "out.png"}, "reading");
}

TEST_F(Stopping, interrupts_triangle_and_erases_its_progress_line) {
  // A mesh is refined, not filled, which takes long enough to be interrupted.
  ASSERT_EQ(pardel({"triangle", "-pq", "square"}).exit_code, 0);
  start_ = files();
  expect_stop_on_terminal({"triangle", "-rqa0.00000005", "square.1"}, "triangles");
}

}  // namespace
}  // namespace pardel::testing
