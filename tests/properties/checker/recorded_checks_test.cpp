// The checker finds in thousands of meshes with mistakes the violations that were recorded as fingerprints. The
// mistakes are random changes of all arrays of a mesh, of its domain, of the goal and of the options. After a change
// that is meant to change a verdict, take over the value that the test shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "../../../core/neighbours.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/checker/statistics.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/goals.hpp"
#include "../../fingerprint.hpp"
#include "numbers_in_sentences.hpp"

namespace pardel {
namespace {

/// A certificate without the number of triangles that exact arithmetic decided: it depends on the filters.
std::string without_count(std::string json) {
  const std::size_t begin = json.find("  \"decided_exactly\""), end = json.find('\n', begin) + 1;
  return json.erase(begin, end - begin);
}

using generators::Random;
using pardel::testing::Fingerprint;

struct Subject {
  Pslg pslg;
  Mesh mesh;
  Goal goal;
  CheckOptions options;
};

/// The text without its numbers. Some numbers are measured, and functions of libraries differ in the last digit.
std::string words(const std::string& text) {
  std::string rest;
  for (const char c : text)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '+' && c != 'e') rest += c;
  return rest;
}

std::string to_eight_digits(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.8g", value);
  return digits;
}

void add(Fingerprint& all, const Certificate& c) {
  testing::expect_numbers_of_files(c);
  all.add_all(c.valid, c.cancelled, c.vertices, c.triangles, c.constrained_edges, c.region_caps);
  // Names, not numbers: a new kind of violation changes no fingerprint.
  for (std::size_t kind = 0; kind < violation_kinds; ++kind)
    if (c.violation_counts[kind] > 0)
      all.add_all(std::string(name(static_cast<ViolationKind>(kind))), c.violation_counts[kind]);
  for (const Violation& v : c.violations) all.add_all(std::string(name(v.kind)), v.ids, v.where, words(v.message()));
  for (const Justified& j : c.justified)
    all.add_all(j.triangle, j.apex, to_eight_digits(j.input_angle_deg), to_eight_digits(j.angle_deg));
  for (const Extreme& e : {c.min_angle_deg, c.max_angle_deg, c.max_area, c.max_edge, c.min_edge, c.max_circumradius,
                           c.max_radius_edge_ratio})
    all.add_all(to_eight_digits(e.value), e.triangle == no_index);
  all.add_all(c.digest.high, c.digest.low, words(to_text(c)), words(without_count(to_json(c))));
}

/// Any of the points, triangles and so on. Precondition: there are some.
template <class Values>
auto& any(Random& random, Values& values) {
  return values[random.below(values.size())];
}

Index any_index(Random& random, std::size_t size) {
  return random.chance(8) ? no_index : static_cast<Index>(random.below(size + 1));
}

Index any_origin(Random& random) {
  const Index segment = any_index(random, 9);
  return segment == no_index ? input_vertex : origin_on_segment(segment);
}

/// A random change of a mesh.
void change(Mesh& mesh, Random& random) {
  switch (random.below(16)) {
    case 0: {
      Point& p = any(random, mesh.points);
      const Point q = any(random, mesh.points);
      p = random.chance(2) ? q : Point{(p.x + q.x) / 2, (p.y + q.y) / 2};
      return;
    }
    case 1:
      any(random, mesh.points).x += std::ldexp(1.0, -random.between(3, 50));
      return;
    case 2:
      any(random, mesh.points).y = random.chance(2) ? NAN : INFINITY;
      return;
    case 3:
      any(random, any(random, mesh.triangles).v) = any_index(random, mesh.points.size());
      return;
    case 4: {
      Point& p = any(random, mesh.points);
      p = {2 * p.x, 2 * p.y};
      return;
    }
    case 5: {
      auto& v = any(random, mesh.triangles).v;
      std::swap(v[0], v[1]);
      return;
    }
    case 6:
      any(random, any(random, mesh.triangles).n) = any_index(random, mesh.triangles.size());
      return;
    case 7: {
      any(random, mesh.triangles) = mesh.triangles[mesh.triangles.size() - 1];
      return;
    }
    case 8: {
      mesh.triangles.pop_back();
      if (!mesh.region.empty()) mesh.region.pop_back();
      return;
    }
    case 9:
      if (!mesh.region.empty()) any(random, mesh.region) = any_index(random, mesh.region_attributes.size());
      return;
    case 10:
      if (!mesh.origin.empty()) any(random, mesh.origin) = random.chance(2) ? interior_vertex : any_origin(random);
      return;
    case 11:
      if (!mesh.point_markers.empty()) any(random, mesh.point_markers) += random.between(-2, 2);
      return;
    case 12:
      if (!mesh.constrained_edges.empty()) any(random, mesh.constrained_edges).marker += random.between(-1, 2);
      return;
    case 13:
      if (mesh.constrained_edges.empty()) return;
      (random.chance(2) ? any(random, mesh.constrained_edges).a : any(random, mesh.constrained_edges).b) =
          any_index(random, mesh.points.size());
      return;
    case 14:
      if (mesh.constrained_edges.empty()) return;
      mesh.constrained_edges.erase(mesh.constrained_edges.begin() +
                                   static_cast<std::ptrdiff_t>(random.below(mesh.constrained_edges.size())));
      return;
    default:
      if (mesh.constrained_edges.empty()) return;
      any(random, mesh.constrained_edges).segment = any_index(random, 12);
  }
}

/// A random change of a goal.
void change(Goal& goal, const Mesh& mesh, Random& random) {
  const Point p = any(random, mesh.points);
  switch (random.below(9)) {
    case 0:
      goal.min_angle_deg = random.between(0, 60);
      return;
    case 1:
      goal.max_area = std::ldexp(1.0, random.between(-14, 2));
      return;
    case 2:
      goal.max_edge = std::ldexp(1.0, random.between(-6, 3));
      return;
    case 3:
      goal.region_caps = !goal.region_caps;
      return;
    case 4:
      goal.conforming = !goal.conforming;
      return;
    case 5:
      goal.convex_hull = !goal.convex_hull;
      return;
    case 6:
      goal.grading = 0.125 * random.between(1, 12);
      return;
    case 7:
      goal.feature_edges = random.between(1, 3);
      return;
    default:
      goal.size = [p](Point q) {
        if (q.x > p.x + 1) throw std::runtime_error("no size");
        return q.y - p.y + 0.25;
      };
  }
}

/// A random change of a domain.
void change(Pslg& pslg, Random& random) {
  switch (random.below(10)) {
    case 0:
      any(random, pslg.points).x += std::ldexp(1.0, -random.between(1, 50));
      return;
    case 1:
      pslg.points.push_back(any(random, pslg.points));
      return;
    case 2:
      pslg.points.pop_back();
      return;
    case 3:
      if (!pslg.segments.empty()) any(random, pslg.segments).a = any_index(random, pslg.points.size());
      return;
    case 4:
      if (!pslg.segments.empty()) any(random, pslg.segments).marker += random.between(-1, 3);
      return;
    case 5:
      if (!pslg.segments.empty()) pslg.segments.pop_back();
      return;
    case 6: {
      const Point p = any(random, pslg.points), q = any(random, pslg.points);
      pslg.holes.push_back({0.625 * p.x + 0.375 * q.x, 0.625 * p.y + 0.375 * q.y});
      return;
    }
    case 7:
      if (!pslg.point_markers.empty()) any(random, pslg.point_markers) += 1;
      return;
    case 8:
      if (!pslg.point_attributes.empty()) any(random, pslg.point_attributes) += 1;
      return;
    default: {
      const Point p = any(random, pslg.points), q = any(random, pslg.points);
      pslg.regions.push_back({{0.625 * p.x + 0.375 * q.x, 0.625 * p.y + 0.375 * q.y}, 5, 0.125});
    }
  }
}

/// Some arrays may be absent in a foreign mesh.
void forget_arrays(Mesh& mesh, Random& random) {
  if (random.chance(2)) mesh.origin = {};
  if (random.chance(3)) mesh.region = {};
  if (random.chance(3)) mesh.point_markers = {};
  if (random.chance(3)) mesh.constrained_edges.clear();
  if (random.chance(3)) {
    mesh.attributes_per_point = 0;
    mesh.point_attributes = {};
  }
  if (random.chance(2))
    for (Triangle& triangle : mesh.triangles) triangle.n = {no_index, no_index, no_index};
}

/// The verdicts on a mesh with many changes.
std::string verdicts(const Subject& subject, int changes, std::uint64_t seed) {
  Fingerprint all;
  add(all, check(subject.pslg, subject.mesh, subject.goal, subject.options));
  for (int i = 0; i < changes; ++i) {
    Random random(1000 * seed + static_cast<std::uint64_t>(i));
    Subject other = subject;
    if (random.chance(3)) {
      other.options.foreign = true;
      forget_arrays(other.mesh, random);
    }
    if (random.chance(8)) other.options.max_circumradius = std::ldexp(1.0, random.between(-6, 3));
    if (random.chance(4)) other.options.max_violations = random.below(4);
    const std::uint64_t what = random.below(4);
    for (int k = random.between(1, 2); k > 0; --k) {
      if (what <= 1) change(other.mesh, random);
      if (what == 2) change(other.goal, other.mesh, random);
      if (what == 3) change(other.pslg, random);
    }
    add(all, check(other.pslg, other.mesh, other.goal, other.options));
  }
  return all.text();
}

Pslg with_data(Pslg pslg) {
  pslg.attributes_per_point = 1;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    pslg.point_attributes.push_back(static_cast<double>(i % 3));
    pslg.point_markers.push_back(static_cast<int>(i % 4));
  }
  return pslg;
}

