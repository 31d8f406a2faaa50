// The beginning and the end of a certificate.
#pragma once

#include "../certificate.hpp"
#include "findings.hpp"

namespace pardel::checker {

/// A certificate with the goal, and nothing measured.
[[nodiscard]] Certificate empty_certificate(const Pslg& pslg, const Goal& goal);

/// Sets the violations, and the verdict that follows from them.
void set_verdict(Certificate& certificate, Findings found);

}  // namespace pardel::checker
