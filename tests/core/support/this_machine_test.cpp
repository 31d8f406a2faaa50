#include "../../../core/support/this_machine.hpp"

#include <gtest/gtest.h>

#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

TEST(ThisMachine, names_the_same_file_by_the_same_text) {
  if (running_system().empty()) GTEST_SKIP() << "this system does not tell itself from others";
  const TemporaryFolder folder;
  folder.write("a", "");
  folder.write("b", "");
  fs::create_symlink("a", folder / "link");
  EXPECT_EQ(identity_of(folder / "a"), identity_of(folder / "link"));
  EXPECT_NE(identity_of(folder / "a"), identity_of(folder / "b"));
  EXPECT_TRUE(identity_of(folder.path()).starts_with(running_system()));
}

TEST(ThisMachine, has_no_text_for_a_missing_file) { EXPECT_EQ(identity_of("/nowhere/a"), ""); }

TEST(ThisMachine, has_eight_digits_for_its_processes) {
  const std::string space = space_of_processes();
  if (space.empty()) GTEST_SKIP() << "this system does not tell its processes from others";
  EXPECT_EQ(space.size(), 8U);
  EXPECT_EQ(space.find_first_not_of("0123456789abcdef"), std::string::npos) << space;
  EXPECT_EQ(space, space_of_processes());
}

}  // namespace
}  // namespace pardel
