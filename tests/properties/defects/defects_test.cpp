// Defects are put into valid meshes, at several places of several meshes. The checker reports each with the expected
// kind.
#include "../../../properties/defects/defects.hpp"

#include <set>
#include <string>
#include <utility>

#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/wrong_meshes/wrong_mesh.hpp"
#include "changes.hpp"

namespace pardel {
namespace {

/// A valid mesh, with a name for messages.
struct Subject : defects::MeshedCase {
  Subject(std::string called, Pslg domain, Goal asked, Mesh made)
      : MeshedCase{std::move(domain), std::move(made), std::move(asked)}, name(std::move(called)) {}
  std::string name;
};

Goal goal_of(double min_angle_deg, double max_area = std::numeric_limits<double>::infinity()) {
  Goal goal;
  goal.min_angle_deg = min_angle_deg;
  goal.max_area = max_area;
  goal.region_caps = true;
  return goal;
}

/// A unit square whose points have attributes and markers.
Pslg labelled_square() {
  Pslg pslg = domains::square();
  pslg.attributes_per_point = 2;
  pslg.point_attributes = {0, 1, 2, 3, 4, 5, 6, 7};
  pslg.point_markers = {11, 0, 13, 0};
  pslg.points.push_back({0.25, 0.625});
  pslg.point_attributes.insert(pslg.point_attributes.end(), {8, 9});
  pslg.point_markers.push_back(15);
  return pslg;
}

/// A domain with three faces. The last face belongs to no region.
Pslg two_regions_of_three() {
  Pslg pslg = domains::regions();
  pslg.regions.pop_back();
  return pslg;
}

/// A segment with a point close to it on either side. The segment is not locally Delaunay.
Pslg points_near_a_wall() {
  Pslg pslg = domains::square();
  pslg.points.insert(pslg.points.end(), {{0.125, 0.5}, {0.875, 0.5}, {0.5, 0.5625}, {0.5, 0.4375}});
  pslg.segments.push_back({4, 5, 0});
  return pslg;
}

Subject meshed(std::string name, Pslg pslg, Goal goal) {
  auto result = mesh(pslg, goal);
  EXPECT_TRUE(result.ok()) << name << ": " << (result ? "" : result.error().message);
  if (!result) return {std::move(name), std::move(pslg), std::move(goal), {}};
  return {std::move(name), std::move(pslg), std::move(goal), std::move(result->mesh)};
}

/// The constrained Delaunay triangulation: no point is added, and there is no bound on angles.
Subject triangulated(std::string name, Pslg pslg) {
  auto result = triangulate(pslg);
  EXPECT_TRUE(result.ok()) << name;
  if (!result) return {std::move(name), std::move(pslg), goal_of(0), {}};
  return {std::move(name), std::move(pslg), goal_of(0), std::move(result->mesh)};
}

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all = {
      meshed("square", domains::square(), goal_of(25, 0.02)),
      meshed("labelled_square", labelled_square(), goal_of(20.7, 0.05)),
      meshed("regions", two_regions_of_three(), goal_of(20.7)),
      meshed("touching_holes", domains::touching_holes(), goal_of(20.7, 0.5)),
      meshed("cracks", domains::cracks(), goal_of(20.7)),
      meshed("pipe", domains::pipe(), goal_of(20.7)),
      meshed("random_points", domains::random_points(60, 1), goal_of(20.7)),
      triangulated("triangulated_cracks", domains::cracks()),
      triangulated("triangulated_wedge", domains::wedge(50, 1.8)),
      triangulated("triangulated_grid", domains::grid(3)),
      triangulated("triangulated_points_near_a_wall", points_near_a_wall()),
  };
  return all;
}

constexpr std::uint64_t seeds[] = {1, 2, 3};
constexpr const char* defective_meshes = "eleven meshes, each defect at up to three places of each";

std::uint64_t count(const Certificate& certificate, ViolationKind kind) {
  return certificate.violation_counts.at(static_cast<std::size_t>(kind));
}

std::string report(const Certificate& certificate) {
  std::string text;
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind)
    if (certificate.violation_counts[kind] != 0)
      text += std::string(name(static_cast<ViolationKind>(kind))) + " x" +
              std::to_string(certificate.violation_counts[kind]) + " ";
  return text.empty() ? "nothing" : text;
}

std::string identifier(std::string_view sentence) {
  std::string id;
  for (char c : sentence) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) id += c;
    if (c == ' ') id += '_';
  }
  return id;
}

