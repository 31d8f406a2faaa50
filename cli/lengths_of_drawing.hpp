// The edge lengths that a drawing asks for, with the property `length` of its shapes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/result.hpp"
#include "../core/size_source.hpp"
#include "../parallel/validate.hpp"
#include "drawn_domain.hpp"

namespace pardel::cli {

struct DrawnLengths {
  std::vector<SizeSource> sources;      ///< for Goal::sources: points, lines and the borders of polygons
  std::function<double(Point)> size{};  ///< for Goal::size: the least length of the polygons around a point; infinity:
                                        ///< none. Empty if there are no such polygons.
};

/// The sides of the polygons that have a length, and a frame around them. The domain is their convex hull.
struct FramedSides {
  Pslg pslg;
  NumbersInFile points{};  ///< the numbers of the points in the drawing; those of the frame follow
};
/// Validates or repairs the sides, as a convex hull.
using MakeValid = std::function<Result<ValidPslg>(FramedSides)>;

/// The function of the result owns its data, and several threads may call it. A call takes O(log n) on typical input.
/// `name`: of the drawing, for messages. Errors: `invalid_input` if no shape has a length; those of make_valid().
[[nodiscard]] Result<DrawnLengths> lengths_of(DrawnDomain drawing, const std::string& name,
                                              const MakeValid& make_valid);

}  // namespace pardel::cli
