#include "../../cli/harness/case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace pardel::harness {
namespace {

TEST(Case, is_printed_as_it_is_parsed) {
  for (const Family family : generators::all_families()) {
    const Result<CaseId> id = parse_case("18446744073709551615:" + std::string(name(family)) + ":17");
    ASSERT_TRUE(id.ok());
    EXPECT_EQ(to_string(*id), "18446744073709551615:" + std::string(name(family)) + ":17");
  }
}

TEST(Case, that_is_not_seed_family_index_is_an_error) {
  for (const char* text : {"", "1", "1:cracks", "1:cracks:", ":cracks:1", "1:crack:1", "-1:cracks:1", "1:cracks:1x",
                           "1:cracks:1:2", "99999999999999999999:cracks:1"}) {
    EXPECT_FALSE(parse_case(text).ok()) << text;
  }
}

TEST(Case, depends_on_its_seed_family_and_index_only) {
  const CaseId id{7, Family::cracks, 12};
  EXPECT_EQ(make_case(id), make_case(id));
  EXPECT_NE(make_case(id), make_case({8, Family::cracks, 12}));
  EXPECT_NE(make_case(id), make_case({7, Family::cracks, 13}));
  EXPECT_NE(make_case(id).points, make_case({7, Family::isolated_points, 12}).points);
}

TEST(Case, has_the_trait_of_its_family) {
  for (const CaseId& id : cases_in_turn(3, generators::all_families(), 110)) {
    const LatticeDomain domain = make_case(id);
    EXPECT_TRUE(is_valid(domain)) << to_string(id);
    EXPECT_TRUE(has_trait(id.family, domain)) << to_string(id);
  }
}

TEST(Cases, are_drawn_from_the_families_in_turn) {
  const auto& families = generators::all_families();
  const std::vector<CaseId> cases = cases_in_turn(1, families, 10 * families.size());
  for (const Family family : families)
    EXPECT_EQ(std::count_if(cases.begin(), cases.end(), [&](const CaseId& id) { return id.family == family; }), 10);
}

}  // namespace
}  // namespace pardel::harness