PARDEL_FACT(Checker, accepts_right_meshes,
            {.statement = "the checker accepts the meshes that the seeded defects are put into",
             .source = "properties/checker/check.hpp",
             .families = defective_meshes}) {
  for (const Subject& subject : subjects()) {
    ASSERT_FALSE(subject.mesh.triangles.empty());
    const Certificate certificate = check(subject.pslg, subject.mesh, subject.goal);
    EXPECT_TRUE(certificate.valid) << subject.name << ": " << report(certificate);
    ++facts.cases;
  }
}

bool inject(const defects::Defect& defect, defects::MeshedCase& into, std::uint64_t seed) {
  return defect.inject(into.pslg, into.mesh, into.goal, seed);
}

/// Makes the defect at several places of every mesh and expects the verdict. Returns the number of places.
std::uint64_t expect_verdict(const defects::Defect& defect) {
  std::uint64_t places = 0;
  for (const Subject& subject : subjects()) {
    for (const std::uint64_t seed : seeds) {
      defects::MeshedCase changed = subject;
      if (!inject(defect, changed, seed)) continue;
      ++places;
      const Certificate certificate = check(changed.pslg, changed.mesh, changed.goal);
      EXPECT_FALSE(certificate.valid) << defect.name << " in " << subject.name << ", seed " << seed;
      EXPECT_GT(count(certificate, defect.expected), 0u)
          << defect.name << " in " << subject.name << ", seed " << seed << ": expected " << name(defect.expected)
          << ", found " << report(certificate);
    }
  }
  EXPECT_GT(places, 0u) << defect.name << ": no mesh offered a place";
  return places;
}

template <ViolationKind kind>
void reports(properties::Facts& facts) {
  for (const defects::Defect& defect : defects::all())
    if (defect.expected == kind) facts.cases += expect_verdict(defect);
  EXPECT_GT(facts.cases, 0U);
}

/// Areas differ only if something else is wrong, too. Therefore no defect has this kind.
template <>
void reports<ViolationKind::area_mismatch>(properties::Facts& facts) {
  Subject square = subjects().front();
  square.mesh.triangles[0].v = square.mesh.triangles[1].v;
  EXPECT_GT(count(check(square.pslg, square.mesh, square.goal), ViolationKind::area_mismatch), 0U);
  ++facts.cases;
}

/// The bound on circumradii is an option of the check, not part of a goal.
template <>
void reports<ViolationKind::large_circumradius>(properties::Facts& facts) {
  for (const Subject& subject : subjects()) {
    const double largest = check(subject.pslg, subject.mesh, subject.goal).max_circumradius.value;
    CheckOptions options;
    options.max_circumradius = largest * (1 - 0x1p-40);
    EXPECT_EQ(count(check(subject.pslg, subject.mesh, subject.goal, options), ViolationKind::large_circumradius) > 0,
              true)
        << subject.name;
    ++facts.cases;
  }
}

/// Chains that are wrong within rounding need a domain of their own, so no defect has these kinds.
void reports_in_wrong_meshes(ViolationKind kind, properties::Facts& facts) {
  for (const wrong_meshes::Kind& wrong : wrong_meshes::all()) {
    if (wrong.is_right() || wrong.expected.front() != kind) continue;
    // Some of these meshes may be reported by another kind, for example where no chain is left.
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
      const auto made = wrong_meshes::make(wrong, seed);
      if (made && count(check(made->pslg, made->mesh, made->goal, made->options), kind) > 0) ++facts.cases;
    }
  }
  EXPECT_GT(facts.cases, 0U);
}
template <>
void reports<ViolationKind::chains_meet>(properties::Facts& facts) {
  reports_in_wrong_meshes(ViolationKind::chains_meet, facts);
}
template <>
void reports<ViolationKind::wrong_chain_order>(properties::Facts& facts) {
  reports_in_wrong_meshes(ViolationKind::wrong_chain_order, facts);
}
template <>
void reports<ViolationKind::wrong_face>(properties::Facts& facts) {
  reports_in_wrong_meshes(ViolationKind::wrong_face, facts);
}

template <ViolationKind kind>
properties::Statement statement_about() {
  static const std::string text = "every seeded defect that makes a mesh wrong by " + std::string(name(kind)) +
                                  " is reported as that, wherever it is";
  return {text.c_str(), "properties/defects/defects.hpp", defective_meshes};
}
template <>
properties::Statement statement_about<ViolationKind::area_mismatch>() {
  return {"a mesh in which one triangle stands in the place of another is reported as area_mismatch",
          "properties/checker/check.hpp", "the mesh of a square"};
}
template <>
properties::Statement statement_about<ViolationKind::large_circumradius>() {
  return {"a correct mesh is reported as large_circumradius if circumradii are bounded by 1 - 2^-40 of its largest",
          "properties/checker/check.hpp", "the eleven meshes that the defects are put into"};
}

