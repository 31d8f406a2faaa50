// A violation in one component of a domain is found whatever the scales of the other components are, and they excuse
// and spoil nothing.
#include "../../../properties/theorems/refinement/mixed_scales.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/join_pieces.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/defects/defects.hpp"
#include "../../../properties/theorems/framework/shares.hpp"

namespace pardel {
namespace {

using defects::Defect;
using defects::Field;
using properties::MixedProblem;

constexpr const char* source = "properties/checker/check.hpp";

Defect some_defect(bool (*suits)(const Defect&)) {
  std::vector<Defect> suitable;
  std::ranges::copy_if(defects::all(), std::back_inserter(suitable), suits);
  return *rc::gen::elementOf(suitable);
}

std::uint64_t count(const Certificate& certificate, ViolationKind kind) {
  return certificate.violation_counts.at(static_cast<std::size_t>(kind));
}

/// A handle between triangles of two components makes one component of them, whose Euler characteristic is right.
bool is_wrong_in_several_components(const Defect& defect) {
  return defect.expected != ViolationKind::euler_characteristic;
}

PARDEL_PROPERTY(Check, finds_every_seeded_defect_where_scales_are_mixed,
                {.statement = "Every seeded defect of a mesh whose domain mixes scales is reported as what it is, "
                              "wherever it is. (A handle between two components is left out.)",
                 .source = source,
                 .families = properties::mixed_families}) {
  const MixedProblem drawn = properties::some_mixed_problem(exhibit);
  Pslg pslg = drawn.problem.pslg;
  Goal goal = drawn.problem.goal;
  Mesh mesh = properties::meshed(drawn.problem, exhibit).mesh;
  RC_PRE(check(pslg, mesh, goal).valid);
  const Defect defect = some_defect(is_wrong_in_several_components);
  RC_PRE(defect.inject(pslg, mesh, goal, *rc::gen::arbitrary<std::uint32_t>()));
  const Certificate certificate = check(pslg, mesh, goal);
  RC_LOG() << defect.name << '\n' << to_text(certificate);
  RC_ASSERT(!certificate.valid);
  // A chain of rounded vertices can have concave corners within the tolerance. Who fills one changes the chain.
  RC_ASSERT(count(certificate, defect.expected) > 0U || defect.expected == ViolationKind::covered_exterior);
}

struct MeshedPart {
  Pslg pslg;
  Mesh mesh;
};

/// The numbers of points, segments and regions that come before those of a part.
struct Before {
  Index points = 0, segments = 0, regions = 0;
};

/// The mesh of a part, in the numbers of the domain that has several parts. `next`: the number of the next vertex that
/// is no input point.
NumberedMesh numbered(MeshedPart part, Before before, Index& next) {
  Mesh& mesh = part.mesh;
  NumberedMesh piece;
  for (Index v = 0; v < mesh.points.size(); ++v) {
    piece.number.push_back(v < part.pslg.points.size() ? before.points + v : next++);
    Index& origin = mesh.origin[v];
    if (origin != interior_vertex && origin != input_vertex && origin != hull_vertex) origin += before.segments;
  }
  for (ConstrainedEdge& edge : mesh.constrained_edges)
    if (edge.segment != no_index) edge.segment += before.segments;
  if (mesh.region.empty()) mesh.region.resize(mesh.triangles.size(), no_index);
  for (Index& region : mesh.region)
    if (region != no_index) region += before.regions;
  piece.mesh = std::move(mesh);
  return piece;
}

/// The mesh of a domain that consists of these parts, one after another; nothing if the damage of a part does not allow
/// to join them.
std::optional<Mesh> joined(const Pslg& pslg, const std::vector<MeshedPart>& parts) {
  auto next = static_cast<Index>(pslg.points.size());
  Before before;
  std::vector<NumberedMesh> pieces;
  for (const MeshedPart& part : parts) {
    pieces.push_back(numbered(part, before, next));
    before.points += static_cast<Index>(part.pslg.points.size());
    before.segments += static_cast<Index>(part.pslg.segments.size());
    before.regions += static_cast<Index>(part.pslg.regions.size());
  }
  Result<Mesh> mesh = join_pieces(pieces);
  if (!mesh) return {};
  if (pslg.regions.empty()) mesh->region.clear();
  mesh->region_attributes.clear();
  for (const Region& region : pslg.regions) mesh->region_attributes.push_back(region.attribute);
  return std::move(*mesh);
}

/// Changes of the entries of vertices, of triangles and of edges. The arrays keep their lengths, or grow together.
bool spoils_entries(const Defect& defect) {
  const defects::Fields& fields = defect.target.fields;
  const std::array whole{Field::neighbours,  Field::region_attributes, Field::input_points, Field::input_segments,
                         Field::input_holes, Field::input_regions,     Field::bounds,       Field::attributes};
  return defect.expected != ViolationKind::index_out_of_range && defect.expected != ViolationKind::wrong_count &&
         defect.expected != ViolationKind::non_finite_coordinate &&
         std::ranges::none_of(whole, [&](Field field) { return fields.has(field); });
}

PARDEL_PROPERTY(
    Check, of_one_component_does_not_depend_on_another,
    {.statement = "A mesh of two components, each with an outline of its own, has as many violations of "
                  "each kind as its components alone: none if both are valid, and those of a seeded "
                  "defect, whatever the scale and the place of the other component are. There can be more "
                  "if triangles are not counter-clockwise, overlap, or cover the outside, where the other "
                  "component may be; and fewer wrong attributes, because the input points of both components "
                  "together have a larger range.",
     .source = source,
     .families = "lattice domains of every family, random goals; a component up to 2^60 times smaller "
                 "beside the domain or in a hole, or a component far off"}) {
  const MixedProblem drawn = properties::some_mixed_problem(exhibit, properties::mixtures_of_components);
  const Goal& goal = drawn.problem.goal;
  std::vector<MeshedPart> parts;
  for (const Pslg& part : drawn.mixed.parts) parts.push_back({part, properties::value_of(mesh(part, goal)).mesh});
  for (const MeshedPart& part : parts) RC_PRE(check(part.pslg, part.mesh, goal).valid);
  const std::size_t spoilt = *rc::gen::inRange<std::size_t>(0, 3);
  Pslg& pslg = parts[spoilt % 2].pslg;
  Mesh& spoilt_mesh = parts[spoilt % 2].mesh;
  Goal same = goal;
  const Defect defect = some_defect(spoils_entries);
  if (spoilt < 2) RC_PRE(defect.inject(pslg, spoilt_mesh, same, *rc::gen::arbitrary<std::uint32_t>()));
  properties::classify(spoilt == 0, "a defect of the first component", 25);
  properties::classify(spoilt == 1, "a defect of the second component", 25);

  const std::optional<Mesh> whole = joined(drawn.problem.pslg, parts), part = joined(pslg, {parts[spoilt % 2]});
  RC_PRE(whole.has_value() && part.has_value());
  const Certificate alone = check(pslg, *part, goal), together = check(drawn.problem.pslg, *whole, goal);
  RC_LOG() << (spoilt < 2 ? defect.name : "no defect") << "\nalone: " << to_text(alone)
           << "\ntogether: " << to_text(together) << '\n';
  using enum ViolationKind;
  const std::array kinds_outside{degenerate_triangle, overlap, covered_exterior};
  const bool may_reach_the_other =
      std::ranges::any_of(kinds_outside, [&](ViolationKind kind) { return count(alone, kind) > 0; });
  properties::classify(!alone.valid && !may_reach_the_other, "a defect that covers nothing outside", 40);
  RC_ASSERT(together.valid == (spoilt == 2));
  for (std::size_t kind = 0; kind < violation_kinds; ++kind) {
    const std::uint64_t of_both = together.violation_counts[kind], of_one = alone.violation_counts[kind];
    RC_LOG() << name(static_cast<ViolationKind>(kind)) << '\n';
    if (static_cast<ViolationKind>(kind) == wrong_attribute)
      RC_ASSERT(of_both <= of_one);
    else if (may_reach_the_other)
      RC_ASSERT(of_both >= of_one);
    else
      RC_ASSERT(of_both == of_one);
  }
}

}  // namespace
}  // namespace pardel
