// The report card as JSON.
#include <nlohmann/json.hpp>

#include "report_card.hpp"

namespace pardel::harness {
namespace {

using Json = nlohmann::ordered_json;

Json counts_json(const Counts& counts) {
  Json json = Json::object();
  for (std::size_t v = 0; v < verdict_count; ++v) json[name(static_cast<Verdict>(v))] = counts[v];
  return json;
}

Json kind_json(const ReportCard& card, const FailureKind& kind) {
  Json json = {{"verdict", name(kind.verdict)},
               {"kind", kind.kind},
               {"cases", kind.cases},
               {"first", to_string(card.cases[kind.first])},
               {"message", kind.message}};
  if (kind.smallest) {
    json["smallest"] = {{"points", kind.smallest->points},
                        {"segments", kind.smallest->segments},
                        {"holes", kind.smallest->holes},
                        {"shrunk_fully", kind.smallest->shrunk_fully},
                        {"poly", kind.smallest->poly.string()}};
  }
  return json;
}

}  // namespace

std::string to_json(const ReportCard& card) {
  Json json = {{"schema", "pardel.harness/1"},
               {"mesher", card.mesher},
               {"goal", card.goal},
               {"limits", card.limits},
               {"seed", card.seed},
               {"cases", card.cases.size()},
               {"counts", counts_json(card.counts)}};
  json["families"] = Json::object();
  for (const FamilyRow& row : card.families) json["families"][name(row.family)] = counts_json(row.counts);
  json["kinds"] = Json::array();
  for (const FailureKind& kind : card.kinds) json["kinds"].push_back(kind_json(card, kind));
  json["failures"] = Json::array();
  for (std::size_t i = 0; i < card.cases.size(); ++i) {
    const Outcome& outcome = card.outcomes[i];
    if (outcome.verdict == Verdict::valid) continue;
    Json findings = Json::array();
    for (const Finding& finding : outcome.findings)
      findings.push_back({{"kind", finding.kind}, {"message", finding.message}});
    json["failures"].push_back({{"case", to_string(card.cases[i])},
                                {"verdict", name(outcome.verdict)},
                                {"findings", findings},
                                {"replay", card.replay + " --replay " + to_string(card.cases[i])}});
  }
  // The messages of a mesher may be invalid UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace pardel::harness
