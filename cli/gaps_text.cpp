#include "gaps_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "../parallel/repair.hpp"
#include "plural.hpp"
#include "verdict.hpp"

namespace pardel::cli {

namespace {

std::string advice_on(double snap, const ValidPslg& domain) {
  const Result<bool> harmless = keeps_all_parts(domain, snap);
  if (harmless && *harmless)
    return fmt::format("\n--repair with --snap {:.2g} closes the narrowest; look at the result", snap);
  return fmt::format(
      "\n--repair with --snap {:.2g} would close the narrowest, but also remove a part of the "
      "domain, a hole or a region",
      snap);
}

}  // namespace

std::string gaps_text(std::span<const Gap> gaps, const std::string& file, const ValidPslg& domain) {
  if (gaps.empty()) return {};
  const int first_id = domain.pslg().first_id.value;
  std::string text =
      fmt::format("{}: warning: {} much narrower than the segments around, or too narrow for double precision", file,
                  plural(gaps.size(), "gap is", "gaps are"));
  for (const Gap& gap : gaps.first(std::min(gaps.size(), most_listed))) text += "\n  " + gap.message(first_id);
  if (gaps.size() > most_listed) text += fmt::format("\n  ... and {} more (all in --json)", gaps.size() - most_listed);
  // Rounding to two digits must not make the distance too small.
  if (const double snap = closing_snap(gaps); snap > 0) text += advice_on(1.1 * snap, domain);
  return text;
}

nlohmann::ordered_json gaps_json(std::span<const Gap> gaps, int first_id) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Gap& gap : gaps) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array(), segment;
    for (const Index point : gap.points) points.push_back(std::int64_t{point} + first_id);
    if (gap.segment != no_index) segment = std::int64_t{gap.segment} + first_id;
    all.push_back({{"kind", name(gap.kind)},
                   {"points", points},
                   {"segment", segment},
                   {"distance", gap.distance},
                   {"where", {gap.where.x, gap.where.y}},
                   {"message", gap.message(first_id)}});
  }
  return all;
}

}  // namespace pardel::cli
