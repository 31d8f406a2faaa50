// Places with edge lengths, from which lengths grow.
#pragma once

#include <pardel/core/goal.hpp>
#include <pardel/core/size_rules.hpp>
#include <pardel/core/size_source.hpp>
#include <pardel/parallel/validate.hpp>
#include <string>
#include <vector>

namespace pardel::python {

/// Those of a file of the program's option --sources, or of arrays.
struct Places {
  SizeRules rules{};
  std::vector<SizeSource> lines{};
  std::string name{};  ///< of the file, or of the argument, for messages
};

/// Adds the lengths to the goal. Throws a Failure if the domain lacks a marker or an attribute.
void add_places(const Places& places, const ValidPslg& domain, Goal& goal);

}  // namespace pardel::python
