// AttributeRanges: between which values the attributes of inserted vertices have to lie.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "../../../core/mesh.hpp"
#include "../../../core/pslg.hpp"

namespace pardel::checker {

/// From `least` to `greatest`, with attribute_tolerance on both sides.
struct AttributeRange {
  double least, greatest;
  [[nodiscard]] bool contains(double value) const;
};

/// An attribute that leaves its range.
struct AttributeOutside {
  std::size_t attribute;
  AttributeRange range;
};

/// Every mesher interpolates an attribute between values of the input, so none may leave the range of the input. An
/// attribute that is not finite at some input point has no range: what is interpolated there may be no number.
class AttributeRanges {
 public:
  /// Linear time. The Pslg has to outlive the object.
  explicit AttributeRanges(const Pslg& pslg);

  /// The first attribute of vertex v that leaves the range of the input or, if a segment is given, that between the
  /// ends of this segment. Nothing if there is none, and if the mesh has another number of attributes than the input,
  /// or an array of another length.
  [[nodiscard]] std::optional<AttributeOutside> first_outside(const Mesh& mesh, Index v,
                                                              const Segment* on = nullptr) const;

 private:
  [[nodiscard]] AttributeRange between(std::size_t attribute, const Segment& segment) const;

  const Pslg* pslg_;
  std::vector<AttributeRange> ranges_;  ///< per attribute
};

}  // namespace pardel::checker
