#include "../../../core/support/kept_file.hpp"

#include <gtest/gtest.h>

#include "../../../core/support/output_file.hpp"
#include "../../temporary_folder.hpp"

namespace pardel {
namespace {

namespace fs = std::filesystem;

/// Another file gets the name.
void replace(const TemporaryFolder& folder, KeptFile& kept) {
  fs::remove(folder / "a.txt");
  folder.write("a.txt", "new");
  kept.changed();
}

/// The folder has this file alone, with this content.
void expect_only_file(const TemporaryFolder& folder, const char* content) {
  EXPECT_EQ(folder.names(), "a.txt ");
  EXPECT_EQ(folder.read("a.txt"), content);
}

TEST(KeptFile, is_put_back_if_it_was_replaced) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    KeptFile kept(folder / "a.txt");
    replace(folder, kept);
  }
  expect_only_file(folder, "old");
}

TEST(KeptFile, is_put_back_if_it_was_removed) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    KeptFile kept(folder / "a.txt");
    fs::remove(folder / "a.txt");
    kept.changed();
  }
  expect_only_file(folder, "old");
}

TEST(KeptFile, stays_as_it_is_if_nothing_has_changed_it) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  { const KeptFile kept(folder / "a.txt"); }
  expect_only_file(folder, "old");
}

TEST(KeptFile, that_is_not_needed_any_more_leaves_only_the_new_one) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    KeptFile kept(folder / "a.txt");
    replace(folder, kept);
    kept.forget();
  }
  expect_only_file(folder, "new");
}

TEST(KeptFile, that_did_not_exist_is_missing_again) {
  const TemporaryFolder folder;
  {
    KeptFile kept(folder / "a.txt");
    folder.write("a.txt", "new");
    kept.changed();
  }
  EXPECT_EQ(folder.names(), "");
}

TEST(KeptFile, that_cannot_be_put_back_stays_under_its_other_name) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  {
    KeptFile kept(folder / "a.txt");
    fs::remove(folder / "a.txt");
    folder.write("a.txt/b.txt", "a folder has the name now");
    kept.changed();
  }
  { const auto lock = remove_partial_files(); }
  fs::remove_all(folder / "a.txt");
  const std::string name = folder.names();
  EXPECT_TRUE(name.starts_with("a.txt.") && name.ends_with(".partial ")) << name;
  EXPECT_EQ(folder.read(std::string_view(name).substr(0, name.size() - 1)), "old");
}

/// Then the process ends, and the new files have their names.
TEST(KeptFile, has_no_other_name_after_the_partial_files_were_removed) {
  const TemporaryFolder folder;
  folder.write("a.txt", "old");
  const KeptFile kept(folder / "a.txt");
  EXPECT_NE(folder.names(), "a.txt ");
  { const auto lock = remove_partial_files(); }
  EXPECT_EQ(folder.names(), "a.txt ");
}

}  // namespace
}  // namespace pardel
