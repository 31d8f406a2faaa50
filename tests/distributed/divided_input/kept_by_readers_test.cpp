#include "../../../distributed/divided_input/kept_by_readers.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "../../../core/support/stop_signal.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../delaunay/part_of_rank.hpp"

namespace pardel::engine {
namespace {

using properties::on_ranks;

/// The attributes of point i are i and -i.
Pslg numbered_points(std::size_t count) {
  Pslg pslg = domains::random_points(count, 3);
  pslg.attributes_per_point = 2;
  for (std::size_t i = 0; i < count; ++i)
    pslg.point_attributes.insert(pslg.point_attributes.end(), {static_cast<double>(i), -static_cast<double>(i)});
  return pslg;
}

KeptByReaders<double> kept_attributes(const Pslg& pslg, Ranks& ranks) {
  PartOfPoints part = part_of(pslg, ranks);
  return {std::move(part.point_attributes), part.attributes_per_point, part.points.size(), ranks};
}

TEST(KeptByReaders, values_are_found_by_the_numbers_of_items_on_every_rank) {
  const Pslg pslg = numbered_points(20);
  for (const int count : {1, 3, 8}) {  // the last of 8 has read no point
    on_ranks(count, [&](Ranks& ranks) {
      const KeptByReaders<double> read = kept_attributes(pslg, ranks);
      EXPECT_EQ(read.per_item(), 2U);
      EXPECT_EQ(read.of({19, 0, 7, 7}, ranks), (std::vector<double>{19, -19, 0, -0.0, 7, -7, 7, -7}));
      EXPECT_EQ(read.of({}, ranks), std::vector<double>{});
      const std::uint64_t own = ranks.rank();
      EXPECT_EQ(read.of({own}, ranks), (std::vector<double>{1.0 * ranks.rank(), -1.0 * ranks.rank()}));
    });
  }
}

TEST(KeptByReaders, values_of_an_item_that_does_not_exist_are_refused) {
  on_ranks(2, [&](Ranks& ranks) {
    const KeptByReaders<double> read = kept_attributes(numbered_points(20), ranks);
    EXPECT_THROW(static_cast<void>(read.of({20}, ranks)), Stopped);
  });
}

}  // namespace
}  // namespace pardel::engine
