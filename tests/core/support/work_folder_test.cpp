#include "../../../core/support/work_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "../../temporary_folder.hpp"
#include "../../with_variable.hpp"

namespace pardel {
namespace {

class InTemporaryFolder : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
  const WithVariable temporary_{"TMPDIR", folder_.path()};
};

using AWorkFolder = InTemporaryFolder;

TEST_F(AWorkFolder, is_removed_with_its_contents) {
  {
    WorkFolder work;
    ASSERT_TRUE(work.make("work").ok());
    EXPECT_EQ(work.path().parent_path(), folder_.path());
    EXPECT_TRUE(work.path().filename().string().starts_with("work-"));
    std::filesystem::create_directory(work.path() / "inner");
    std::ofstream(work.path() / "inner/file") << "text";
  }
  EXPECT_EQ(folder_.names(), "");
}

TEST_F(AWorkFolder, has_a_name_of_its_own) {
  WorkFolder one, other;
  ASSERT_TRUE(one.make("work").ok());
  ASSERT_TRUE(other.make("work").ok());
  EXPECT_NE(one.path(), other.path());
}

TEST_F(AWorkFolder, that_cannot_be_made_is_an_error) {
  const WithVariable missing("TMPDIR", folder_ / "missing");
  WorkFolder work;
  EXPECT_TRUE(message_of(work.make("work"), folder_).starts_with("no folder for temporary files (TMPDIR): "));
}

}  // namespace
}  // namespace pardel
