// Assertions about certificates.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "../../../properties/checker/check.hpp"

namespace pardel::testing {

inline std::uint64_t count(const Certificate& certificate, ViolationKind kind) {
  return certificate.violation_counts.at(static_cast<std::size_t>(kind));
}

inline ::testing::AssertionResult is_valid(const Certificate& certificate) {
  if (certificate.valid) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << to_text(certificate);
}

/// True if the certificate counts this kind and lists a violation of this kind with a witness.
inline ::testing::AssertionResult reports(const Certificate& certificate, ViolationKind kind) {
  const auto of_kind = [&](const Violation& v) { return v.kind == kind && !v.witness.empty(); };
  if (!certificate.valid && count(certificate, kind) > 0 &&
      std::any_of(certificate.violations.begin(), certificate.violations.end(), of_kind))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "no " << name(kind) << " in\n" << to_text(certificate);
}

/// True if the certificate reports this kind and no other.
inline ::testing::AssertionResult reports_only(const Certificate& certificate, ViolationKind kind) {
  for (const Violation& violation : certificate.violations)
    if (violation.kind != kind) return ::testing::AssertionFailure() << violation.message();
  return reports(certificate, kind);
}

}  // namespace pardel::testing
