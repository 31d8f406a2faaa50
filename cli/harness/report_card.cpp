#include "report_card.hpp"

#include <algorithm>
#include <tuple>

namespace pardel::harness {
namespace {

template <class Rows, class Matches, class Row>
auto& row_of(Rows& rows, const Matches& matches, Row fresh) {
  const auto found = std::find_if(rows.begin(), rows.end(), matches);
  return found != rows.end() ? *found : rows.emplace_back(std::move(fresh));
}

}  // namespace

void count(ReportCard& card) {
  for (std::size_t i = 0; i < card.cases.size(); ++i) {
    const Family family = card.cases[i].family;
    const Outcome& outcome = card.outcomes[i];
    const auto verdict = static_cast<std::size_t>(outcome.verdict);
    ++card.counts[verdict];
    ++row_of(
          card.families, [&](const FamilyRow& row) { return row.family == family; }, FamilyRow{family, {}})
          .counts[verdict];
    for (const Finding& finding : outcome.findings) {
      ++row_of(
            card.kinds, [&](const FailureKind& row) { return row.kind == finding.kind; },
            FailureKind{outcome.verdict, finding.kind, 0, i, finding.message, {}})
            .cases;
    }
  }
  std::sort(card.kinds.begin(), card.kinds.end(), [](const FailureKind& a, const FailureKind& b) {
    return std::tie(a.verdict, b.cases, a.kind) < std::tie(b.verdict, a.cases, b.kind);
  });
}

bool all_valid(const ReportCard& card) {
  return card.counts[static_cast<std::size_t>(Verdict::valid)] == card.outcomes.size();
}

}  // namespace pardel::harness
