// Refining a mesh that meets the goal changes nothing, whoever made it and through whatever file it came. A mesh that
// does not meet the goal does so after one refinement.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/join_pieces.hpp"
#include "../../../distributed/distributed.hpp"
#include "../framework/local_ranks.hpp"
#include "../framework/shares.hpp"
#include "mesh_file.hpp"
#include "turned_problems.hpp"

namespace pardel::properties {
namespace {

constexpr const char* again_source = "properties/THEORY.md, refining again";
constexpr const char* again_families =
    "lattice domains of every family, also turned; wedges; random goals; all formats that are read, also with elements "
    "of second order; .gr3 and .14, which lack edges inside the domain, only for domains without segments inside";

/// Two to four segments that leave one point at small angles, in a square. Some have a point in the middle.
Pslg some_wedge() {
  const auto part = [](int from, int to) { return 0.01 * *rc::gen::inRange(from, to); };
  const Point apex{part(-50, 50), part(-50, 50)};
  Pslg pslg;
  pslg.points = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, apex};
  pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  double angle = part(0, 628);
  const auto add = [&](Point p, Index from) {
    pslg.points.push_back(p);
    pslg.segments.push_back({from, static_cast<Index>(pslg.points.size() - 1)});
    return pslg.segments.back().b;
  };
  for (int arms = *rc::gen::inRange(2, 5); arms > 0; --arms) {
    const double length = part(20, 140);
    const Point end{apex.x + length * std::cos(angle), apex.y + length * std::sin(angle)};
    const bool is_divided = *rc::gen::arbitrary<bool>();
    const Index from = is_divided ? add({(apex.x + end.x) / 2, (apex.y + end.y) / 2}, 4) : 4;
    add(end, from);
    angle += std::exp2(-*rc::gen::inRange(0, 12));
  }
  return pslg;
}

Goal some_goal(const generators::LatticeDomain& domain) {
  const auto make = [domain](generators::Random& random, int) { return generators::any_goal(domain, random); };
  const generators::LatticeGoal drawn = *generators::generator(make, generators::shrinks_of);
  Goal goal = to_goal(drawn, domain);
  goal.region_caps = false;  // a Mesh does not store area caps
  return goal;
}

/// A domain, a goal for a first mesh, and one for its refinement.
struct TwoGoals {
  Pslg pslg;
  Goal first, second;
};

TwoGoals some_two_goals(Exhibit& exhibit) {
  TwoGoals drawn;
  const int kind = *rc::gen::inRange(0, 3);
  if (kind == 0) {
    const generators::Case c = some_case(exhibit);
    drawn = {to_pslg(c.domain), to_goal(c.goal, c.domain), some_goal(c.domain)};
    drawn.first.region_caps = false;
  } else {
    const Problem problem = kind == 1 ? some_turned_problem(exhibit) : Problem{some_wedge(), {}};
    RC_PRE(find_problems(problem.pslg).empty());
    const auto goal = [&] {
      return Goal{.min_angle_deg = *rc::gen::element(0.0, 20.0, 28.0), .conforming = *rc::gen::inRange(0, 3) == 0};
    };
    drawn = {problem.pslg, goal(), goal()};
    if (kind == 2) drawn.second.max_area = *rc::gen::element(Goal{}.max_area, 0.1, 0.02);
  }
  if (*rc::gen::inRange(0, 4) == 0) {
    double extent = 0;
    for (const Point p : drawn.pslg.points) extent = std::max(extent, std::abs(p.x - drawn.pslg.points[0].x));
    drawn.second.max_edge = extent / *rc::gen::inRange(1, 12);
  }
  exhibit.show(drawn.pslg);
  return drawn;
}

/// A file, and what its format cannot carry.
struct Format {
  const char* file;
  MeshFileOptions options{};
  /// A .gr3 or .14 has only the edges of the boundary, without their markers.
  bool has_only_the_boundary = false;
  /// A .2dm has whole numbers as attributes of regions, and gives regions to all triangles.
  bool changes_regions = false;
  bool has_one_attribute = false;
};
std::vector<Format> formats() {
  const MeshFileOptions text{.msh = MshEncoding::ascii}, order_2{.elements = ElementOrder::second};
  return {{""},
          {"mesh.node"},
          {"mesh.node", order_2},
          {"mesh.vtu"},
          {"mesh.vtu", order_2},
          {"mesh.off"},
          {"mesh.msh"},
          {"mesh.msh", order_2},
          {"text.msh", text},
          {"mesh.vtk"},
          {"mesh.2dm", {}, false, true, true},
          {"mesh.gr3", {}, true, false, true},
          {"mesh.14", {}, true, false, true}};
}

bool has_edges_inside(const Mesh& mesh) {
  std::size_t sides = 0;
  for (const Triangle& t : mesh.triangles) sides += static_cast<std::size_t>(std::ranges::count(t.n, no_index));
  return mesh.constrained_edges.size() > sides;
}

/// A format that carries all constrained edges of the mesh.
Format some_format(const Mesh& mesh) {
  std::vector<Format> all = formats();
  if (has_edges_inside(mesh)) std::erase_if(all, [](const Format& format) { return format.has_only_the_boundary; });
  const Format format = *rc::gen::elementOf(all);
  classify(format.has_only_the_boundary, "a .gr3 or .14", 4);
  classify(format.changes_regions, "a .2dm", 5);
  classify(std::string(format.file) == "mesh.vtk", "a .vtk", 5);
  classify(format.options.elements == ElementOrder::second, "elements of second order", 15);
  return format;
}

/// The part of the domain that a mesh in this format can have.
Pslg as_stored(Pslg pslg, const Format& format) {
  if (format.has_only_the_boundary)
    for (Segment& segment : pslg.segments) segment.marker = 0;
  if (format.has_one_attribute && pslg.attributes_per_point > 1) {
    for (std::size_t i = 0; i < pslg.points.size(); ++i)
      pslg.point_attributes[i] = pslg.point_attributes[i * pslg.attributes_per_point];
    pslg.point_attributes.resize(pslg.points.size());
    pslg.attributes_per_point = 1;
  }
  return pslg;
}

/// The mesh without what the checker cannot compare with the domain.
Mesh comparable(Mesh mesh, const Format& format) {
  if (format.changes_regions) mesh.region.clear();
  if (format.changes_regions) mesh.region_attributes.clear();
  return mesh;
}

/// The mesh after it was written and read; in memory if the name of the file is empty.
Mesh through(const Format& format, const Mesh& mesh, const Pslg& pslg) {
  return *format.file == '\0' ? mesh : written_and_read(mesh, pslg, format.file, format.options);
}

void require_unchanged(const Mesh& mesh, const Goal& goal, const Options& options) {
  const Meshed again = value_of(refine(mesh, {}, goal, options));
  RC_ASSERT(again.report.inserted + again.report.segment_splits == 0U);
  RC_ASSERT(again.report.goal_met());
  RC_ASSERT(again.mesh.points == mesh.points);
  RC_ASSERT(again.mesh.triangles == mesh.triangles);
  RC_ASSERT(again.mesh.point_attributes == mesh.point_attributes);
  RC_ASSERT(digest(again.mesh) == digest(mesh));
}

PARDEL_PROPERTY(Refinement, of_a_certified_mesh_changes_nothing_in_any_format,
                {.statement = "A mesh is made for one goal, written, read, and refined for another one. If the checker "
                              "certifies the mesh for the second goal, nothing changes. If not, the refined mesh is "
                              "certified for it, is written, read and refined again, and nothing changes.",
                 .source = again_source,
                 .families = again_families}) {
  const TwoGoals drawn = some_two_goals(exhibit);
  const Options options = some_options();
  const Mesh made = meshed({drawn.pslg, drawn.first}, exhibit, options).mesh;
  const Format format = some_format(made);
  const Pslg pslg = as_stored(drawn.pslg, format);
  const Mesh read = through(format, made, pslg);
  require_unchanged(read, drawn.first, options);

  const CheckOptions foreign{.foreign = true};
  const bool is_met = check(pslg, comparable(read, format), drawn.second, foreign).valid;
  classify(is_met, "meets the second goal", 20);
  if (is_met) return require_unchanged(read, drawn.second, options);
  Meshed refined = value_of(refine(read, {}, drawn.second, options));
  // No file says on which segments vertices lie, and some do not have the markers of input points.
  if (read.origin.empty()) refined.mesh.origin.clear();
  if (read.point_markers.empty()) refined.mesh.point_markers.clear();
  exhibit.show(pslg, refined.mesh);
  classify(!refined.report.exempt.empty(), "exempt triangles", 5);
  RC_ASSERT(refined.report.goal_met());
  require_valid(check(pslg, comparable(refined.mesh, format), drawn.second, foreign));
  require_unchanged(through(format, refined.mesh, pslg), drawn.second, options);
}

PARDEL_PROPERTY(Refinement, of_a_mesh_of_several_ranks_changes_nothing,
                {.statement = "Two to four ranks make a mesh; its pieces are joined, written, read, and refined with "
                              "the same goal. Nothing changes.",
                 .source = again_source,
                 .families = again_families}) {
  const TwoGoals drawn = some_two_goals(exhibit);
  Options options = some_options();
  options.triangles_per_tile = 10;
  const ValidPslg domain = std::move(validate(drawn.pslg)).value();
  std::vector<NumberedMesh> pieces(*rc::gen::inRange<std::size_t>(2, 5));
  on_ranks(static_cast<int>(pieces.size()), [&](pardel::Ranks& ranks) {
    Result<MeshPiece> piece = mesh(domain, drawn.first, options, ranks);
    if (piece) pieces[static_cast<std::size_t>(ranks.rank())] = {std::move(piece->mesh), std::move(piece->number)};
  });
  std::erase_if(pieces, [](const NumberedMesh& piece) { return piece.mesh.points.empty(); });
  const Result<Mesh> joined = join_pieces(pieces);
  if (!joined) RC_FAIL(joined.error().message);
  require_unchanged(through(some_format(*joined), *joined, drawn.pslg), drawn.first, options);
}

}  // namespace
}  // namespace pardel::properties
