#include "../../../core/support/leftover_files.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>

#include "../../../core/support/this_machine.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

/// The number of a process that has ended. It may be used again only much later.
pid_t dead_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

std::string partial_of(const std::string& file, const std::string& space, pid_t process) {
  return file + "." + space + "-" + std::to_string(process) + "-7.partial";
}

TEST(LeftoverFiles, of_a_process_that_has_ended_are_removed) {
  if (space_of_processes().empty()) GTEST_SKIP() << "this system does not tell its processes from others";
  const TemporaryFolder folder;
  folder.write("a.b.txt", "complete");
  folder.write(partial_of("a.b.txt", space_of_processes(), dead_process()), "partial");
  remove_leftovers(std::array{folder / "a.b.txt"});
  EXPECT_EQ(folder.names(), "a.b.txt ");
}

TEST(LeftoverFiles, have_the_names_that_partial_files_have) {
  const fs::path name = partial_name("folder/a.txt", 7);
  EXPECT_EQ(name, "folder/" + partial_of("a.txt", space_of_processes(), getpid()));
}

TEST(LeftoverFiles, stay_unless_it_is_certain_that_nobody_writes_them) {
  const TemporaryFolder folder;
  const std::string here = space_of_processes(), dead = std::to_string(dead_process());
  const std::string from = "a.txt." + here + "-" + dead;
  for (const std::string& name :
       {partial_of("a.txt", here, getpid()), partial_of("a.txt", here, getppid()), partial_of("a.txt", here, 1),
        partial_of("a.txt", "00000000", dead_process()), partial_of("a.txt", "", dead_process()),
        partial_of("b.txt", here, dead_process()), partial_of("a.txt", here, 0), std::string("a.txt.partial"),
        "a.txt." + dead + "-1.partial", from + ".partial", from + "-.partial", from + "-x.partial", from + "-1.part",
        from + "-1", "a.txt." + here + "--1-1.partial", "a.txt" + here + "-" + dead + "-1.partial",
        std::string("--.partial")})
    folder.write(name, "");
  const std::string before = folder.names();
  remove_leftovers(std::array{folder / "a.txt", folder / "missing/c.txt"});
  EXPECT_EQ(folder.names(), before);
}

}  // namespace
}  // namespace pardel
