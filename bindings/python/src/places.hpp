// Places with edge lengths, from which lengths grow.
#pragma once

#include <pardel/core/goal.hpp>
#include <pardel/core/size_rules.hpp>
#include <pardel/parallel/validate.hpp>
#include <string>
#include <vector>

#include "../../../cli/lengths_of_drawing.hpp"

namespace pardel::python {

/// Those of a file of the program's option --sources, of arrays, or of shapes.
struct Places {
  SizeRules rules{};
  cli::DrawnLengths drawn{};
  std::vector<cli::DrawnPolygon> polygons{};  ///< those with a length, of which `drawn` has the size inside
  std::string name{};                         ///< of the file, or of the argument, for messages
};

/// The places with a length in a drawing. Sides that cross are repaired. Throws a Failure.
[[nodiscard]] Places places_of(cli::DrawnDomain drawing, std::string name);

/// The same places again: of these polygons, which have lengths, and these sources.
[[nodiscard]] Places places_of(std::vector<cli::DrawnPolygon> polygons, std::vector<SizeSource> sources,
                               std::string name);

/// Adds the lengths to the goal. Throws a Failure if the domain lacks a marker or an attribute.
void add_places(const Places& places, const ValidPslg& domain, Goal& goal);

}  // namespace pardel::python