template <class Values>
Values permuted(const Values& values, const std::vector<Index>& order) {
  Values result;
  for (const Index i : order)
    if (!values.empty()) result.push_back(values[i]);
  return result;
}

/// The mesh with a numbering that depends on its coordinates only, not on the work of the mesher. Points of the input
/// keep their numbers.
Mesh renumbered(Mesh mesh, std::size_t inputs) {
  std::vector<Index> vertices(mesh.points.size()), number(mesh.points.size()), triangles(mesh.triangles.size());
  std::iota(vertices.begin(), vertices.end(), Index{0});
  std::sort(vertices.begin() + static_cast<std::ptrdiff_t>(inputs), vertices.end(), [&](Index a, Index b) {
    return std::pair(mesh.points[a].x, mesh.points[a].y) < std::pair(mesh.points[b].x, mesh.points[b].y);
  });
  for (Index i = 0; i < vertices.size(); ++i) number[vertices[i]] = i;
  std::vector<double> attributes;
  for (const Index v : vertices)
    for (std::size_t k = 0; k < mesh.attributes_per_point; ++k)
      attributes.push_back(mesh.point_attributes[v * mesh.attributes_per_point + k]);
  mesh.points = permuted(mesh.points, vertices);
  mesh.origin = permuted(mesh.origin, vertices);
  mesh.point_markers = permuted(mesh.point_markers, vertices);
  mesh.point_attributes = Array<double>(std::span<const double>(attributes));
  for (Triangle& triangle : mesh.triangles) {
    for (Index& v : triangle.v) v = number[v];
    std::rotate(triangle.v.begin(), std::ranges::min_element(triangle.v), triangle.v.end());
  }
  std::iota(triangles.begin(), triangles.end(), Index{0});
  std::ranges::sort(triangles, {}, [&](Index t) { return mesh.triangles[t].v; });
  mesh.triangles = permuted(mesh.triangles, triangles);
  mesh.region = permuted(mesh.region, triangles);
  rebuild_neighbours(mesh.triangles, mesh.points.size());
  for (ConstrainedEdge& edge : mesh.constrained_edges)
    std::tie(edge.a, edge.b) = std::minmax({number[edge.a], number[edge.b]});
  std::ranges::sort(mesh.constrained_edges, {}, [](const ConstrainedEdge& e) { return std::pair(e.a, e.b); });
  return mesh;
}

