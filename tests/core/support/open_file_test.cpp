#include "../../../core/support/open_file.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace pardel {
namespace {

TEST(OpenFile, has_the_number_at_the_end_of_its_name) {
  for (const char* folder : {"/dev/fd/", "/proc/self/fd/"}) {
    EXPECT_EQ(descriptor_of(folder + std::string("0")), 0);
    EXPECT_EQ(descriptor_of(folder + std::string("17")), 17);
    EXPECT_EQ(descriptor_of(folder + std::string("17a")), std::nullopt);
    EXPECT_EQ(descriptor_of(folder), std::nullopt);
  }
  EXPECT_EQ(descriptor_of("/dev/./fd//3"), 3);
}

TEST(OpenFile, is_no_file_of_another_folder_whose_name_is_as_long) {
  EXPECT_EQ(descriptor_of("/tmp/fd/3"), std::nullopt);
  EXPECT_EQ(descriptor_of("/proc/next/fd/3"), std::nullopt);
}

TEST(OpenFile, has_names_for_the_standard_streams) {
  EXPECT_EQ(descriptor_of("/dev/stdin"), 0);
  EXPECT_EQ(descriptor_of("-"), 1);
  EXPECT_EQ(descriptor_of("/dev/stdout"), 1);
  EXPECT_EQ(descriptor_of("/dev/stderr"), 2);
  EXPECT_TRUE(is_standard_output("-"));
  EXPECT_TRUE(is_standard_output("/dev/fd/1"));
  EXPECT_FALSE(is_standard_output("/dev/stdin"));
  EXPECT_TRUE(is_standard_input("-"));
  EXPECT_TRUE(is_standard_input("/dev/fd/0"));
  EXPECT_FALSE(is_standard_input("/dev/stdout"));
}

}  // namespace
}  // namespace pardel
