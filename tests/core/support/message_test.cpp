// Messages contain the lists that were written, in their order. A message that does not fit is an error.
#include "../../../core/support/message.hpp"

#include <gtest/gtest.h>

namespace pardel {
namespace {

TEST(Message, has_the_lists_that_were_written) {
  Writer writer;
  EXPECT_TRUE(writer.empty());
  writer.list(std::vector<int>{1, -2, 3});
  writer.list(std::vector<double>{});
  writer.list(std::vector<double>{0.5});
  const Ranks::Bytes bytes = writer.take();
  Reader reader(bytes);
  EXPECT_EQ(reader.list<int>(), (std::vector<int>{1, -2, 3}));
  EXPECT_TRUE(reader.list<double>().empty());
  EXPECT_EQ(reader.list<double>(), std::vector<double>{0.5});
  EXPECT_TRUE(reader.empty());
}

TEST(Message, can_be_written_and_read_value_by_value) {
  Writer writer;
  writer.list(std::vector<char>{1, 2, 3});  // what follows is not aligned
  writer.list_of<double>(3, [](std::size_t i) { return 0.5 * static_cast<double>(i); });
  writer.list(std::vector<int>{7});
  const Ranks::Bytes bytes = writer.take();
  Reader reader(bytes);
  EXPECT_EQ(reader.packed_list<char>().size(), 3U);
  const PackedList<double> halves = reader.packed_list<double>();
  ASSERT_EQ(halves.size(), 3U);
  EXPECT_EQ(halves[2], 1.0);
  EXPECT_EQ(reader.list<int>(), std::vector<int>{7});
  EXPECT_TRUE(reader.empty());
}

TEST(Message, that_is_cut_off_anywhere_is_an_error) {
  Writer writer;
  writer.list(std::vector<int>{1, 2, 3});
  const Ranks::Bytes bytes = writer.take();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::span<const std::byte> all(bytes);
    Reader reader(all.first(size));
    EXPECT_THROW((void)reader.list<int>(), Stopped) << size << " bytes";
  }
}

TEST(Message, with_an_impossible_length_is_an_error) {
  Writer writer;
  writer.list(std::vector<int>{1});
  Ranks::Bytes bytes = writer.take();
  bytes[7] = std::byte{0xff};
  Reader reader(bytes);
  EXPECT_THROW((void)reader.list<int>(), Stopped);
}

}  // namespace
}  // namespace pardel
