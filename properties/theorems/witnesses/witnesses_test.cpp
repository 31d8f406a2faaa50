// Tests that every stored witness satisfies its claim.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "../../../core/formats.hpp"
#include "witness.hpp"

namespace pardel::properties {
namespace {
namespace fs = std::filesystem;

const fs::path folder = PARDEL_WITNESSES;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

class StoredWitness : public testing::TestWithParam<Witness> {};

TEST_P(StoredWitness, is_what_its_name_claims) {
  const auto pslg = read_pslg(folder / (GetParam().name + ".poly"));
  ASSERT_TRUE(pslg) << pslg.error().message;
  EXPECT_TRUE(GetParam().holds(to_scene(*pslg))) << GetParam().claim;
}

TEST_P(StoredWitness, is_what_its_search_finds) {
  if (GetParam().make == nullptr) return;
  const auto pslg = read_pslg(folder / (GetParam().name + ".poly"));
  ASSERT_TRUE(pslg) << pslg.error().message;
  EXPECT_EQ(to_scene(*pslg), GetParam().make());
}

TEST_P(StoredWitness, has_its_picture) {
  const auto pslg = read_pslg(folder / (GetParam().name + ".poly"));
  ASSERT_TRUE(pslg) << pslg.error().message;
  const fs::path drawn = fs::path(testing::TempDir()) / (GetParam().name + ".svg");
  ASSERT_TRUE(draw(to_scene(*pslg), drawn));
  EXPECT_EQ(text_of(folder / (GetParam().name + ".svg")), text_of(drawn)) << "Run pardel_witnesses.";
}

std::string name_of(const testing::TestParamInfo<Witness>& row) { return row.param.name; }

INSTANTIATE_TEST_SUITE_P(, StoredWitness, testing::ValuesIn(all_witnesses()), name_of);

TEST(StoredWitnesses, have_no_file_without_a_claim) {
  std::set<std::string> known;
  for (const Witness& witness : all_witnesses()) known.insert({witness.name + ".poly", witness.name + ".svg"});
  for (const auto& file : fs::directory_iterator(folder))
    EXPECT_TRUE(known.contains(file.path().filename().string())) << file.path();
}

}  // namespace
}  // namespace pardel::properties
