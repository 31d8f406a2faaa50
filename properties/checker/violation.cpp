#include "violation.hpp"

#include "../../core/support/enum_names.hpp"
#include "arithmetic/text.hpp"

namespace pardel {
namespace {

constexpr auto names = enum_names<ViolationKind>({
    {ViolationKind::index_out_of_range, "index_out_of_range"},
    {ViolationKind::non_finite_coordinate, "non_finite_coordinate"},
    {ViolationKind::wrong_count, "wrong_count"},
    {ViolationKind::degenerate_triangle, "degenerate_triangle"},
    {ViolationKind::duplicate_triangle, "duplicate_triangle"},
    {ViolationKind::non_manifold_edge, "non_manifold_edge"},
    {ViolationKind::non_manifold_vertex, "non_manifold_vertex"},
    {ViolationKind::wrong_neighbour, "wrong_neighbour"},
    {ViolationKind::euler_characteristic, "euler_characteristic"},
    {ViolationKind::overlap, "overlap"},
    {ViolationKind::uncovered_domain, "uncovered_domain"},
    {ViolationKind::covered_exterior, "covered_exterior"},
    {ViolationKind::area_mismatch, "area_mismatch"},
    {ViolationKind::missing_input_vertex, "missing_input_vertex"},
    {ViolationKind::unused_vertex, "unused_vertex"},
    {ViolationKind::broken_segment, "broken_segment"},
    {ViolationKind::chain_off_segment, "chain_off_segment"},
    {ViolationKind::chains_meet, "chains_meet"},
    {ViolationKind::wrong_chain_order, "wrong_chain_order"},
    {ViolationKind::wrong_face, "wrong_face"},
    {ViolationKind::wrong_constrained_edge, "wrong_constrained_edge"},
    {ViolationKind::missing_constrained_edge, "missing_constrained_edge"},
    {ViolationKind::wrong_edge_marker, "wrong_edge_marker"},
    {ViolationKind::wrong_vertex_marker, "wrong_vertex_marker"},
    {ViolationKind::wrong_region, "wrong_region"},
    {ViolationKind::wrong_origin, "wrong_origin"},
    {ViolationKind::not_delaunay, "not_delaunay"},
    {ViolationKind::not_conforming, "not_conforming"},
    {ViolationKind::small_angle, "small_angle"},
    {ViolationKind::large_area, "large_area"},
    {ViolationKind::region_area, "region_area"},
    {ViolationKind::long_edge, "long_edge"},
    {ViolationKind::size_exceeded, "size_exceeded"},
    {ViolationKind::user_test, "user_test"},
    {ViolationKind::large_circumradius, "large_circumradius"},
    {ViolationKind::wrong_attribute, "wrong_attribute"},
});
static_assert(names.size() == violation_kinds);

std::string places(const std::vector<Point>& where) {
  std::string text;
  for (std::size_t i = 0; i < where.size(); ++i) text.append(i == 0 ? " at " : ", ").append(checker::to_text(where[i]));
  return text;
}

}  // namespace

const char* name(ViolationKind kind) { return names[kind]; }

std::string Violation::message() const {
  std::string text = name(kind) + (": " + witness.text());
  if (!ids.empty()) {
    text += " [ids";
    for (const Index id : ids) text.append(" ").append(id == no_index ? "none" : checker::to_text(id));
    text += "]";
  }
  return text + places(where);
}

std::string Violation::message(const NumbersInWitnesses& numbers) const {
  return name(kind) + (": " + witness.text(numbers)) + places(where);
}

}  // namespace pardel
