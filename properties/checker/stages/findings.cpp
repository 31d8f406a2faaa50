#include "findings.hpp"

#include <algorithm>
#include <iterator>

#include "text.hpp"

namespace pardel::checker {

void Findings::append(Findings other) {
  for (Violation& violation : other.kept_) {
    // What both have counted before this one decides whether it is among the first.
    const std::size_t kind = index(violation.kind);
    if (counts_[kind] >= limit_) continue;
    ++counts_[kind];
    --other.counts_[kind];
    kept_.push_back(std::move(violation));
  }
  for (std::size_t kind = 0; kind < violation_kinds; ++kind) counts_[kind] += other.counts_[kind];
}

std::vector<std::uint64_t> Findings::counts() const { return {counts_.begin(), counts_.end()}; }

std::vector<Violation> Findings::sorted() && {
  std::stable_sort(kept_.begin(), kept_.end(), [](const Violation& a, const Violation& b) { return a.kind < b.kind; });
  return std::move(kept_);
}

}  // namespace pardel::checker

namespace pardel {

using namespace checker;

const char* name(ViolationKind kind) {
  switch (kind) {
    case ViolationKind::index_out_of_range:
      return "index_out_of_range";
    case ViolationKind::non_finite_coordinate:
      return "non_finite_coordinate";
    case ViolationKind::wrong_count:
      return "wrong_count";
    case ViolationKind::degenerate_triangle:
      return "degenerate_triangle";
    case ViolationKind::duplicate_triangle:
      return "duplicate_triangle";
    case ViolationKind::non_manifold_edge:
      return "non_manifold_edge";
    case ViolationKind::non_manifold_vertex:
      return "non_manifold_vertex";
    case ViolationKind::wrong_neighbour:
      return "wrong_neighbour";
    case ViolationKind::euler_characteristic:
      return "euler_characteristic";
    case ViolationKind::overlap:
      return "overlap";
    case ViolationKind::uncovered_domain:
      return "uncovered_domain";
    case ViolationKind::covered_exterior:
      return "covered_exterior";
    case ViolationKind::area_mismatch:
      return "area_mismatch";
    case ViolationKind::missing_input_vertex:
      return "missing_input_vertex";
    case ViolationKind::unused_vertex:
      return "unused_vertex";
    case ViolationKind::broken_segment:
      return "broken_segment";
    case ViolationKind::chain_off_segment:
      return "chain_off_segment";
    case ViolationKind::wrong_constrained_edge:
      return "wrong_constrained_edge";
    case ViolationKind::missing_constrained_edge:
      return "missing_constrained_edge";
    case ViolationKind::wrong_edge_marker:
      return "wrong_edge_marker";
    case ViolationKind::wrong_vertex_marker:
      return "wrong_vertex_marker";
    case ViolationKind::wrong_region:
      return "wrong_region";
    case ViolationKind::wrong_origin:
      return "wrong_origin";
    case ViolationKind::not_delaunay:
      return "not_delaunay";
    case ViolationKind::small_angle:
      return "small_angle";
    case ViolationKind::large_area:
      return "large_area";
    case ViolationKind::region_area:
      return "region_area";
    case ViolationKind::long_edge:
      return "long_edge";
    case ViolationKind::size_exceeded:
      return "size_exceeded";
    case ViolationKind::large_circumradius:
      return "large_circumradius";
    case ViolationKind::wrong_attribute:
      return "wrong_attribute";
  }
  return "unknown";
}

std::string Violation::message() const {
  std::string text = name(kind);
  text += ": ";
  text += witness;
  if (!ids.empty()) {
    text += " [ids";
    for (const Index id : ids) text.append(" ").append(to_text(id));
    text += "]";
  }
  for (std::size_t i = 0; i < where.size(); ++i) text.append(i == 0 ? " at " : ", ").append(to_text(where[i]));
  return text;
}

}  // namespace pardel