Subject meshed(const Pslg& pslg, const Goal& goal) {
  Result<Meshed> made = mesh(pslg, goal, {.threads = 1, .max_vertices = 250});
  EXPECT_TRUE(made) << made.error().message;
  return {pslg, renumbered(std::move(made->mesh), pslg.points.size()), goal, {}};
}

TEST(RecordedChecks, of_named_domains_with_mistakes_have_the_same_verdicts) {
  const std::vector<Subject> subjects{
      meshed(domains::square(), {.max_area = 0.05}),
      meshed(with_data(domains::regions()), {.max_area = 0.05}),
      meshed(with_data(domains::touching_holes()), {}),
      meshed(domains::cracks(), {.conforming = true}),
      meshed(domains::cracks(), {.max_area = 0.5, .convex_hull = true}),
      meshed(domains::wedge(5, 12), {}),
      meshed(domains::star(5, 20), {}),
      meshed(with_data(domains::comb(3, 0.05)), {}),
      meshed(domains::random_points(25, 1), {}),
      meshed(domains::grid_points(3), {.max_area = 0.3}),
  };
  std::vector<std::string> found;
  for (std::size_t i = 0; i < subjects.size(); ++i) found.push_back(verdicts(subjects[i], 220, i));
  EXPECT_EQ(found,
            (std::vector<std::string>{"ebf565109a85e090", "13317ea6e623f6de", "75b97cd643a6cb43", "88a4db5047e14fc8",
                                      "25f9d997670b9c7f", "d050f1a2ffe86a20", "1741168c83f5db1c", "6afeba16c49a0597",
                                      "85cc09d4c8147d19", "aee233040a64ce2a"}));
}

TEST(RecordedChecks, of_random_domains_with_mistakes_have_the_same_verdicts) {
  std::vector<std::string> found;
  for (const generators::Family family : generators::all_families()) {
    Fingerprint all;
    for (std::uint64_t number = 0; number < 3; ++number) {
      Random random(number);
      const generators::LatticeDomain domain = generators::generate(family, random, static_cast<int>(15 * number));
      generators::LatticeGoal goal = generators::any_goal(domain, random);
      if (number > 0) goal.max_area = INFINITY;
      const Pslg pslg = to_pslg(domain);
      all.add(verdicts(meshed(number == 1 ? with_data(pslg) : pslg, to_goal(goal, domain)), 70, number));
    }
    found.push_back(all.text());
  }
  EXPECT_EQ(found,
            (std::vector<std::string>{"f88e23e155a8e0d4", "0c6694bda4f06712", "ecb3f0a87dc04fc1", "fbf8d7c43c95cbb9",
                                      "e0a59da0a1ff8699", "c4fe1a93f0317207", "195a8a9c34a7312c", "0cd6cbc347816ed6",
                                      "ee2849071978b4c9", "57aabf28522c2fc0", "37f8263907d56f51"}));
}

}  // namespace
}  // namespace pardel
