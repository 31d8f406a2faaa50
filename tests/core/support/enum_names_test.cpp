// Tables of names of enumerators.
#include "../../../core/support/enum_names.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace pardel {
namespace {

enum class Colour : std::uint8_t { red, green, blue };

constexpr auto colour_names =
    enum_names<Colour>({{Colour::red, "red"}, {Colour::green, "green"}, {Colour::blue, "sky blue"}});

TEST(EnumNames, give_each_enumerator_its_name) {
  EXPECT_EQ(std::string(colour_names[Colour::red]), "red");
  EXPECT_EQ(std::string(colour_names[Colour::blue]), "sky blue");
}

TEST(EnumNames, call_any_other_value_unknown) { EXPECT_EQ(std::string(colour_names[Colour{7}]), "unknown"); }

TEST(EnumNames, tell_enumerators_from_other_values) {
  EXPECT_TRUE(detail::is_enumerator<Colour::blue>());
  EXPECT_FALSE(detail::is_enumerator<Colour{3}>());
}

}  // namespace
}  // namespace pardel
