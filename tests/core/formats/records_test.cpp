#include "../../../core/formats/records.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "../../temporary_folder.hpp"
#include "with_threads.hpp"

namespace pardel::files {
namespace {

TEST(Records, are_the_same_bytes_on_any_number_of_threads) {
  const TemporaryFolder folder;
  const std::size_t n = 100'000;
  std::string expected;
  for (std::size_t i = 0; i < n; ++i) expected += std::to_string(i) + "\n";
  with_threads([&](int threads) {
    OutputFile out(folder / "a");
    write_records(out, n, [](Bytes& to, std::size_t i) { to << i << '\n'; });
    ASSERT_TRUE(out.commit().ok());
    EXPECT_TRUE(folder.read("a") == expected) << threads << " threads";
  });
}

TEST(Values, are_written_as_they_are_in_memory_on_any_number_of_threads) {
  const TemporaryFolder folder;
  for (const std::size_t n : {0, 1, 8192, 200'001}) {
    std::vector<std::array<std::uint32_t, 2>> values;
    for (std::uint32_t i = 0; i < n; ++i) values.push_back({i, ~i});
    const std::string_view expected(reinterpret_cast<const char*>(values.data()), n * sizeof(values[0]));
    with_threads([&](int threads) {
      OutputFile out(folder / "a");
      write_values(out, n, [&](std::size_t i) { return values[i]; });
      ASSERT_TRUE(out.commit().ok());
      EXPECT_TRUE(folder.read("a") == expected) << n << " values, " << threads << " threads";
    });
  }
}

TEST(Blocks, end_before_the_first_one_that_throws) {
  const TemporaryFolder folder;
  with_threads([&](int threads) {
    OutputFile out(folder / "a");
    try {
      write_blocks(out, 50, [](Bytes& to, std::size_t b) {
        if (b >= 20) throw std::runtime_error(std::to_string(b));
        to << b << ' ';
      });
      ADD_FAILURE() << "no exception on " << threads << " threads";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "20");
    }
    ASSERT_TRUE(out.commit().ok());
    EXPECT_EQ(folder.read("a"), "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 ");
  });
}

TEST(Blocks, are_not_made_after_a_failure_to_write) {
  const std::string much(1 << 16, 'x');
  with_threads([&](int threads) {
    OutputFile out("/dev/full");
    std::atomic<int> made = 0;
    write_blocks(out, 100, [&](Bytes& to, std::size_t) {
      ++made;
      to << much;
    });
    EXPECT_LE(made, threads);
    EXPECT_EQ(out.commit().error().message, "/dev/full: cannot be written: No space left on device");
  });
}

TEST(Bytes, have_integers_of_every_size_and_sign) {
  for (const std::int64_t value :
       {std::int64_t{0}, std::int64_t{-1}, std::int64_t{99'999'999}, std::int64_t{100'000'000},
        std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()}) {
    EXPECT_EQ((Bytes() << value).view(), std::to_string(value));
    EXPECT_EQ((Bytes() << static_cast<int>(value)).view(), std::to_string(static_cast<int>(value)));
    EXPECT_EQ((Bytes() << static_cast<std::uint64_t>(value)).view(), std::to_string(static_cast<std::uint64_t>(value)));
  }
}

TEST(Bytes, keep_what_they_have_when_they_grow) {
  Bytes bytes;
  std::string expected;
  for (int i = 0; i < 2000; ++i) {
    bytes << i << ' ' << "text";
    bytes.raw(std::array{'r', 'a', 'w'});
    bytes.add(1)[0] = '\n';
    expected += std::to_string(i) + " textraw\n";
  }
  EXPECT_EQ(bytes.view(), expected);
  bytes.clear();
  EXPECT_EQ(bytes.view(), "");
  EXPECT_EQ((bytes << "" << 'c').view(), "c");
}

}  // namespace
}  // namespace pardel::files
