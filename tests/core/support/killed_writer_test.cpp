// A process that is killed (SIGKILL) at any moment leaves old files or complete new ones, and no partial file that the
// next process does not remove.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "../../../core/support/output_file.hpp"
#include "../../../core/support/this_machine.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

using Aside = OutputFile::Aside;

const std::string old_text(1000, 'o'), new_text(1000, 'n');

/// Runs the work in another process again and again, and kills the process some microseconds after `begin`.
void kill_during(
    const std::function<void()>& work, unsigned microseconds, const std::function<void()>& begin = [] {}) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    begin();
    if (write(ends[1], "x", 1) != 1) _exit(1);
    for (;;) work();
  }
  char begun = 0;
  ASSERT_EQ(read(ends[0], &begun, 1), 1);
  usleep(microseconds);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the process has ended by itself";
  for (const int end : ends) close(end);
}

class KilledWriter : public ::testing::TestWithParam<Aside> {
 protected:
  void SetUp() override {
    if (space_of_processes().empty()) GTEST_SKIP() << "this system does not tell its processes from others";
  }
  /// All files are opened, then written, then get their names.
  static Status write_all(const TemporaryFolder& folder, const std::string& text) {
    std::deque<OutputFile> files;
    for (const char* name : {"a.txt", "b.txt", "c.txt"}) files.emplace_back(folder / name, GetParam());
    for (OutputFile& file : files) file.write(text);
    return commit_all(files);
  }
};

TEST_P(KilledWriter, leaves_the_old_file_or_the_new_one_and_the_next_writer_removes_the_rest) {
  const TemporaryFolder folder;
  generators::Random random(1);
  for (int i = 0; i < 100; ++i) {
    folder.write("a.txt", old_text);
    const auto write_one = [&](const std::string& text) {
      OutputFile out(folder / "a.txt", GetParam());
      out.write(text);
      return out.commit();
    };
    kill_during([&] { EXPECT_TRUE(write_one(new_text).ok()); }, static_cast<unsigned>(random.below(2000)));
    const std::string left = folder.read("a.txt");
    EXPECT_TRUE(left == old_text || left == new_text);
    ASSERT_TRUE(write_one(old_text).ok());
    ASSERT_EQ(folder.names(), "a.txt ");
  }
}

TEST_P(KilledWriter, of_several_files_leaves_nothing_that_the_next_writer_does_not_remove) {
  const TemporaryFolder folder;
  generators::Random random(2);
  for (int i = 0; i < 100; ++i) {
    kill_during([&] { EXPECT_TRUE(write_all(folder, new_text).ok()); }, static_cast<unsigned>(random.below(4000)));
    ASSERT_TRUE(write_all(folder, old_text).ok());
    ASSERT_EQ(folder.names(), "a.txt b.txt c.txt ");
  }
}

/// The process never comes to commit(), so it is killed while the file is partial.
TEST_P(KilledWriter, leaves_a_partial_file_only_where_it_has_a_name) {
  const TemporaryFolder folder;
  const bool is_unnamed = OutputFile(folder / "a.txt", GetParam()).is_unnamed();
  if (GetParam() == Aside::unnamed && !is_unnamed) GTEST_SKIP() << "this file system has no files without names";
  std::optional<OutputFile> out;
  kill_during([&] { out->write(new_text); }, 10'000, [&] { out.emplace(folder / "a.txt", GetParam()); });
  EXPECT_EQ(folder.names().empty(), is_unnamed) << folder.names();
  OutputFile next(folder / "a.txt", GetParam());
  ASSERT_TRUE(next.commit().ok());
  EXPECT_EQ(folder.names(), "a.txt ");
}

INSTANTIATE_TEST_SUITE_P(Of, KilledWriter, ::testing::Values(Aside::unnamed, Aside::named), [](const auto& parameter) {
  return std::string(parameter.param == Aside::unnamed ? "a_file_without_a_name" : "a_file_with_a_partial_name");
});

}  // namespace
}  // namespace pardel
