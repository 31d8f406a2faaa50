#include "valid_domain.hpp"

#include <utility>

#include "errors.hpp"

namespace pardel::python {

ValidPslg valid_domain(const Pslg& domain, const ValidateOptions& how) {
  Result<ValidPslg, std::vector<Problem>> valid = validate(domain, how);
  if (valid) return std::move(*valid);
  if (valid.error().front().kind == ProblemKind::cancelled)
    throw Failure{{ErrorKind::cancelled, "the caller asked to stop"}};
  throw Failure{{ErrorKind::invalid_input, messages(valid.error())}, valid.error()};
}

}  // namespace pardel::python
