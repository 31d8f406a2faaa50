// Names identify vertices and slots on all ranks. An index without a name of its own is named after its rank.
#include "../../../distributed/subdomain/names.hpp"

#include <gtest/gtest.h>

namespace pardel::engine {
namespace {

constexpr std::uint32_t self = Name::rank(2), other = Name::rank(0);

TEST(Names, of_common_indices_are_those_of_everyone) {
  const Names names(self, 10);
  EXPECT_EQ(names.of(9), (Name{Name::everyone, 9}));
  EXPECT_EQ(names.of(10), (Name{self, 10}));
  EXPECT_EQ(names.index_of({Name::everyone, 9}), 9U);
  EXPECT_EQ(names.index_of({self, 10}), 10U);
}

TEST(Names, that_are_unknown_have_no_index) {
  const Names names(self, 10);
  EXPECT_EQ(names.index_of({other, 3}), no_index);
  EXPECT_EQ(names.index_of({Name::everyone, 10}), no_index);
}

TEST(Names, of_other_ranks_are_bound_to_an_index) {
  Names names(self, 10);
  names.bind({other, 5000}, 12);
  EXPECT_EQ(names.of(12), (Name{other, 5000}));
  EXPECT_EQ(names.index_of({other, 5000}), 12U);
  EXPECT_EQ(names.index_of({self, 12}), no_index);
}

TEST(Names, that_are_released_have_no_index_until_they_are_bound_again) {
  Names names(self, 10);
  names.bind({other, 7}, 12);
  names.release(12);
  EXPECT_EQ(names.index_of({other, 7}), no_index);
  names.release(4);
  EXPECT_EQ(names.index_of({Name::everyone, 4}), no_index);
  names.bind({other, 7}, 4);
  EXPECT_EQ(names.index_of({other, 7}), 4U);
  names.bind({Name::everyone, 4}, 12);
  EXPECT_EQ(names.index_of({Name::everyone, 4}), 12U);
  EXPECT_EQ(names.of(4), (Name{other, 7}));
}

TEST(Names, can_return_to_their_own_index) {
  Names names(self, 10);
  names.release(4);
  names.bind({Name::everyone, 4}, 4);
  EXPECT_EQ(names.of(4), (Name{Name::everyone, 4}));
  EXPECT_EQ(names.index_of({Name::everyone, 4}), 4U);
}

}  // namespace
}  // namespace pardel::engine
