// An announcement of another step, or a damaged one, is noticed; so is each changed byte of a message.
#include "../../../core/support/announcement.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace pardel {
namespace {

Announcement announced(std::uint64_t number, RankStep step) {
  return Announcement{.number = number, .step = step, .bytes = 24, .checksum = 5}.sealed();
}

TEST(Announcement, of_the_same_step_matches) {
  EXPECT_EQ(mismatch(announced(3, RankStep::exchange), 3, RankStep::exchange), "");
  EXPECT_EQ(mismatch(announced(7, RankStep::sum), 7, RankStep::sum), "");
}

TEST(Announcement, of_another_step_does_not_match) {
  EXPECT_EQ(mismatch(announced(4, RankStep::exchange), 3, RankStep::exchange),
            "belongs to exchange 4, not to exchange 3");
  EXPECT_EQ(mismatch(announced(3, RankStep::sum), 3, RankStep::exchange), "belongs to sum 3, not to exchange 3");
}

TEST(Announcement, that_is_damaged_does_not_match) {
  const Announcement right = announced(3, RankStep::exchange);
  for (std::uint64_t Announcement::*number :
       {&Announcement::number, &Announcement::bytes, &Announcement::checksum, &Announcement::seal})
    for (unsigned bit = 0; bit < 64; ++bit) {
      Announcement damaged = right;
      damaged.*number ^= std::uint64_t{1} << bit;
      EXPECT_EQ(mismatch(damaged, 3, RankStep::exchange), "is announced by damaged numbers");
    }
  EXPECT_EQ(mismatch(Announcement{}, 0, RankStep::exchange), "is announced by damaged numbers");
}

TEST(Checksum, changes_with_each_byte) {
  for (const std::size_t size : {1U, 7U, 8U, 9U, 31U}) {
    std::vector<std::byte> bytes(size, std::byte{3});
    const std::uint64_t before = checksum(bytes);
    for (std::byte& changed : bytes) {
      changed ^= std::byte{16};
      EXPECT_NE(checksum(bytes), before) << size;
      changed ^= std::byte{16};
    }
    EXPECT_EQ(checksum(bytes), before);
  }
}

TEST(Checksum, tells_lengths_apart) {
  std::set<std::uint64_t> sums;
  for (std::size_t size = 0; size < 100; ++size) sums.insert(checksum(std::vector<std::byte>(size)));
  EXPECT_EQ(sums.size(), 100U);
}

}  // namespace
}  // namespace pardel