/// One property per kind of violation, Checker.reports_KIND.
template <>
properties::Statement statement_about<ViolationKind::chains_meet>() {
  return {"chains that meet where their segments do not are reported as chains_meet",
          "properties/wrong_meshes/pinched_chains.cpp", "wrong meshes at all scales"};
}
template <>
properties::Statement statement_about<ViolationKind::wrong_chain_order>() {
  return {"chains in another order around an input point than their segments are reported as wrong_chain_order",
          "properties/wrong_meshes/orders.cpp", "wrong meshes at all scales"};
}
template <>
properties::Statement statement_about<ViolationKind::wrong_face>() {
  return {"a part of the domain on another side of a chain than of its segment is reported as wrong_face",
          "properties/wrong_meshes/changed_sides.cpp", "wrong meshes at all scales"};
}

template <ViolationKind kind>
class Verdict : public testing::Test {
  void TestBody() override { properties::check_fact(statement_about<kind>(), &reports<kind>); }
};

template <ViolationKind kind>
void add_verdict() {
  testing::RegisterTest("Checker", ("reports_" + std::string(name(kind))).c_str(), nullptr, nullptr, __FILE__, __LINE__,
                        []() -> testing::Test* { return new Verdict<kind>; });
}
template <std::size_t... kinds>
bool add_verdicts(std::index_sequence<kinds...> /*of all kinds*/) {
  (add_verdict<static_cast<ViolationKind>(kinds)>(), ...);
  return true;
}
const bool verdicts_are_added = add_verdicts(std::make_index_sequence<violation_kinds>());

/// Fails if `made` is not one change or if it goes beyond the target. Returns the fields that changed.
defects::Fields expect_within(const defects::Target& target, const std::map<defects::Field, std::size_t>& made) {
  defects::Fields fields;
  for (const auto& [field, entries] : made) {
    if (field == defects::Field::neighbours && target.fields.has(defects::Field::corners)) continue;
    fields = fields | field;
    EXPECT_TRUE(target.fields.has(field)) << "field " << static_cast<unsigned>(field) << " is not a target";
    EXPECT_LE(entries, target.entries) << "in field " << static_cast<unsigned>(field);
  }
  EXPECT_NE(fields, defects::Fields()) << "nothing has changed";
  return fields;
}

PARDEL_FACT(
    Defects, change_their_targets_only_and_nothing_where_they_find_no_place,
    {.statement = "every seeded defect changes the fields that it names, in at most as many entries as it says, "
                  "and no other field; where a mesh has no suitable place, it changes nothing",
     .source = "properties/defects/target.hpp",
     .families = defective_meshes}) {
  for (const defects::Defect& defect : defects::all()) {
    defects::Fields changed_somewhere;
    for (const Subject& subject : subjects())
      for (const std::uint64_t seed : seeds) {
        SCOPED_TRACE(std::string(defect.name) + " in " + subject.name + ", seed " + std::to_string(seed));
        defects::MeshedCase changed = subject;
        const bool injected = inject(defect, changed, seed);
        const auto made = defects::changes(subject, changed);
        if (injected)
          changed_somewhere = changed_somewhere | expect_within(defect.target, made);
        else
          EXPECT_TRUE(made.empty() && changed.pslg == subject.pslg && changed.mesh == subject.mesh);
        ++facts.cases;
      }
    EXPECT_EQ(changed_somewhere, defect.target.fields) << defect.name << ": some field of its target never changes";
  }
}

class SeededDefect : public testing::TestWithParam<std::size_t> {};

TEST_P(SeededDefect, is_the_same_for_the_same_seed) {
  const defects::Defect& defect = defects::all()[GetParam()];
  for (const Subject& subject : subjects()) {
    defects::MeshedCase one = subject, other = subject;
    EXPECT_EQ(inject(defect, one, 5), inject(defect, other, 5));
    EXPECT_EQ(one.pslg, other.pslg) << subject.name;
    EXPECT_EQ(one.mesh.triangles, other.mesh.triangles) << subject.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Defects, SeededDefect, testing::Range<std::size_t>(0, defects::all().size()),
                         [](const auto& instance) { return identifier(defects::all()[instance.param].name); });

TEST(Defects, are_at_least_seventy_and_each_has_its_own_name) {
  std::set<std::string> names;
  for (const defects::Defect& defect : defects::all())
    EXPECT_TRUE(names.insert(identifier(defect.name)).second) << defect.name;
  EXPECT_GE(names.size(), 70u);
}

}  // namespace
}  // namespace pardel
