// The domains and goals on which the schemes are compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/result.hpp"

namespace pardel::bench {

struct SchemeInput {
  Pslg pslg;
  Goal goal;
};

/// "square", "pipe" (bounds on areas), "key" (lengths that grow from the tip of the key, by a factor of about 100),
/// "random" and "clustered" (points, with the bound on angles only).
[[nodiscard]] std::vector<std::string> scheme_inputs();

/// The input whose mesh has about this many triangles, with angles of at least 20.7 degrees: within a third from 10^4
/// on, of clustered points from 10^5 on (few points leave wide gaps between clusters). `refines` false: the points are
/// only triangulated, so they are more; areas and lengths do not count. Errors: of kind `usage`, for a name that is not
/// in the list.
[[nodiscard]] Result<SchemeInput> scheme_input(std::string_view name, double triangles, bool refines);

}  // namespace pardel::bench
