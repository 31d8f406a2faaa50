#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "../../../core/formats.hpp"
#include "../../../parallel/validate.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/goals.hpp"
#include "../../../properties/domains/generators/lattice_domain.hpp"
#include "run_record.hpp"

namespace pardel::recorded {
namespace {

using generators::Random;

Options with_cells(Index columns, Index rows, Decomposition decomposition = Decomposition::automatic) {
  Options options{.decomposition = decomposition};
  options.cells = {columns, rows};
  return options;
}

/// Sizes that grow with the distance from a point.
std::function<double(Point)> growing_from(Point centre, double least, double slope) {
  return [=](Point p) {
    const double x = p.x - centre.x, y = p.y - centre.y;
    return least + slope * std::sqrt(x * x + y * y);
  };
}

/// Two attributes that vary over the plane, and markers.
Pslg with_point_data(Pslg pslg) {
  pslg.attributes_per_point = 2;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) {
    pslg.point_attributes.push_back(pslg.points[i].x - 2 * pslg.points[i].y);
    pslg.point_attributes.push_back(static_cast<double>(i % 7));
    pslg.point_markers.push_back(static_cast<int>(i % 5));
  }
  return pslg;
}

/// A domain of its own group.
struct Named {
  std::string name;
  Pslg pslg;
  Goal goal;
  Options options;
};

std::vector<Named> named() {
  using domains::cracks;
  const Goal small{.max_area = 0.00035};
  std::vector<Named> all{
      {"square in a lattice", domains::square(), small, with_cells(5, 5)},
      {"square in one tile", domains::square(), small, {.decomposition = Decomposition::none}},
      {"square in columns", domains::square(), small, with_cells(9, 1)},
      {"square in the paper's lattice", domains::square(), small, with_cells(6, 5, Decomposition::paper)},
      {"square by circumcentres", domains::square(), small, {.placement = Placement::circumcentre}},
      {"square of short edges", domains::square(), {.max_edge = 0.05}, with_cells(3, 4)},
      {"square in a quadtree",
       domains::square(),
       {.size = growing_from({0, 0}, 0.004, 0.1)},
       {.decomposition = Decomposition::quadtree, .triangles_per_tile = 40}},
      {"square of uneven work",
       domains::square(),
       {.size = growing_from({0.3, 0.7}, 0.0005, 0.2)},
       {.triangles_per_tile = 30}},
      {"square of nearly even work",
       domains::square(),
       {.size = growing_from({0.5, 0.5}, 0.03, 0.01)},
       {.triangles_per_tile = 30}},
      {"square of few vertices", domains::square(), {.min_angle_deg = 40, .max_area = 1e-4}, {.max_vertices = 700}},
      {"square of long edges", domains::square(), small, {.min_edge = 0.03}},
      {"square of little memory", domains::square(), {.max_area = 1e-4}, {.max_memory = 300'000}},
      {"square of too little memory", domains::square(), {.max_area = 1e-9}, {.max_memory = 300'000}},
      {"pipe in a lattice", with_point_data(domains::pipe()), {.min_angle_deg = 25}, with_cells(7, 8)},
      {"pipe in the paper's lattice", domains::pipe(), {.min_angle_deg = 20.7}, with_cells(9, 9, Decomposition::paper)},
      {"pipe with grading", domains::pipe(), {.grading = 0.3}, {.triangles_per_tile = 100}},
      {"pipe without splits of its boundary", domains::pipe(), {.max_area = 0.01}, {.no_boundary_splits = true}},
      {"key with features", domains::key(), {.feature_edges = 3}, {.triangles_per_tile = 100}},
      {"key with features and grading", domains::key(), {.min_angle_deg = 28, .grading = 0.5, .feature_edges = 1}, {}},
      {"key", with_point_data(domains::key()), {.min_angle_deg = 30}, with_cells(6, 3)},
      {"comb with features", domains::comb(5, 0.01), {.feature_edges = 2}, {}},
      {"comb", domains::comb(4, 1e-3), {}, {}},
      {"comb with tiny gaps", domains::comb(3, 1e-9), {.min_angle_deg = 0, .max_area = 0.01}, {}},
      {"conforming cracks", cracks(), {.min_angle_deg = 30, .max_area = 0.005, .conforming = true}, with_cells(3, 3)},
      {"cracks without splits", cracks(), {.max_area = 0.01}, {.no_segment_splits = true}},
      {"cracks in their hull", cracks(), {.max_area = 0.02, .convex_hull = true}, {}},
      {"far cracks",
       domains::moved(cracks(), 654321, 4987654),
       {.min_angle_deg = 25, .max_area = 0.005},
       with_cells(3, 3)},
      {"wedge", domains::wedge(12, 7), {.min_angle_deg = 28, .max_area = 0.005}, with_cells(3, 4)},
      {"narrow wedge", domains::wedge(5, 0.3), {.max_area = 0.01}, {}},
      {"star", domains::star(7, 9), {.min_angle_deg = 25, .max_area = 0.002}, with_cells(4, 4)},
      {"star with grading", domains::star(9, 30), {.grading = 0.2, .feature_edges = 1}, {}},
      {"regions", with_point_data(domains::regions()), {.region_caps = true}, with_cells(6, 2)},
      {"regions without caps", domains::regions(), {.min_angle_deg = 15}, {}},
      {"touching holes", domains::touching_holes(), {.max_area = 0.001}, with_cells(4, 4)},
      {"points", domains::random_points(300, 3), {.min_angle_deg = 30}, with_cells(8, 8)},
      {"points in the paper's lattice",
       domains::random_points(600, 4),
       {.max_area = 1e-3},
       with_cells(20, 20, Decomposition::paper)},
      {"clustered points", domains::clustered_points(400, 5), {}, {.triangles_per_tile = 60}},
      {"points near a line", domains::line_points(300, 6), {}, {.triangles_per_tile = 60}},
      {"points around the origin", domains::kuzmin_points(300, 7), {}, {.triangles_per_tile = 60}},
      {"lattice", domains::grid_points(9), {.max_area = 0.026}, with_cells(4, 4)},
      {"grid", domains::grid(6), {.max_area = 0.1}, with_cells(3, 3)},
      {"rings", domains::radial(3), {}, {.triangles_per_tile = 50}},
      {"pipe in its hull", domains::pipe(), {.min_angle_deg = 5, .convex_hull = true}, {}},
      {"comb with many teeth", domains::comb(300, 1e-3), {.min_angle_deg = 0}, {}},
      {"large grid", domains::grid(22), {.min_angle_deg = 0}, {}},
      {"many points", with_point_data(domains::random_points(2500, 8)), {.min_angle_deg = 0}, {}},
  };
  const Options fill{.interior = Interior::fill, .triangles_per_tile = 100};
  all.insert(all.end(), {{"filled square", domains::square(), {.max_area = 1e-3}, fill},
                         {"filled square of short edges", domains::square(), {.max_edge = 0.06}, fill},
                         {"filled pipe", with_point_data(domains::pipe()), {.max_area = 2e-3}, fill},
                         {"filled key", domains::key(), {.min_angle_deg = 25, .max_area = 0.01}, fill},
                         {"filled key without room", domains::key(), {.max_area = 10}, fill},
                         {"filled regions", with_point_data(domains::regions()), {.region_caps = true}, fill},
                         {"filled cracks", cracks(), {.max_area = 0.01}, fill},
                         {"filled far cracks", domains::moved(cracks(), 654321, 4987654), {.max_area = 0.02}, fill},
                         {"filled hull of points", domains::random_points(9, 4), {.max_area = 1e-3}, fill},
                         {"filled touching holes", domains::touching_holes(), {.max_area = 0.01}, fill},
                         {"filled star", domains::star(5, 40), {.max_area = 0.002}, fill}});
  Goal sources{.grading = 0.25};
  sources.sources = {{{0.2, 0.3}, {0.8, 0.3}, 0.02, 0.1}, {{0.5, 0.9}, {0.5, 0.9}, 0.01, 0.01}};
  all.push_back({"square with sources", domains::square(), sources, {.triangles_per_tile = 50}});
  return all;
}

std::string group_of(generators::Family family) { return std::string("family ") + generators::name(family); }

/// Domains of a family, with random goals and options.
void add_random_runs(generators::Family family, std::vector<Run>& all) {
  for (std::uint64_t number = 0; number < 24; ++number) {
    Random random(1000 * number + static_cast<std::uint64_t>(family));
    const generators::LatticeDomain domain = generators::generate(family, random, static_cast<int>(4 * number + 5));
    const std::string group = group_of(family);
    Run run{group,
            group + " " + std::to_string(number),
            to_pslg(domain),
            generators::to_goal(generators::any_goal(domain, random), domain),
            {},
            true};
    if (random.chance(2)) run.pslg = with_point_data(std::move(run.pslg));
    run.options.triangles_per_tile = static_cast<std::uint32_t>(random.between(8, 60));
    if (random.chance(3)) run.options.decomposition = Decomposition::paper;
    if (random.chance(3)) run.options.placement = Placement::circumcentre;
    if (random.chance(4)) run.options.no_boundary_splits = true;
    if (random.chance(4)) {
      const auto [left, right] = std::ranges::minmax(run.pslg.points, {}, &Point::x);
      run.goal.size = growing_from(left, (right.x - left.x) / 64, 0.125 * random.between(1, 4));
    }
    if (random.chance(4)) run.options.interior = Interior::fill;
    if (random.chance(6)) run.goal.grading = 0.125 * random.between(1, 8);
    if (random.chance(6)) run.goal.feature_edges = random.between(1, 3);
    run.options.max_vertices = 3000;
    all.push_back(std::move(run));
  }
}

/// A closed curve around the origin. Coordinates are rounded, because the last bit of a sine differs between platforms.
void add_curve(Pslg& pslg, int vertices, double radius, double depth, int waves) {
  const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(vertices);
  const auto rounded = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
  for (Index i = 0; i < n; ++i) {
    const double turn = 2 * std::numbers::pi * i / vertices, r = radius * (1 + depth * std::cos(waves * turn));
    pslg.points.push_back({rounded(r * std::cos(turn)), rounded(r * std::sin(turn))});
    pslg.segments.push_back({first + i, first + (i + 1) % n});
  }
}

/// Rings between two curves, with edges across narrow places.
void add_runs_on_curves(std::vector<Run>& all) {
  for (int number = 0; number < 24; ++number) {
    Random random(static_cast<std::uint64_t>(number));
    Run run{"curves", "curves " + std::to_string(number), {}, {}, {.triangles_per_tile = 60}, true};
    for (const double radius : {2.0, 0.7}) {
      const int vertices = random.between(3, radius > 1 ? 90 : 40);
      const double depth = 0.0625 * random.between(0, 5);
      add_curve(run.pslg, vertices, radius, depth, random.between(1, 6));
    }
    run.pslg.holes = {{0, 0}};
    if (random.chance(2)) {  // an open chain in the ring
      const auto first = static_cast<Index>(run.pslg.points.size());
      for (Index i = 0; i < 8; ++i) run.pslg.points.push_back({0.0625 * i * i - 1, 1.2 + 0.03125 * (i % 3)});
      for (Index i = 0; i + 1 < 8; ++i) run.pslg.segments.push_back({first + i, first + i + 1});
    }
    if (random.chance(2)) run.goal.grading = 0.125 * random.between(1, 6);
    run.goal.feature_edges = random.between(1, 2);
    run.options.max_vertices = 3000;
    if (find_problems(run.pslg).empty()) all.push_back(std::move(run));
  }
}

/// Corners of all kinds of small angles.
void add_runs_on_small_angles(std::vector<Run>& all) {
  const auto add = [&](const std::string& group, const std::string& name, const Pslg& pslg) {
    for (const bool fine : {false, true}) {
      const Goal goal{.min_angle_deg = fine ? 30 : 20.7, .max_area = fine ? 0.01 : INFINITY};
      Options options{.triangles_per_tile = 60, .max_vertices = 2500};
      if (fine) options.placement = Placement::circumcentre;
      all.push_back({group, name + (fine ? " fine" : ""), pslg, goal, options, true});
    }
  };
  int number = 0;
  for (const double degrees : {0.002, 0.05, 0.4, 0.9, 1.1, 5.0, 14.0, 29.0, 45.0, 59.0, 61.0})
    for (const int segments : {2, 3, 5})
      add(degrees < 1 ? "narrow corners" : "small angles", "angles " + std::to_string(number++),
          domains::wedge(segments, degrees));
  for (const double degrees : {0.05, 0.7, 2.0, 40.0})
    for (const int spikes : {3, 8}) add("spikes", "spikes " + std::to_string(number++), domains::star(spikes, degrees));
  // Segments of different lengths that end in narrow corners on both sides.
  for (const double height : {1e-5, 1e-3, 0.05, 0.4}) {
    Pslg pslg;
    pslg.points = {{0, 0}, {1, height}, {3, 0}, {1.5, -height / 3}, {7, 5}, {-4, 5}, {-4, -5}, {7, -5}};
    pslg.segments = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
    add("lenses", "lens " + std::to_string(number++), pslg);
  }
}

std::string group_of_regressions(double degrees) { return "regressions " + std::to_string(std::lround(degrees)); }

/// The domains of earlier mistakes.
void add_regressions(std::vector<Run>& all) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(PARDEL_REGRESSIONS))
    if (entry.path().extension() == ".poly") files.push_back(entry.path());
  std::ranges::sort(files);
  for (const auto& file : files)
    for (const double degrees : {20.7, 30.0}) {
      const std::string name = file.stem().string() + " " + std::to_string(std::lround(degrees));
      const Goal goal{.min_angle_deg = degrees, .conforming = degrees > 25};
      const Options options{.triangles_per_tile = 60, .max_vertices = 2500};
      all.push_back({group_of_regressions(degrees), name, read_pslg(file).value(), goal, options, true});
    }
}

/// Random points on a small lattice, some of them twice, and segments between them, in a square.
Pslg tangle(std::uint64_t seed) {
  Random random(seed);
  const int side = random.between(3, 30);
  const double unit = std::array{1.0, 0.1, 1.0 / 3, 1e-3}[seed % 4];
  Pslg pslg;
  const auto add = [&](double x, double y) { pslg.points.push_back({x * unit, y * unit}); };
  for (int i = random.between(3, 25); i > 0; --i) {
    const int x = random.between(1, side), y = random.between(1, side);
    add(x, y);
  }
  const auto n = pslg.points.size();
  for (int i = random.between(2, 20); i > 0; --i)
    pslg.segments.push_back({static_cast<Index>(random.below(n)), static_cast<Index>(random.below(n)), i % 4});
  const auto first = static_cast<Index>(n);
  add(0, 0);
  add(side + 1, 0);
  add(side + 1, side + 1);
  add(0, side + 1);
  for (Index i = 0; i < 4; ++i) pslg.segments.push_back({first + i, first + (i + 1) % 4, 9});
  for (int i = random.between(0, 3); i > 0; --i)
    pslg.holes.push_back({random.between(0, side) * unit + 0.1 * unit, random.between(0, side) * unit});
  for (int i = random.between(0, 4); i > 0; --i)
    pslg.regions.push_back({{random.between(0, side) * unit, random.between(0, side) * unit + 0.2 * unit}, double(i)});
  if (seed % 3 == 0) pslg = with_point_data(std::move(pslg));
  pslg.first_id = {static_cast<int>(seed % 2)};
  pslg.has_segment_markers = true;
  return pslg;
}

/// Many nearly parallel segments far from the origin, whose crossings are rounded to points beside them.
Pslg bundle(std::uint64_t seed) {
  Random random(seed);
  Pslg pslg;
  const double unit = std::ldexp(1.0, -random.between(30, 38));
  const int segments = random.between(10, 40), wide = random.between(2, 400);
  for (int i = 0; i < segments; ++i) {
    const double left = unit * random.between(0, wide), right = unit * random.between(0, wide);
    const double slope = random.chance(5) ? 7 : 0;
    pslg.points.insert(pslg.points.end(),
                       {{1e3, 1e3 / 3 + left}, {1e3 + 0.1 * random.between(1, 9), 1e3 / 3 + slope * unit + right}});
    pslg.segments.push_back({static_cast<Index>(2 * i), static_cast<Index>(2 * i + 1), i});
  }
  const auto first = static_cast<Index>(pslg.points.size());
  pslg.points.insert(pslg.points.end(), {{999, 333}, {1002, 333}, {1002, 334}, {999, 334}});
  for (Index i = 0; i < 4; ++i) pslg.segments.push_back({first + i, first + (i + 1) % 4, 0});
  return pslg;
}

/// Two copies of a domain, one turned and moved a little, as from two projections.
Pslg twice(const Pslg& one, double distance) {
  Pslg both = one;
  const auto n = static_cast<Index>(one.points.size());
  for (const Point p : one.points) both.points.push_back({p.x + distance * (1 + p.y), p.y - distance * p.x});
  for (const Segment& s : one.segments) both.segments.push_back({s.a + n, s.b + n, s.marker});
  both.holes.clear();
  both.regions.clear();
  return both;
}

}  // namespace

const std::vector<Run>& runs() {
  static const std::vector<Run> all = [] {
    std::vector<Run> list;
    for (const Named& each : named()) list.push_back({each.name, each.name, each.pslg, each.goal, each.options});
    for (const generators::Family family : generators::all_families()) add_random_runs(family, list);
    add_runs_on_curves(list);
    add_runs_on_small_angles(list);
    add_regressions(list);
    return list;
  }();
  return all;
}

std::vector<std::string> groups_of_runs() {
  std::vector<std::string> groups;
  for (const Named& each : named()) groups.push_back(each.name);
  for (const generators::Family family : generators::all_families()) groups.push_back(group_of(family));
  groups.insert(groups.end(), {"curves", "narrow corners", "small angles", "spikes", "lenses",
                               group_of_regressions(20.7), group_of_regressions(30)});
  return groups;
}

namespace {
constexpr std::uint64_t bundles = 60, tangles = 200, tangles_per_group = 20;
std::string group_of_bundles(std::uint64_t number) { return "bundles " + std::to_string(number); }
std::string group_of_tangles(std::uint64_t number) { return "tangles " + std::to_string(number); }
}  // namespace

const std::vector<Cloud>& clouds() {
  static const std::vector<Cloud> all = [] {
    std::vector<Cloud> list;
    const auto add = [&](const std::string& name, const Pslg& pslg) { list.push_back({name, name, pslg.points}); };
    add("cloud", domains::random_points(3000, 1));
    add("cloud around the origin", domains::kuzmin_points(1500, 2));
    add("cloud near a line", domains::line_points(1500, 3));
    add("cloud of clusters", domains::clustered_points(1500, 4));
    add("cloud on a lattice", domains::grid_points(36));
    Pslg disk, diamond, line;
    for (const Point p : domains::random_points(20'000, 5).points) {
      const Point q{2 * p.x - 1, 2 * p.y - 1};
      if (q.x * q.x + q.y * q.y < 1) disk.points.push_back(q);
      diamond.points.push_back({q.x + q.y, q.x - q.y});
    }
    for (int i = 0; i < 2500; ++i) line.points.push_back({double(i * 7 % 2500), 3.0 * (i * 7 % 2500)});
    add("disk", disk);
    add("diamond", diamond);
    add("line", line);
    return list;
  }();
  return all;
}

std::vector<std::string> groups_of_clouds() {
  return {"cloud",
          "cloud around the origin",
          "cloud near a line",
          "cloud of clusters",
          "cloud on a lattice",
          "disk",
          "diamond",
          "line"};
}

const std::vector<Mess>& messes() {
  static const std::vector<Mess> all = [] {
    std::vector<Mess> list;
    for (std::uint64_t seed = 0; seed < tangles; ++seed)
      list.push_back(
          {group_of_tangles(seed / tangles_per_group), "tangle " + std::to_string(seed), tangle(seed), true});
    for (std::uint64_t seed = 0; seed < bundles; ++seed)
      list.push_back({group_of_bundles(seed / 15), "bundle " + std::to_string(seed), bundle(seed), true});
    const std::string group = "gaps";
    for (const double distance : {1e-12, 3e-10, 1e-7, 0.01}) {
      list.push_back({group, "two keys " + std::to_string(list.size()), twice(domains::key(), distance)});
      list.push_back({group, "two cracked squares " + std::to_string(list.size()), twice(domains::cracks(), distance)});
    }
    list.push_back({group, "comb with tiny gaps to close", domains::comb(3, 1e-10)});
    list.push_back({group, "regions without mistakes", domains::regions()});
    return list;
  }();
  return all;
}

std::vector<std::string> groups_of_messes() {
  std::vector<std::string> groups{"gaps"};
  for (std::uint64_t i = 0; i < bundles / 15; ++i) groups.push_back(group_of_bundles(i));
  for (std::uint64_t i = 0; i < tangles / tangles_per_group; ++i) groups.push_back(group_of_tangles(i));
  return groups;
}

}  // namespace pardel::recorded
