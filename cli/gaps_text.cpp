#include "gaps_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../parallel/repair.hpp"
#include "plural.hpp"
#include "verdict.hpp"

namespace pardel::cli {

namespace {

std::string faces_text(std::size_t before, std::size_t after) {
  if (after < before)
    return fmt::format("{} of {} faces vanish{}", before - after, before, before - after == 1 ? "es" : "");
  return fmt::format("{} become{} {}", plural(before, "face"), before == 1 ? "s" : "", after);
}

/// What a repair merges and removes, in parentheses; empty if that is nothing. Changes of the area that can be those of
/// rounding do not count.
std::string effect_text(const SnapEffect& effect) {
  constexpr double least_change = 1e-9;
  if (!effect.succeeds) return " (the repair fails)";
  std::vector<std::string> merged, parts;
  if (effect.points > 0) merged.push_back(plural(effect.points, "point"));
  if (effect.segments > 0) merged.push_back(plural(effect.segments, "segment"));
  const bool one = effect.points + effect.segments == 1;
  if (!merged.empty())
    parts.push_back(fmt::format("{} {} with others", fmt::join(merged, " and "), one ? "merges" : "merge"));
  if (std::abs(effect.area) > least_change)
    parts.push_back(fmt::format("the area changes by {:+.2g} %", 100 * effect.area));
  if (effect.faces_after != effect.faces_before) parts.push_back(faces_text(effect.faces_before, effect.faces_after));
  return parts.empty() ? "" : fmt::format(" ({})", fmt::join(parts, ", "));
}

std::string advice_on(double snap, const ValidPslg& domain) {
  const Result<SnapEffect> effect = effect_of_snap(domain, snap);
  const std::string changes = effect ? effect_text(*effect) : "";
  if (effect && effect->keeps_all_parts)
    return fmt::format("\n--repair with --snap {:.2g} closes the narrowest{}; look at the result", snap, changes);
  return fmt::format(
      "\n--repair with --snap {:.2g} would close the narrowest, but also remove a part of the "
      "domain, a hole or a region{}",
      snap, changes);
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
