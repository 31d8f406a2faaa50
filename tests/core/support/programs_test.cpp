#include "../../../core/support/programs.hpp"

#include <gtest/gtest.h>

#include "../../temporary_folder.hpp"
#include "../../with_variable.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

class Programs : public ::testing::Test {
 protected:
  Programs() {
    folder_.write("bin/mesher", "");
    fs::permissions(folder_ / "bin/mesher", fs::perms::owner_all);
    folder_.write("bin/text", "");
  }
  const TemporaryFolder folder_;
  const WithVariable path_{"PATH", "/no-such-folder:" + (folder_ / "bin").string()};
};

TEST_F(Programs, are_files_that_may_be_executed) {
  EXPECT_TRUE(is_program(folder_ / "bin/mesher"));
  EXPECT_FALSE(is_program(folder_ / "bin/text"));
  EXPECT_FALSE(is_program(folder_ / "bin"));
}

TEST_F(Programs, are_found_on_the_path) {
  EXPECT_EQ(on_path("mesher"), folder_ / "bin/mesher");
  EXPECT_EQ(on_path("text"), "");
}

TEST_F(Programs, are_found_by_a_name_or_a_path) {
  EXPECT_EQ(*find_program("mesher"), folder_ / "bin/mesher");
  EXPECT_EQ(*find_program((folder_ / "bin/mesher").string()), folder_ / "bin/mesher");
  EXPECT_EQ(message_of(find_program("text"), folder_), "there is no program 'text' on the PATH");
  EXPECT_EQ(message_of(find_program((folder_ / "bin/text").string()), folder_), "bin/text is no program");
}

TEST_F(Programs, of_this_project_lie_beside_the_running_one) {
  EXPECT_EQ(beside_this_program("core_test").filename(), "core_test");
  EXPECT_EQ(beside_this_program("no-such-program"), "");
}

}  // namespace
}  // namespace pardel
