// The checker against the definitions, on small meshes, right, damaged and wrong by construction. What follows from
// coordinates, corners and labels is computed here in exact arithmetic (compare.hpp), as sets of triangles, edges and
// points, and must be those of the certificate, for each rule. In a mesh that is not conformal by definition, the
// checker must find a fault of its structure, and in no other. Tolerances are part of the definitions.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../../parallel/mesher.hpp"
#include "../../properties/defects/defects.hpp"
#include "../mesh_case.hpp"
#include "../supply.hpp"
#include "compare.hpp"
#include "damage.hpp"
#include "wrong_mesh_case.hpp"

namespace pardel::fuzz {
namespace {

using generators::Random;

constexpr std::size_t most_triangles = 120;

/// What the bytes behind the strokes choose: the mesh that is drawn, the same as a file that another program wrote, or
/// a mesh that is wrong by construction.
enum class Choice { drawn, file, wrong };

/// The mesh as a file gives it.
void change_to_file(Mesh& mesh, CheckOptions& options, Random& random) {
  options.foreign = true;
  mesh.origin.clear();
  if (random.chance(4)) mesh.constrained_edges.clear();
  if (random.chance(4))
    for (Triangle& t : mesh.triangles) t.n = {no_index, no_index, no_index};
}

/// Other bounds than the mesh had to meet.
void change_goal(Goal& goal, CheckOptions& options, Random& random) {
  if (random.chance(2)) goal.min_angle_deg = random.between(5, 33);
  if (random.chance(4)) goal.max_edge = std::ldexp(1.0, random.between(-2, 4));
  if (random.chance(4)) options.max_circumradius = std::ldexp(1.0, random.between(-2, 4));
  if (!random.chance(4)) return;
  const double at_zero = random.between(-1, 8), slope = random.between(-2, 2) * 0.125;
  goal.size = [=](Point p) { return at_zero + slope * p.x; };
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  Supply behind(bytes.subspan(std::min(bytes.size(), small_case_bytes)));
  const Choice choice = behind.one_of({Choice::drawn, Choice::file, Choice::wrong, Choice::wrong});
  if (choice == Choice::wrong) return try_wrong_mesh(behind);
  MeshCase drawn = decode_small_case(bytes);
  Random random(drawn.seed);
  if (random.chance(2)) drawn.goal = Goal{.min_angle_deg = 0, .convex_hull = drawn.goal.convex_hull};
  drawn.goal.size = nullptr;
  drawn.goal.grading = Goal{}.grading;
  drawn.goal.feature_edges = 0;
  Prepared prepared = prepare(drawn);
  if (!prepared.usable) return -1;
  Pslg& valid = prepared.pslg;
  if (random.chance(2) && valid.attributes_per_point == 0) {
    valid.attributes_per_point = 1;
    for (const Point p : valid.points) valid.point_attributes.push_back(p.x + p.y);
  }
  if (random.chance(2)) {
    // Drawn in any case, so that what follows does not depend on the decorations of the domain.
    std::vector<int> markers;
    for (std::size_t i = 0; i < valid.points.size(); ++i) markers.push_back(random.between(0, 2));
    if (valid.point_markers.empty()) valid.point_markers = std::move(markers);
  }
  drawn.options.max_vertices = valid.points.size() + 30;
  Result<Meshed> meshed = mesh(valid, drawn.goal, drawn.options);
  if (!meshed) fail("a valid Pslg was rejected: " + meshed.error().message);
  Mesh& made = meshed->mesh;
  if (made.triangles.size() > most_triangles) return -1;

  Pslg pslg = valid;
  Goal goal = drawn.goal;
  CheckOptions options{.max_violations = 100'000};
  // A defect needs a valid mesh. This one may miss the goal, because of the limit on vertices.
  const bool is_valid = check(pslg, made, goal).valid;
  const std::size_t kind = random.below(4);
  if (kind == 1 && is_valid) {
    const auto all = defects::all();
    all[random.below(all.size())].inject(pslg, made, goal, random.next());
  } else if (kind >= 2) {
    // At most two changes: of several wrong neighbours the checker may report only some.
    for (std::size_t n = 1 + random.below(2); n > 0; --n) damage(made, random);
  }
  change_goal(goal, options, random);
  if (choice == Choice::file) {
    change_to_file(made, options, random);
    // A defect may have left arrays of other lengths.
    for (std::size_t n = kind == 1 ? 0 : random.below(3); n > 0; --n) damage_values(made, random);
    if (random.chance(4)) nudge(made, random);
  }
  if (pslg == valid)
    compare(pslg, made, goal, options);
  else
    judge(pslg, made, goal, options);  // the definitions are for valid domains
  return 0;
}

}  // namespace pardel::fuzz
