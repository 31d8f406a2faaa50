#include "verdict.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

namespace pardel::cli {

bool is_missed_bound(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::not_conforming:
    case ViolationKind::small_angle:
    case ViolationKind::large_area:
    case ViolationKind::region_area:
    case ViolationKind::long_edge:
    case ViolationKind::size_exceeded:
    case ViolationKind::user_test:
    case ViolationKind::large_circumradius:
      return true;
    default:
      return false;
  }
}

bool only_bounds_missed(const Certificate& certificate) {
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind) {
    if (certificate.violation_counts[kind] > 0 && !is_missed_bound(static_cast<ViolationKind>(kind))) return false;
  }
  return true;
}

ExitCode code_of(const std::optional<Certificate>& certificate, bool goal_met) {
  const bool is_wrong = certificate && !certificate->valid;
  if (is_wrong && !only_bounds_missed(*certificate)) return ExitCode::violations;
  if (!goal_met) return ExitCode::goal_missed;
  return is_wrong ? ExitCode::violations : ExitCode::done;
}

std::size_t most_kept(const std::filesystem::path& json) {
  return json.empty() ? most_listed : std::numeric_limits<std::size_t>::max();
}

std::string violations_text(const Certificate& certificate, std::size_t most, const NumbersInWitnesses& numbers) {
  std::string text = "the check found violations:";
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind) {
    if (certificate.violation_counts[kind] == 0) continue;
    text += fmt::format(" {} {}", certificate.violation_counts[kind], name(static_cast<ViolationKind>(kind)));
  }
  const std::size_t listed = std::min(most, certificate.violations.size());
  for (std::size_t i = 0; i < listed; ++i) text += "\n  " + certificate.violations[i].message(numbers);
  if (listed < certificate.violations.size()) text += "\n  ...";
  return text;
}

}  // namespace pardel::cli
