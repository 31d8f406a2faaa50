#include "outcome.hpp"

#include "../../properties/check.hpp"
#include "../verdict.hpp"

namespace pardel::harness {
namespace {
constexpr std::size_t most_listed = 10;
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::valid:
      return "valid";
    case Verdict::missed:
      return "missed";
    case Verdict::wrong:
      return "wrong";
    case Verdict::crashed:
      return "crashed";
    case Verdict::hung:
      return "hung";
    case Verdict::refused:
      return "refused";
  }
  return "";
}

Outcome judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, bool delaunay) {
  Certificate certificate = check(pslg, mesh, goal, {.max_violations = most_listed, .foreign = true});
  if (!delaunay) certificate.violation_counts[static_cast<std::size_t>(ViolationKind::not_delaunay)] = 0;
  const bool only_bounds = cli::only_bounds_missed(certificate);
  Outcome outcome{only_bounds ? Verdict::missed : Verdict::wrong, {}, {}, {}, {}};
  const auto counts = [&](ViolationKind kind) {
    return certificate.violation_counts[static_cast<std::size_t>(kind)] > 0 &&
           cli::is_missed_bound(kind) == only_bounds;
  };
  for (std::size_t k = 0; k < certificate.violation_counts.size(); ++k) {
    const auto kind = static_cast<ViolationKind>(k);
    if (counts(kind)) outcome.kinds.emplace_back(name(kind));
  }
  if (outcome.kinds.empty()) return {};
  for (const Violation& violation : certificate.violations) {
    if (!counts(violation.kind)) continue;
    outcome.details.push_back(violation.message());
    outcome.where.insert(outcome.where.end(), violation.where.begin(), violation.where.end());
  }
  if (!outcome.details.empty()) outcome.message = outcome.details.front();
  return outcome;
}

}  // namespace pardel::harness
