#include "outcome.hpp"

#include <algorithm>

#include "../../core/support/enum_names.hpp"
#include "../../properties/checker/check.hpp"
#include "../verdict.hpp"

namespace pardel::harness {
namespace {

constexpr std::size_t max_listed = 10;

constexpr auto verdict_names = enum_names<Verdict>({
    {Verdict::valid, "valid"},
    {Verdict::missed, "missed"},
    {Verdict::wrong, "wrong"},
    {Verdict::crashed, "crashed"},
    {Verdict::hung, "hung"},
    {Verdict::refused, "refused"},
});
static_assert(decltype(verdict_names)::size() == verdict_count);

}  // namespace

const char* name(Verdict verdict) { return verdict_names[verdict]; }

Outcome judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, bool delaunay) {
  Certificate certificate = check(pslg, mesh, goal, {.max_violations = max_listed, .foreign = true});
  if (!delaunay) certificate.violation_counts[static_cast<std::size_t>(ViolationKind::not_delaunay)] = 0;
  const bool only_bounds = cli::only_bounds_missed(certificate);
  Outcome outcome{only_bounds ? Verdict::missed : Verdict::wrong, {}, {}, {}};
  for (const Violation& violation : certificate.violations) {
    const auto count = certificate.violation_counts[static_cast<std::size_t>(violation.kind)];
    if (count == 0 || cli::is_missed_bound(violation.kind) != only_bounds) continue;
    const std::string kind = name(violation.kind);
    outcome.details.push_back(violation.message());
    outcome.where.insert(outcome.where.end(), violation.where.begin(), violation.where.end());
    if (!outcome.has(kind)) outcome.findings.push_back({kind, outcome.details.back()});
  }
  return outcome.findings.empty() ? Outcome{} : outcome;
}

bool Outcome::has(const std::string& kind) const {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.kind == kind; });
}

}  // namespace pardel::harness
