#include "mesher_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plural.hpp"

namespace pardel::cli {
namespace {

/// Calls visit(count, first) for each kind of breach that has occurred.
template <class Visit>
void for_each_kind(const Breaches& breaches, const Visit& visit) {
  for (std::size_t kind = 0; kind < breach_kinds; ++kind)
    if (breaches.count[kind] > 0) visit(breaches.count[kind], breaches.first[kind]);
}

}  // namespace

nlohmann::ordered_json mesher_json(const MesherOfRun& mesher) {
  const MesherReport& r = mesher.report;
  nlohmann::ordered_json breaches = nlohmann::ordered_json::array();
  for_each_kind(r.breaches, [&](std::uint64_t count, const Breach& first) {
    breaches.push_back({{"kind", pardel::name(first.kind)},
                        {"tasks", count},
                        {"first", {{"at", {first.where.x, first.where.y}}, {"what", first.what}}}});
  });
  return {{"name", mesher.name},
          {"scheme", pardel::name(mesher.scheme)},
          {"tasks", r.tasks},
          {"sweeps", r.sweeps},
          {"phases", r.phases},
          {"vertices", {{"before", r.prepared}, {"by_mesher", r.inserted}, {"after", r.completed}}},
          {"at_limit", r.at_limit},
          {"flipped_edges", r.flipped},
          {"breaches", breaches},
          {"seconds",
           {{"preparation", r.preparation_seconds},
            {"division", r.division_seconds},
            {"mesher", r.mesher_seconds},
            {"extraction", r.extraction_seconds},
            {"verification", r.verification_seconds},
            {"gluing", r.gluing_seconds}}}};
}

std::string mesher_text(const MesherOfRun& mesher) {
  const MesherReport& r = mesher.report;
  std::string text = fmt::format("mesher  {}, {}: {} in {} made {}; pardel made {} before and {} after\n", mesher.name,
                                 pardel::name(mesher.scheme), plural(r.tasks, "task"), plural(r.sweeps, "sweep"),
                                 plural(r.inserted, "vertex", "vertices"), r.prepared, r.completed);
  for_each_kind(r.breaches, [&](std::uint64_t count, const Breach& first) {
    text += fmt::format("breach  {} in {}, the first at ({:.6g}, {:.6g}): {}\n", pardel::name(first.kind),
                        plural(count, "task"), first.where.x, first.where.y, first.what);
  });
  return text;
}

}  // namespace pardel::cli
