// Names of physical groups: those that stand for a marker or for an attribute of a region, and all others.
#pragma once

#include <string_view>

#include "../field.hpp"

namespace pardel::files {

/// What a physical group is. A number that is not a number (NaN) means no region.
struct GroupValue {
  double value = 0;    ///< the marker of the edges, or the attribute of the region
  bool named = false;  ///< the name says the value: `region 2.5`, `marker 3` or `domain`
};
/// The meaning of the group with this name and tag.
[[nodiscard]] GroupValue value_of_group(GroupName::Of of, std::string_view name, double tag);

/// True if the text can be the name of a group: one that says no value, is not empty, and has no control characters.
[[nodiscard]] bool is_group_name(GroupName::Of of, std::string_view name);

}  // namespace pardel::files
