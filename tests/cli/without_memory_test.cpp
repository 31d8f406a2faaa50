// The threads that watch the process work when there is no memory left to allocate.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "../../cli/end_process.hpp"
#include "../../cli/memory.hpp"
#include "full_memory.hpp"

namespace pardel::cli {
namespace {

TEST(WithoutMemory, the_memory_in_use_is_known) {
  std::uint64_t used = 0;
  {
    const testing::FullMemory full;
    used = used_memory();
  }
  EXPECT_GT(used, 0U);
}

TEST(WithoutMemory, the_process_ends_with_its_message) {
  const std::string message = "a message that is too long for the storage within a string object";
  const auto end = [&] {
    const testing::FullMemory full;
    end_process(ErrorKind::resources, message);
  };
  EXPECT_EXIT(end(), ::testing::ExitedWithCode(5), message);
}

}  // namespace
}  // namespace pardel::cli
