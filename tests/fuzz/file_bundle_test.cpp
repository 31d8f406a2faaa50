// Several files in one sequence of bytes.
#include "../../fuzz/file_bundle.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace pardel::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<NamedText> files(std::string_view text) {
  return files_of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, "main.poly");
}

TEST(FileBundle, bytes_without_a_mark_are_the_main_file) {
  const auto found = files("3 2 0 0\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "main.poly");
  EXPECT_EQ(found[0].text, "3 2 0 0\n");
}

TEST(FileBundle, a_mark_begins_a_file_and_the_line_feed_before_it_is_not_part_of_the_file_in_front) {
  const auto found = files("== a.node\none\n\n== a.ele\ntwo");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].name, "a.node");
  EXPECT_EQ(found[0].text, "one\n");
  EXPECT_EQ(found[1].name, "a.ele");
  EXPECT_EQ(found[1].text, "two");
}

TEST(FileBundle, a_name_that_leaves_the_folder_is_replaced) {
  for (const char* text : {"== ../../etc/x\nbad", "== .hidden\nbad", "== \nbad"}) {
    const auto found = files(text);
    ASSERT_EQ(found.size(), 1U) << text;
    EXPECT_EQ(found[0].name, "main.poly") << text;
  }
}

TEST(FileBundle, a_mark_at_the_end_is_an_empty_file) {
  const auto found = files("== a.node");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].text, "");
}

TEST(FileBundle, a_name_has_no_hyphen_so_that_targets_have_names_of_their_own) {
  EXPECT_EQ(files("== in-pieces\nbad").at(0).name, "main.poly");
}

TEST(Scratch, removes_its_files) {
  fs::path folder;
  {
    const Scratch scratch;
    folder = (scratch / "").parent_path();
    scratch.write({"a.poly", "text"});
    EXPECT_TRUE(fs::exists(scratch / "a.poly"));
  }
  EXPECT_FALSE(fs::exists(folder));
}

TEST(Scratch, removes_the_files_of_processes_that_do_not_exist_any_more) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  const fs::path place = fs::temp_directory_path() / ("leftovers-" + std::to_string(getpid()));
  const fs::path left = place / ("pardel-fuzz-" + std::to_string(child));
  const fs::path used = place / ("pardel-fuzz-" + std::to_string(getppid())), other = place / "pardel-fuzz-notes";
  for (const fs::path& folder : {left, used, other}) fs::create_directories(folder);
  Scratch::remove_leftovers(place);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(used));
  EXPECT_TRUE(fs::exists(other));
  fs::remove_all(place);
}

}  // namespace
}  // namespace pardel::fuzz
