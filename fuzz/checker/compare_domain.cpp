#include <algorithm>
#include <utility>

#include "compare.hpp"
#include "correspondence.hpp"
#include "definitions.hpp"
#include "labels.hpp"

namespace pardel::fuzz {
namespace {

using enum ViolationKind;

constexpr auto faults_of_coverage = {uncovered_domain, covered_exterior, area_mismatch};
/// The rules of which a mesh with all input points breaks one if and only if it does not satisfy (V2).
constexpr auto faults_of_chains = {broken_segment, chain_off_segment, chains_meet,      wrong_chain_order,
                                   wrong_face,     uncovered_domain,  covered_exterior, area_mismatch};

/// The segments without a chain. If there is a chain that was meant, the checker reports its vertices.
std::set<Index> broken_or_off(const Findings& found, const Pslg& pslg) {
  return found.collect<Index>([&](const Violation& v, std::set<Index>& segments) {
    if (v.kind == broken_segment && v.ids.size() == 1) segments.insert(v.ids[0]);
    if (v.kind == chain_off_segment && v.ids[1] < pslg.segments.size()) segments.insert(v.ids[1]);
  });
}

/// The triangles that contain the seed of a hole, with the number of the hole.
std::set<std::pair<Index, Index>> in_holes(const Findings& found) {
  return found.collect<std::pair<Index, Index>>([](const Violation& v, auto& pairs) {
    if (v.kind == covered_exterior && v.ids.size() == 2) pairs.emplace(v.ids[0], v.ids[1]);
  });
}

/// Are all vertices of chains exactly on their walls?
bool are_on_walls(const ExactMesh& mesh, const Chains& chains) {
  const auto& p = mesh.plain.points;
  return std::ranges::all_of(chains, [&](const Chain& chain) {
    return std::ranges::all_of(
        chain.path, [&](Index v) { return CGAL::collinear(p[chain.path.front()], p[v], p[chain.path.back()]); });
  });
}

void compare_labels(const Judged& judged, const Chains& chains) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  const WallsOfMesh walls(mesh, chains);
  const ListFaults list = faults_of_list(mesh, walls, options.foreign);
  found.require(wrong_constrained_edge, found.first(wrong_constrained_edge), list.wrong);
  found.require(wrong_edge_marker, found.first(wrong_edge_marker), list.wrong_marker);
  found.require(missing_constrained_edge, found.edges(missing_constrained_edge), list.missing);
  found.require(wrong_origin, found.first(wrong_origin), with_wrong_origin(mesh, pslg, walls));
  found.require(wrong_vertex_marker, found.first(wrong_vertex_marker),
                with_wrong_marker(mesh, pslg, faces, walls, options.foreign));
  if (!options.foreign)
    found.require(wrong_attribute, found.first(wrong_attribute), with_wrong_attributes(mesh, pslg, &walls));
}

/// The attributes that are wrong whatever the chains are.
void compare_attributes_in_all(const Judged& judged) {
  const std::set<Index> found = judged.found.first(wrong_attribute);
  const std::set<Index> wrong = with_wrong_attributes(judged.mesh, judged.pslg);
  if (judged.options.foreign) return judged.found.require(wrong_attribute, found, wrong);
  if (!std::ranges::includes(found, wrong)) fail("the checker does not report an attribute outside the input's range");
}

/// Faces of chains, and what belongs to them. Precondition: chains meet in input points only, in the right order.
void compare_faces(const Judged& judged, const Chains& chains) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  const bool has_sides = has_the_sides_of_the_domain(mesh, chains);
  if (are_on_walls(mesh, chains) && has_sides != covers_domain(mesh, faces))
    fail("two definitions of covering the domain contradict each other");
  if (!has_sides) {
    if (!found.has_any(faults_of_coverage)) fail("the checker does not report that the mesh does not cover the domain");
    return;
  }
  const FacesOfChains of_chains(mesh, chains, pslg, faces);
  if (!of_chains.correspond) return found.require(wrong_face, true);
  found.require(wrong_face, found.first(wrong_face), of_chains.strayed);
  if (!of_chains.strayed.empty()) return;
  if (found.has_any(faults_of_coverage)) fail("only the checker reports that the mesh does not cover the domain");
  const auto& face = of_chains.of_triangle;
  if (has_labels)
    found.require(wrong_region, found.first(wrong_region), with_wrong_region(mesh, pslg, faces, face, options.foreign));
  if (goal.region_caps) found.require(region_area, found.first(region_area), larger_than_caps(mesh, pslg, faces, face));
}

/// False if no choice of chains satisfies (V2).
bool may_be_right(const Judged& judged, const PossibleChains& possible) {
  const auto fits = [&](const Chains& choice) {
    return are_chains_of_the_domain(judged.mesh, choice, judged.pslg, judged.faces);
  };
  return some_choice_fits(possible, fits).value_or(true);
}

}  // namespace

std::optional<Chains> compare_domain(const Judged& judged) {
  const auto& [mesh, pslg, faces, goal, options, certificate, found, has_labels] = judged;
  const std::set<Index> missing = missing_inputs(mesh, pslg, faces);
  // In a file, vertices may be input points although their numbers differ.
  if (options.foreign && !missing.empty()) return std::nullopt;
  found.require(missing_input_vertex, found.first(missing_input_vertex), missing);
  found.require(unused_vertex, found.first(unused_vertex), unused_points(mesh, pslg));
  if (has_labels) compare_attributes_in_all(judged);
  if (!missing.empty()) return std::nullopt;

  const PossibleChains possible = possible_chains(mesh, pslg, faces);
  found.require(broken_segment, broken_or_off(found, pslg), possible.broken);
  if (found.has_any({broken_segment, chain_off_segment}) == possible.are_whole)
    fail("the checker and the definition disagree whether a side of the hull is broken");
  if (!possible.are_whole) return std::nullopt;
  if (!found.has_any(faults_of_chains) && !with_another_border(mesh, pslg, faces).empty())
    fail("the checker accepts a border that touches itself elsewhere than that of the domain");
  std::optional<Chains> chains = meant_chains(mesh, possible);
  const std::set<Index> meeting = chains ? meeting_points(*chains, pslg) : std::set<Index>{};
  // Where chains meet that were chosen among others, the checker chooses again.
  if (!chains || (!meeting.empty() && possible.leave_a_choice())) {
    if (!found.has_any(faults_of_chains) && !may_be_right(judged, possible))
      fail("the checker accepts a mesh of which no choice of chains is right");
    return std::nullopt;
  }
  const std::set<Index> other_order = points_of_another_order(mesh, *chains, pslg);
  found.require(chains_meet, found.first(chains_meet), meeting);
  found.require(wrong_chain_order, found.first(wrong_chain_order), other_order);
  if (!meeting.empty()) return std::nullopt;
  found.require(covered_exterior, in_holes(found), triangles_in_holes(mesh, *chains, pslg));
  if (has_labels) compare_labels(judged, *chains);
  if (other_order.empty()) compare_faces(judged, *chains);
  return chains;
}

}  // namespace pardel::fuzz
