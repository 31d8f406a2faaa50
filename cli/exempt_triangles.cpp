#include "exempt_triangles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "verdict.hpp"

namespace pardel::cli {

std::uint64_t ExemptTriangles::missed() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (!justified(static_cast<ExemptReason>(i))) sum += counts[i];
  return sum;
}

void ExemptTriangles::add(const ExemptTriangles& other) {
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
  first.insert(first.end(), other.first.begin(), other.first.end());
  std::ranges::sort(first, {}, &MissedTriangle::number);
  first.resize(std::min(first.size(), most_listed));
}

ExemptTriangles exempt_triangles(const Report& report, const Mesh& mesh, std::uint64_t first_number) {
  ExemptTriangles all;
  for (const Exemption& exemption : report.exempt) {
    ++all.counts[static_cast<std::size_t>(exemption.reason)];
    if (justified(exemption.reason) || all.first.size() == most_listed) continue;
    const auto& v = mesh.triangles[exemption.triangle].v;
    all.first.push_back({first_number + exemption.triangle,
                         exemption.reason,
                         {mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]]}});
  }
  return all;
}

std::string reasons(const ExemptTriangles& exempt, bool justified_ones) {
  std::string list;
  for (std::size_t i = 0; i < exempt.counts.size(); ++i) {
    const auto reason = static_cast<ExemptReason>(i);
    if (justified(reason) != justified_ones || exempt.counts[i] == 0) continue;
    list += fmt::format("{}{} {}", list.empty() ? "" : ", ", exempt.counts[i], pardel::name(reason));
  }
  return list;
}

std::string missed_bounds(const ExemptTriangles& exempt, std::string_view limit, std::string_view all_in) {
  if (exempt.missed() == 0) return {};
  std::string text;
  if (exempt.counts[static_cast<std::size_t>(ExemptReason::budget)] > 0)
    text = fmt::format("the mesh has as many vertices as {} allows (the budget), so ", limit);
  text += fmt::format("the goal is missed at some triangles ({}):", reasons(exempt, false));
  for (const auto& [number, reason, p] : exempt.first)
    text += fmt::format("\n  {}: triangle ({}, {}) ({}, {}) ({}, {})", pardel::name(reason), p[0].x, p[0].y, p[1].x,
                        p[1].y, p[2].x, p[2].y);
  const std::uint64_t left = exempt.missed() - exempt.first.size();
  if (left > 0) text += fmt::format("\n  ... and {} more", left);
  if (left > 0 && !all_in.empty()) text += fmt::format(" (all in {})", all_in);
  return text;
}

}  // namespace pardel::cli
