// The checker refuses the wrong meshes of each family, and accepts the right ones; in pieces, too.
#include <algorithm>
#include <set>
#include <vector>

#include "../../../properties/checker/check_pieces.hpp"
#include "../../../properties/domains/generators/random.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/wrong_meshes/wrong_mesh.hpp"
#include "../checker/cut_mesh.hpp"

namespace pardel {
namespace {

using wrong_meshes::Kind;
using wrong_meshes::WrongMesh;

constexpr std::uint64_t meshes_of_a_kind = 60;

/// Makes meshes of the kinds of a family and judges their certificates.
template <class Check>
void expect_verdicts(std::string_view family, std::uint64_t seeds, properties::Facts& facts, const Check& check) {
  for (const Kind& kind : wrong_meshes::all()) {
    if (kind.family != family) continue;
    std::uint64_t made = 0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      const auto mesh = wrong_meshes::make(kind, seed);
      if (!mesh) continue;
      ++made;
      EXPECT_EQ(wrong_meshes::missed(kind, *mesh, check(*mesh, seed)), "") << kind.name << ", seed " << seed;
    }
    EXPECT_GT(2 * made, seeds) << kind.name << ": too few meshes";
    facts.cases += made;
  }
  EXPECT_GT(facts.cases, 0U);
}

void expect_verdicts(std::string_view family, properties::Facts& facts) {
  expect_verdicts(family, meshes_of_a_kind, facts, [](const WrongMesh& mesh, std::uint64_t) {
    return check(mesh.pslg, mesh.mesh, mesh.goal, mesh.options);
  });
}

constexpr const char* source = "properties/wrong_meshes/wrong_mesh.hpp";
constexpr const char* places = "small domains at scales from 2^-120 to 2^150, turned, and moved by up to 2^40 units";

PARDEL_FACT(WrongMeshes, with_moved_chains_are_refused,
            {.statement = "a mesh is refused, with the place, if a vertex of a chain lies more than two units of its "
                          "segment off, however large other coordinates of the input are",
             .source = source,
             .families = places}) {
  expect_verdicts("moved chains", facts);
}

PARDEL_FACT(WrongMeshes, with_other_holes_and_outlines_are_refused,
            {.statement = "a mesh is refused, with the place, if a part of a hole or of the outside has triangles, or "
                          "a part of the domain has none, however large other coordinates of the input are",
             .source = source,
             .families = places}) {
  expect_verdicts("holes and outlines", facts);
}

PARDEL_FACT(WrongMeshes, with_pinched_chains_are_refused,
            {.statement = "a mesh is refused, with the place, if chains share a vertex that is no common end of their "
                          "segments, although it lies within two units of both",
             .source = source,
             .families = places}) {
  expect_verdicts("pinched chains", facts);
}

PARDEL_FACT(WrongMeshes, with_another_order_around_a_point_are_refused,
            {.statement = "a mesh is refused, with the place, if chains leave an input point in another order than "
                          "their segments, although they lie within two units of them",
             .source = source,
             .families = places}) {
  expect_verdicts("orders", facts);
}

PARDEL_FACT(WrongMeshes, with_parts_on_another_side_are_refused,
            {.statement = "a mesh is refused, with the place, if a point or a segment of the domain lies on the other "
                          "side of a chain, although the chain lies within two units of its segment",
             .source = source,
             .families = places}) {
  expect_verdicts("changed sides", facts);
}

PARDEL_FACT(WrongMeshes, with_small_angles_that_have_no_cause_are_refused,
            {.statement = "a mesh is refused, with the place, if an angle below the bound has no small input angle as "
                          "its own cause, or is smaller than such a cause allows",
             .source = source,
             .families = places}) {
  expect_verdicts("excuses", facts);
}

PARDEL_FACT(WrongMeshes, with_labels_of_other_places_are_refused,
            {.statement = "a mesh is refused, with the place, if a triangle has a region that is not that of its face, "
                          "or an attribute of an inserted vertex is no number, leaves the range of the input, or, on a "
                          "segment, that of its ends",
             .source = source,
             .families = places}) {
  expect_verdicts("labels", facts);
}

PARDEL_FACT(WrongMeshes, with_triangles_that_are_too_large_are_refused,
            {.statement = "a mesh is refused, with the place, if a triangle is too large for a bound or for the wanted "
                          "length, however large other coordinates of the input are",
             .source = source,
             .families = places}) {
  expect_verdicts("sizes", facts);
}

PARDEL_FACT(WrongMeshes, with_gaps_and_overlaps_of_a_unit_are_refused,
            {.statement = "a mesh is refused, with the place, if triangles overlap or leave a gap, or an edge is not "
                          "Delaunay, by one unit",
             .source = source,
             .families = places}) {
  expect_verdicts("structure", facts);
}

PARDEL_FACT(WrongMeshes, have_right_neighbours_that_are_accepted,
            {.statement = "a mesh is accepted if its chains lie as far off their segments as two units allow, and its "
                          "angles, sizes and attributes are at their bounds",
             .source = source,
             .families = places}) {
  expect_verdicts("right", facts);
}

/// A piece of the mesh for each of up to three ranks, or several.
std::vector<NumberedMesh> some_pieces(const Mesh& mesh, generators::Random& random, std::size_t count) {
  std::vector<std::size_t> owner(mesh.triangles.size());
  for (std::size_t t = 0; t < owner.size(); ++t) owner[t] = random.below(count);
  return testing::cut_mesh(mesh, owner, count);
}

Certificate check_in_pieces(const WrongMesh& mesh, std::uint64_t seed) {
  generators::Random random(seed);
  const std::size_t count = 1 + random.below(4);
  const std::vector<NumberedMesh> pieces = some_pieces(mesh.mesh, random, count);
  Certificate certificate;
  properties::on_ranks(static_cast<int>(1 + random.below(2)), [&](Ranks& ranks) {
    // The first rank has all pieces but the last one.
    const std::size_t first = ranks.rank() == 0 ? 0 : count - 1;
    const std::size_t end = ranks.count() > 1 && ranks.rank() == 0 ? count - 1 : count;
    const PiecesOfRank mine{end - first, [&](std::size_t i) -> Result<std::shared_ptr<const NumberedMesh>> {
                              return std::make_shared<const NumberedMesh>(pieces[first + i]);
                            }};
    const Result<Certificate> result = check(mesh.pslg, mine, mesh.goal, mesh.options, ranks);
    if (ranks.rank() != 0) return;
    if (result)
      certificate = *result;
    else
      ADD_FAILURE() << result.error().message;
  });
  return certificate;
}

PARDEL_FACT(WrongMeshes, in_pieces_are_refused,
            {.statement = "a mesh that is wrong is refused, with the place, and a right one is accepted, if it is "
                          "divided into pieces, on one rank or two",
             .source = source,
             .families = "the wrong and the right meshes of all kinds"}) {
  std::set<std::string_view> families;
  for (const Kind& kind : wrong_meshes::all()) families.insert(kind.family);
  for (const std::string_view family : families) expect_verdicts(family, 10, facts, check_in_pieces);
}

}  // namespace
}  // namespace pardel
