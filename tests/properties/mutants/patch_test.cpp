#include "../../../properties/mutants/patch.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "../../temporary_folder.hpp"

namespace pardel::mutants {
namespace {
namespace fs = std::filesystem;

/// A project with one folder of sources, and a patched copy of this folder.
class PatchedCopy : public testing::Test {
 public:
  PatchedCopy() {
    fs::create_directories(root() / "properties/mutants/patches");
    source("engine/a.cpp", "first\nsecond\nthird\n");
    source("engine/room/b.hpp", "other\n");
  }

 protected:
  [[nodiscard]] fs::path root() const { return folder_ / "root"; }
  [[nodiscard]] fs::path copied(const std::string& file) const { return folder_ / ("copy/" + file); }
  [[nodiscard]] std::string copy_of(const std::string& file) const { return folder_.read("copy/" + file); }

  void source(const std::string& file, const std::string& text) const { folder_.write("root/" + file, text); }
  void patch(const std::string& name, const std::string& text) const {
    folder_.write("root/properties/mutants/patches/" + name + ".patch", text);
  }
  void registry(const std::vector<std::string>& mutants) const {
    std::string text;
    for (const std::string& mutant : mutants) text += mutant + " | engine/a.cpp | a mistake | program Suite.property\n";
    folder_.write("root/properties/mutants/registry", text);
  }
  /// The line that includes the switches.
  [[nodiscard]] std::string switches() const {
    return "#include \"" + (root() / "properties/mutants/mutated.hpp").string() + "\"\n";
  }
  /// Messages without the folder's name.
  [[nodiscard]] std::vector<std::string> errors() const {
    std::vector<std::string> errors = copy_with_mutants(root(), {"engine"}, folder_ / "copy");
    for (std::string& error : errors)
      for (std::size_t at; (at = error.find(root().string() + "/")) != std::string::npos;)
        error.erase(at, root().string().size() + 1);
    return errors;
  }

