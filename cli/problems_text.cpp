#include "problems_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

#include "repeated_loops.hpp"
#include "verdict.hpp"

namespace pardel::cli {
namespace {

/// True if repair() removes problems of this kind.
bool is_repairable(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::duplicate_points:
    case ProblemKind::zero_length_segment:
    case ProblemKind::duplicate_segments:
    case ProblemKind::crossing_segments:
    case ProblemKind::overlapping_segments:
    case ProblemKind::point_on_segment:
    case ProblemKind::hole_outside:
    case ProblemKind::hole_on_segment:
    case ProblemKind::region_outside:
    case ProblemKind::region_on_segment:
      return true;
    default:
      return false;
  }
}

}  // namespace

std::string problems_text(std::span<const Problem> problems, const NumbersInMessages& numbers) {
  if (problems.size() == 1) return problems.front().message(numbers);
  std::string text = fmt::format("{} problems", problems.size());
  for (auto first = problems.begin(); first != problems.end();) {
    const auto last = std::find_if(first, problems.end(), [&](const Problem& p) { return p.kind != first->kind; });
    const auto count = static_cast<std::size_t>(last - first);
    const std::size_t listed = std::min(count, most_listed);
    for (std::size_t i = 0; i < listed; ++i) text += "\n  " + first[static_cast<std::ptrdiff_t>(i)].message(numbers);
    if (count > listed) text += fmt::format("\n  ... and {} more ({})", count - listed, name(first->kind));
    first = last;
  }
  return text;
}

std::string advice(const Pslg& pslg, std::span<const Problem> problems, const std::string& file, bool repair_failed,
                   std::string_view hull_option) {
  std::string text = repeated_loops(pslg, problems);
  const bool repairable = std::ranges::all_of(problems, [](const Problem& p) { return is_repairable(p.kind); });
  const bool open =
      std::ranges::any_of(problems, [](const Problem& p) { return p.kind == ProblemKind::unclosed_outline; });
  if (repairable && !repair_failed)
    text += fmt::format(
        "\n'pardel mesh --repair' repairs such problems; 'pardel doctor {} --repair FIXED.poly' writes the repaired "
        "domain",
        file);
  if (open) text += fmt::format("\n{} meshes the convex hull of the points; it needs no closed outline", hull_option);
  return text;
}

}  // namespace pardel::cli
