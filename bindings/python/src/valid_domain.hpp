// A domain of the caller that can be meshed.
#pragma once

#include <pardel/parallel/validate.hpp>

namespace pardel::python {

/// Throws a Failure with the problems if the domain has any, or if `how.go_on` has ended the search.
[[nodiscard]] ValidPslg valid_domain(const Pslg& domain, const ValidateOptions& how);

}  // namespace pardel::python