 private:
  TemporaryFolder folder_;
};

using Errors = std::vector<std::string>;

TEST_F(PatchedCopy, contains_every_source_as_it_is_where_no_patch_changes_it) {
  registry({});
  EXPECT_EQ(errors(), Errors());
  EXPECT_EQ(copy_of("engine/a.cpp"), "first\nsecond\nthird\n");
  EXPECT_EQ(copy_of("engine/room/b.hpp"), "other\n");
}

TEST_F(PatchedCopy, contains_what_the_patches_add_and_lacks_what_they_remove) {
  registry({"m"});
  patch("m", "engine/a.cpp\n first\n+if (mutated(\"m\"))\n@@\n-third\n+  fourth\n");
  EXPECT_EQ(errors(), Errors());
  EXPECT_EQ(copy_of("engine/a.cpp"), switches() + "first\nif (mutated(\"m\"))\nsecond\n  fourth\n");
}

TEST_F(PatchedCopy, takes_patches_that_share_a_context_line_in_the_order_of_the_registry) {
  registry({"m", "k"});
  patch("m", "engine/a.cpp\n second\n+mutated(\"m\")\n");
  patch("k", "engine/a.cpp\n second\n+mutated(\"k\")\n");
  EXPECT_EQ(errors(), Errors());
  EXPECT_EQ(copy_of("engine/a.cpp"), switches() + "first\nsecond\nmutated(\"k\")\nmutated(\"m\")\nthird\n");
}

TEST_F(PatchedCopy, takes_the_patch_of_a_family_once) {
  registry({"family_of_one", "family_of_two"});
  patch("family_", "engine/a.cpp\n-first\n+mutated(\"family_\", name)\n");
  EXPECT_EQ(errors(), Errors());
  EXPECT_EQ(copy_of("engine/a.cpp"), switches() + "mutated(\"family_\", name)\nsecond\nthird\n");
}

TEST_F(PatchedCopy, is_not_made_where_lines_of_a_patch_do_not_occur) {
  registry({"m"});
  patch("m", "engine/a.cpp\n first\n third\n+mutated(\"m\")\n");
  EXPECT_EQ(errors(), Errors{"mutant m: properties/mutants/patches/m.patch does not apply to engine/a.cpp: these lines "
                             "do not occur: first\\nthird\\n"});
  EXPECT_FALSE(fs::exists(copied("engine")));
}

TEST_F(PatchedCopy, is_not_made_where_lines_of_a_patch_occur_twice) {
  registry({"m"});
  source("engine/a.cpp", "first\nsecond\nfirst\nsecond\n");
  patch("m", "engine/a.cpp\n-second\n+mutated(\"m\")\n");
  EXPECT_EQ(errors(), Errors{"mutant m: properties/mutants/patches/m.patch does not apply to engine/a.cpp: these lines "
                             "occur more than once: second\\n"});
}

TEST_F(PatchedCopy, is_not_made_where_lines_that_overlap_occur_twice) {
  registry({"m"});
  source("engine/a.cpp", "first\nfirst\nfirst\n");
  patch("m", "engine/a.cpp\n first\n first\n+mutated(\"m\")\n");
  EXPECT_EQ(errors().size(), 1U);
}

TEST_F(PatchedCopy, is_not_made_where_the_source_of_a_patch_is_missing) {
  registry({"m"});
  patch("m", "engine/gone.cpp\n first\n+mutated(\"m\")\n");
  EXPECT_EQ(errors(), Errors{"mutant m: properties/mutants/patches/m.patch does not apply to engine/gone.cpp: there is "
                             "no such source file"});
}

TEST_F(PatchedCopy, is_not_made_where_a_patch_lacks_the_switch_of_its_mutant) {
  registry({"m"});
  patch("m", "engine/a.cpp\n first\n+mutated(\"k\")\n");
  EXPECT_EQ(errors(), Errors{"mutant m: properties/mutants/patches/m.patch does not apply to engine/a.cpp: no line of "
                             "it contains mutated(\"m\")"});
}

TEST_F(PatchedCopy, is_not_made_where_a_patch_is_not_well_formed) {
  registry({"looks_for_nothing", "unmarked"});
  patch("looks_for_nothing", "engine/a.cpp\n+mutated(\"looks_for_nothing\")\n");
  patch("unmarked", "engine/a.cpp\nfirst\n+mutated(\"unmarked\")\n");
  EXPECT_EQ(errors().size(), 2U);
}

TEST_F(PatchedCopy, is_not_made_where_a_mutant_has_no_patch_or_a_patch_has_no_mutant) {
  registry({"m"});
  patch("k", "engine/a.cpp\n first\n+mutated(\"k\")\n");
  EXPECT_EQ(errors(), (Errors{"mutant m of properties/mutants/registry has no patch",
                              "properties/mutants/patches/k.patch has no mutant in properties/mutants/registry"}));
}

TEST_F(PatchedCopy, names_every_patch_that_does_not_apply) {
  registry({"m", "k"});
  patch("m", "engine/a.cpp\n none\n+mutated(\"m\")\n");
  patch("k", "engine/a.cpp\n none\n+mutated(\"k\")\n");
  EXPECT_EQ(errors().size(), 2U);
}

TEST_F(PatchedCopy, rewrites_only_files_that_change) {
  registry({});
  ASSERT_EQ(errors(), Errors());
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(copied("engine/a.cpp"), long_ago);
  fs::last_write_time(copied("engine/room/b.hpp"), long_ago);
  source("engine/a.cpp", "changed\n");
  ASSERT_EQ(errors(), Errors());
  EXPECT_EQ(copy_of("engine/a.cpp"), "changed\n");
  EXPECT_GT(fs::last_write_time(copied("engine/a.cpp")), long_ago);
  EXPECT_EQ(fs::last_write_time(copied("engine/room/b.hpp")), long_ago);
}

TEST_F(PatchedCopy, loses_the_files_whose_sources_are_deleted) {
  registry({});
  ASSERT_EQ(errors(), Errors());
  fs::remove(root() / "engine/a.cpp");
  ASSERT_EQ(errors(), Errors());
  EXPECT_FALSE(fs::exists(copied("engine/a.cpp")));
  EXPECT_TRUE(fs::exists(copied("engine/room/b.hpp")));
}

}  // namespace
}  // namespace pardel::mutants
