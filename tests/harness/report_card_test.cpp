#include "../../cli/harness/report_card.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace pardel::harness {
namespace {

ReportCard sample() {
  ReportCard card;
  card.mesher = "mesher {poly} {out}";
  card.replay = "pardel-harness --mesher m";
  card.cases = {{1, Family::cracks, 0}, {1, Family::far_offset, 0}, {1, Family::cracks, 1}, {1, Family::far_offset, 1}};
  card.outcomes = {{},
                   {Verdict::wrong, {{"overlap", "a|b"}}, {}, {}},
                   {Verdict::crashed, {{"SIGSEGV", "\xff"}}, {}, {}},
                   {Verdict::wrong, {{"area_mismatch", ""}, {"overlap", ""}}, {}, {}}};
  count(card);
  return card;
}

TEST(ReportCard, counts_cases_by_verdict_family_and_kind) {
  const ReportCard card = sample();
  EXPECT_EQ(card.counts, (Counts{1, 0, 2, 1, 0, 0}));
  ASSERT_EQ(card.families.size(), 2);
  EXPECT_EQ(card.families[0].counts, (Counts{1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(card.families[1].counts, (Counts{0, 0, 2, 0, 0, 0}));
  ASSERT_EQ(card.kinds.size(), 3);
  EXPECT_EQ(card.kinds[0].kind, "overlap");
  EXPECT_EQ(card.kinds[0].cases, 2);
  EXPECT_EQ(card.kinds[0].first, 1);
  EXPECT_EQ(card.kinds[1].kind, "area_mismatch");
  EXPECT_EQ(card.kinds[2].kind, "SIGSEGV");
  EXPECT_FALSE(all_valid(card));
}

TEST(ReportCard, as_markdown_has_a_table_of_families_and_one_of_kinds) {
  const std::string text = to_markdown(sample());
  for (const char* part :
       {"# 1 of 4 valid", "| cracks | 2 | 1 | 0 | 0 | 1 | 0 | 0 |", "| **all** | 4 | 1 | 0 | 2 | 1 | 0 | 0 |",
        "| wrong | overlap | 2 | 1:far_offset:0 | a\\|b |"})
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

TEST(ReportCard, as_json_has_counts_and_every_failing_case) {
  const auto json = nlohmann::json::parse(to_json(sample()));
  EXPECT_EQ(json["schema"], "pardel.harness/1");
  EXPECT_EQ(json["counts"]["wrong"], 2);
  EXPECT_EQ(json["families"]["cracks"]["crashed"], 1);
  ASSERT_EQ(json["failures"].size(), 3);
  EXPECT_EQ(json["failures"][0]["replay"], "pardel-harness --mesher m --replay 1:far_offset:0");
}

}  // namespace
}  // namespace pardel::harness
