// The list of schemes: under each name is the scheme of this name.
#include "../../../ref/schemes/all_schemes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "../../../ref/schemes/independent_cavities.hpp"
#include "../../../ref/schemes/lattice.hpp"
#include "../../../ref/schemes/rounds.hpp"
#include "../../../ref/schemes/sinks.hpp"
#include "../../domains/domains.hpp"

namespace pardel::properties {
namespace {

using schemes::Account;
using schemes::Problem;

Goal small_areas() {
  Goal goal;
  goal.max_area = 2e-3;
  return goal;
}

TEST(AllSchemes, have_the_accounts_of_their_names) {
  const Pslg square = domains::square();
  const Goal goal = small_areas();
  using schemes::Independence;
  using Alone = Result<schemes::Outcome> (*)(const Problem&);
  const std::map<std::string, Alone> runs = {
      {"closures", [](const Problem& p) { return schemes::independent_cavities(p, Independence::closures); }},
      {"exact", [](const Problem& p) { return schemes::independent_cavities(p, Independence::exact); }},
      {"sinks", [](const Problem& p) { return schemes::sinks(p, Independence::closures); }},
      {"rounds", [](const Problem& p) { return schemes::rounds(p); }},
      {"rounds-by-class",
       [](const Problem& p) { return schemes::rounds(p, {.batch = schemes::Batch::largest_class}); }},
      {"lattice", [](const Problem& p) { return schemes::lattice(p); }},
      {"lattice-2r", [](const Problem& p) { return schemes::lattice(p, {.side = schemes::CellSide::two_radii}); }}};
  std::vector<Account> seen;
  for (const auto& [name, run] : runs) {
    const auto scheme = std::ranges::find(schemes::all_schemes(), name, &schemes::Scheme::name);
    ASSERT_NE(scheme, schemes::all_schemes().end()) << name;
    const auto outcomes = scheme->run({square, goal}, {9, 2});
    ASSERT_TRUE(outcomes && outcomes->size() == 2) << name;
    EXPECT_EQ(outcomes->at(0).account, run({square, goal, 9})->account) << name;
    EXPECT_EQ(outcomes->at(1).account, run({square, goal, 2})->account) << name;
    EXPECT_EQ(std::ranges::count(seen, outcomes->at(0).account), 0) << name << " is like another scheme";
    seen.push_back(outcomes->at(0).account);
  }
}

// Where a mesh depends on the number of workers, the scheme runs once for each of them.
TEST(AllSchemes, run_with_each_number_of_workers) {
  const Pslg square = domains::square();
  const Goal goal = small_areas();
  for (const schemes::Scheme& scheme : schemes::all_schemes()) {
    if (!scheme.refines) continue;
    const auto both = scheme.run({square, goal}, {7, 1}), few = scheme.run({square, goal}, {7}),
               one = scheme.run({square, goal}, {1});
    ASSERT_TRUE(both && few && one) << scheme.name;
    EXPECT_EQ(both->at(0).account, few->at(0).account) << scheme.name;
    EXPECT_EQ(both->at(1).account, one->at(0).account) << scheme.name;
    EXPECT_EQ(one->at(0).account.messages, 0U) << scheme.name;
  }
}

}  // namespace
}  // namespace pardel::properties
