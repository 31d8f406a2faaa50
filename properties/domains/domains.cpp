#include "domains.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "generators/random.hpp"
#include "paths.hpp"

namespace pardel::domains {
namespace {

/// The key's outline, counter-clockwise from the lower end of the bow: along the lower side of the shaft to the bit,
/// around the tip, along the upper side of the shaft and around the bow. Lengths are in centimetres.
Path key_outline() {
  constexpr double shaft = 0.19;  // half the thickness of the shaft
  constexpr double bow = 1.0;     // the outer radius of the bow; its centre is the origin
  constexpr double fillet = 0.3;  // the radius of the fillet between bow and shaft
  // The circle of the fillet touches the bow from outside and the shaft from above or below.
  constexpr double fillet_y = shaft + fillet;
  const double fillet_x = std::sqrt((bow + fillet) * (bow + fillet) - fillet_y * fillet_y);
  const double root = std::atan2(fillet_y, fillet_x) * (180 / std::numbers::pi);
  // The collar: three half-round beads on the shaft.
  constexpr std::pair<double, double> beads[] = {{1.60, 0.12}, {1.96, 0.18}, {2.32, 0.12}};  // x, radius
  constexpr double bead_height = shaft + 0.06;  // where a bead's half circle begins

  Path path;
  path.arc({fillet_x, -fillet_y}, fillet, 180 - root, 90, 7);
  for (const auto& [x, radius] : beads)
    path.to(x - radius, -shaft).arc({x, -bead_height}, radius, 180, 360, 10).to(x + radius, -shaft);
  // The bit: a plate below the shaft, its steps cut for the levers, its sides slotted for the wards.
  path.arc({4.42, -shaft - 0.12}, 0.12, 90, 0, 5);                                            // fillet into the bit
  path.to(4.54, -0.52).to(4.80, -0.52).arc({4.80, -0.58}, 0.06, 90, -90, 8).to(4.54, -0.64);  // ward slot
  path.arc({4.62, -1.10}, 0.08, 180, 270, 4);                                                 // first tooth, longest
  path.to(4.78, -1.18).to(4.78, -0.92).arc({4.86, -0.92}, 0.08, 180, 0, 8);                   // cut with a round ground
  path.to(4.94, -1.06).to(5.10, -1.06);                                                       // second tooth
  path.to(5.10, -0.80).to(5.24, -0.80);                                                       // step
  path.to(5.24, -1.18).arc({5.42, -1.10}, 0.08, 270, 360, 4);                                 // third tooth
  path.to(5.50, -0.72).to(5.26, -0.72).arc({5.26, -0.66}, 0.06, 270, 90, 8).to(5.50, -0.60);
  path.to(5.50, -shaft - 0.12).arc({5.62, -shaft - 0.12}, 0.12, 180, 90, 5);
  // The tip: a pin with a shoulder and a round end.
  path.to(5.80, -shaft).to(5.80, -0.13).arc({6.10, 0}, 0.13, 270, 450, 14).to(5.80, 0.13).to(5.80, shaft);
  for (int i = 2; i >= 0; --i) {
    const auto [x, radius] = beads[i];
    path.to(x + radius, shaft).arc({x, bead_height}, radius, 0, 180, 10).to(x - radius, shaft);
  }
  path.arc({fillet_x, fillet_y}, fillet, 270, 180 + root, 7);
  path.arc({0, 0}, bow, root, 360 - root, 64);
  path.points.pop_back();  // the first point again
  return path;
}

}  // namespace

Pslg square() {
  Pslg pslg;
  add_closed(pslg, rectangle(0, 0, 1, 1));
  return pslg;
}

Pslg pipe() {
  Pslg pslg;
  add_closed(pslg, circle({0, 0}, 1, 200), 1);
  add_closed(pslg, circle({0, 0}, 0.35, 60), 2);
  pslg.holes.push_back({0, 0});
  for (int i = 0; i < 6; ++i) {
    const Point centre = on_circle({0, 0}, 0.67, 60.0 * i);
    add_closed(pslg, circle(centre, 0.12, 60), 3);
    pslg.holes.push_back(centre);
  }
  return pslg;
}

Pslg key() {
  Pslg pslg;
  add_closed(pslg, key_outline().points, 1);
  add_closed(pslg, circle({-0.08, 0}, 0.6, 48), 2);  // the ring
  pslg.holes.push_back({-0.08, 0});
  add_closed(pslg, circle({5.02, -0.44}, 0.09, 16), 3);  // a hole through the bit
  pslg.holes.push_back({5.02, -0.44});
  return pslg;
}

Pslg star(int spikes, double spike_degrees) {
  // The spikes stand on the edges of a regular polygon inscribed in the unit circle.
  const double half_step = 180.0 / spikes;
  const double half_base = std::sin(half_step * (std::numbers::pi / 180));
  const double height = half_base / std::tan(spike_degrees / 2 * (std::numbers::pi / 180));
  const double reach = std::cos(half_step * (std::numbers::pi / 180)) + height;
  std::vector<Point> outline;
  for (int i = 0; i < spikes; ++i) {
    outline.push_back(on_circle({0, 0}, 1, half_step * (2 * i - 1)));
    outline.push_back(on_circle({0, 0}, reach, half_step * 2 * i));
  }
  Pslg pslg;
  add_closed(pslg, outline);
  return pslg;
}

Pslg comb(int teeth, double gap) {
  // The channels are teeth that rise from the bar.
  Path path;
  path.to(0, 0).to(1, 0);
  for (int i = teeth - 1; i >= 0; --i) {
    const double middle = (i + 0.5) / teeth;
    const double left = middle - gap / 2, right = middle + gap / 2;
    path.to(right, 0.25).to(right, 1).to(left, 1).to(left, 0.25);
    if (i == teeth - 1) path.points.insert(path.points.begin() + 2, {1, 0.25});
  }
  path.to(0, 0.25);
  Pslg pslg;
  add_closed(pslg, path.points);
  return pslg;
}

Pslg wedge(int segments, double degrees_apart) {
  Pslg pslg;
  add_closed(pslg, rectangle(-2, -2, 2, 2));
  const Index apex = add_points(pslg, {{0, 0}});
  for (int i = 0; i < segments; ++i) {
    const Index end = add_points(pslg, {on_circle({0, 0}, 1, degrees_apart * i)});
    pslg.segments.push_back({apex, end, 0});
    // The first half of the ends lies on a polygon.
    if (i > 0 && i < segments / 2) pslg.segments.push_back({end - 1, end, 0});
  }
  return pslg;
}

Pslg grid(int n) {
  Pslg pslg = grid_points(n);
  const auto row = static_cast<Index>(n) + 1;
  for (Index j = 0; j < row; ++j)
    for (Index i = 0; i < row; ++i) {
      const Index p = j * row + i;
      const bool right = i + 1 < row, up = j + 1 < row;
      if (right) pslg.segments.push_back({p, p + 1, 0});
      if (up) pslg.segments.push_back({p, p + row, 0});
      if (right && up) pslg.segments.push_back({p, p + row + 1, 0});
    }
  return pslg;
}

Pslg grid_points(int n) {
  Pslg pslg;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) pslg.points.push_back({static_cast<double>(i), static_cast<double>(j)});
  return pslg;
}

Pslg touching_holes() {
  // The third hole touches the reflex corner of the outline. Every input angle is at least 90 degrees.
  Pslg pslg;
  add_closed(pslg, {{0, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 4}, {0, 4}}, 1);
  constexpr Index reflex = 2;
  add_closed(pslg, rectangle(1, 1, 2, 2), 2);
  const Index meeting = reflex + 6;  // (2, 2)
  const Index upper = add_points(pslg, {{3, 2}, {3, 3}, {2, 3}});
  const Index hanging = add_points(pslg, {{3, 1.5}, {2.5, 1.5}, {2.5, 1}});
  for (const auto& [touch, first, marker] : {std::tuple{meeting, upper, 3}, std::tuple{reflex, hanging, 4}}) {
    pslg.segments.push_back({touch, first, marker});
    pslg.segments.push_back({first, first + 1, marker});
    pslg.segments.push_back({first + 1, first + 2, marker});
    pslg.segments.push_back({first + 2, touch, marker});
  }
  pslg.holes = {{1.5, 1.5}, {2.5, 2.5}, {2.75, 1.25}};
  return pslg;
}

Pslg cracks() {
  Pslg pslg;
  add_closed(pslg, {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}}, 1);
  constexpr Index on_outline = 4, corner = 1;
  const Index dangling = static_cast<Index>(pslg.points.size());
  add_open(pslg, {{0.75, 2.125}, {1.25, 1.875}, {1.5, 2.5}}, 2);  // a crack from the side
  pslg.segments.push_back({on_outline, dangling, 2});
  const Index branch = static_cast<Index>(pslg.points.size());
  add_open(pslg, {{3.25, 0.5}, {2.75, 1.25}, {2.0, 1.0}}, 3);  // a forked crack from a corner
  pslg.segments.push_back({corner, branch, 3});
  pslg.segments.push_back({branch + 1, add_points(pslg, {{3.0, 2.0}}), 3});
  add_open(pslg, {{2.5, 3.0}, {3.5, 3.25}}, 4);    // a free segment
  add_open(pslg, {{2.5, 3.125}, {3.25, 3.5}}, 4);  // and one next to it
  add_points(pslg, {{1, 1}, {1, 1.015625}, {1, 3}, {3.5, 2.5}, {0.5, 3.5}});
  return pslg;
}

Pslg survey(std::uint64_t n, std::uint64_t seed) {
  const auto wavy_circle = [](Point centre, double radius, int pieces, int waves) {
    std::vector<Point> corners;
    for (int i = 0; i < pieces; ++i) {
      const double degrees = 360.0 * i / pieces;
      const double height = 0.1 * std::sin(waves * degrees * (std::numbers::pi / 180));
      corners.push_back(on_circle(centre, radius * (1 + height), degrees));
    }
    return corners;
  };
  Pslg pslg;
  add_closed(pslg, wavy_circle({0, 0}, 0.85, 400, 7), 1);
  add_closed(pslg, wavy_circle({0.3, 0.2}, 0.15, 100, 3), 2);
  pslg.holes.push_back({0.3, 0.2});
  add_open(pslg, {{-0.5, -0.3125}, {-0.25, -0.4375}, {0.125, -0.375}, {0.5, -0.3125}}, 3);
  for (const Point p : random_points(n, seed).points) pslg.points.push_back({2 * p.x - 1, 2 * p.y - 1});
  return pslg;
}

Pslg regions() {
  // A straight path and a bent path of segments divide the rectangle into three regions.
  Pslg pslg;
  add_closed(pslg, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}}, 1);
  pslg.segments.push_back({1, 6, 2});
  const Index bend = add_points(pslg, {{2.25, 0.5}});
  pslg.segments.push_back({2, bend, 3});
  pslg.segments.push_back({bend, 5, 3});
  pslg.regions = {{{0.5, 0.5}, 10, 0x1p-6}, {{1.5, 0.5}, 20, 0x1p-9}, {{2.75, 0.5}, 30, 0x1p-5}};
  return pslg;
}

Pslg radial(int decades) {
  Pslg pslg;
  add_closed(pslg, rectangle(-1, -1, 1, 1));
  add_points(pslg, {{0, 0}});
  constexpr int spokes = 24;
  const int rings = 24 * decades;
  for (int ring = 0; ring < rings; ++ring) {
    const double radius = 0.95 * std::pow(10.0, decades * (static_cast<double>(ring) / (rings - 1) - 1));
    for (int i = 0; i < spokes; ++i)
      add_points(pslg, {on_circle({0, 0}, radius, (i + 0.5 * (ring % 2)) * (360.0 / spokes))});
  }
  return pslg;
}

std::vector<double> radial_sizes(const Pslg& radial, double ratio) {
  double innermost = std::numeric_limits<double>::infinity();
  for (const Point p : radial.points)
    if (const double radius = std::sqrt(p.x * p.x + p.y * p.y); radius > 0) innermost = std::min(innermost, radius);
  std::vector<double> sizes;
  for (const Point p : radial.points) sizes.push_back(ratio * std::max(innermost, std::sqrt(p.x * p.x + p.y * p.y)));
  return sizes;
}

Pslg moved(Pslg pslg, double dx, double dy, double scale) {
  const auto move = [&](Point& p) { p = {p.x * scale + dx, p.y * scale + dy}; };
  for (Point& p : pslg.points) move(p);
  for (Point& p : pslg.holes) move(p);
  for (Region& region : pslg.regions) {
    move(region.seed);
    region.max_area *= scale * scale;
  }
  return pslg;
}

namespace {

/// A name of generate() and the domain that it stands for.
struct Entry {
  std::string_view name;
  std::uint64_t default_n;  ///< 0 if the domain has no size
  std::uint64_t min_n;
  std::uint64_t max_n;
  std::function<Pslg(int n, std::uint64_t seed)> make;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {"square", 0, 0, 0, [](int, std::uint64_t) { return square(); }},
      {"pipe", 0, 0, 0, [](int, std::uint64_t) { return pipe(); }},
      {"key", 0, 0, 0, [](int, std::uint64_t) { return key(); }},
      {"points", 1000, 3, 1'000'000'000,
       [](int n, std::uint64_t seed) { return random_points(static_cast<std::uint64_t>(n), seed); }},
      {"kuzmin", 1000, 3, 1'000'000'000,
       [](int n, std::uint64_t seed) { return kuzmin_points(static_cast<std::uint64_t>(n), seed); }},
      {"line", 1000, 3, 1'000'000'000,
       [](int n, std::uint64_t seed) { return line_points(static_cast<std::uint64_t>(n), seed); }},
      {"clusters", 1000, 3, 1'000'000'000,
       [](int n, std::uint64_t seed) { return clustered_points(static_cast<std::uint64_t>(n), seed); }},
      {"survey", 1000, 0, 1'000'000'000,
       [](int n, std::uint64_t seed) { return survey(static_cast<std::uint64_t>(n), seed); }},
      {"coast", 1000, 96, 100'000'000,
       [](int n, std::uint64_t seed) { return coast(static_cast<std::uint64_t>(n), seed); }},
      {"star", 12, 3, 100'000, [](int n, std::uint64_t) { return star(n, 5); }},
      {"comb", 16, 1, 100'000, [](int n, std::uint64_t) { return comb(n, 0.0625 / n); }},
      {"wedge", 50, 1, 10'000, [](int n, std::uint64_t) { return wedge(n, 90.0 / n); }},
      {"grid", 10, 1, 10'000, [](int n, std::uint64_t) { return grid(n); }},
      {"grid-points", 10, 1, 10'000, [](int n, std::uint64_t) { return grid_points(n); }},
      {"touching-holes", 0, 0, 0, [](int, std::uint64_t) { return touching_holes(); }},
      {"cracks", 0, 0, 0, [](int, std::uint64_t) { return cracks(); }},
      {"radial", 2, 1, 6, [](int n, std::uint64_t) { return radial(n); }},
      {"regions", 0, 0, 0, [](int, std::uint64_t) { return regions(); }},
  };
  return table;
}

Error size_error(const Entry& entry) {
  const std::string name(entry.name);
  if (entry.max_n == 0) return {ErrorKind::usage, "The domain '" + name + "' has no size to choose."};
  return {ErrorKind::usage, "The size of '" + name + "' must be from " + std::to_string(entry.min_n) + " to " +
                                std::to_string(entry.max_n) + "."};
}

}  // namespace

Result<Pslg> generate(std::string_view name, std::uint64_t n, std::uint64_t seed) {
  for (const Entry& entry : entries()) {
    if (entry.name != name) continue;
    if (n != 0 && (n < entry.min_n || n > entry.max_n)) return size_error(entry);
    return entry.make(static_cast<int>(n == 0 ? entry.default_n : n), seed);
  }
  std::string known;
  for (const std::string& each : names()) known += (known.empty() ? "" : ", ") + each;
  return Error{ErrorKind::usage, "There is no domain named '" + std::string(name) + "'. Known are: " + known + "."};
}

std::vector<SizeRange> size_ranges() {
  std::vector<SizeRange> all;
  for (const Entry& entry : entries())
    if (entry.max_n > 0) all.push_back({std::string(entry.name), entry.min_n, entry.max_n, entry.default_n});
  return all;
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Entry& entry : entries()) all.emplace_back(entry.name);
  return all;
}

std::vector<std::string> even_names() {
  std::vector<std::string> all = names();
  std::erase_if(all, [](const std::string& name) { return name == "kuzmin" || name == "line" || name == "clusters"; });
  return all;
}

}  // namespace pardel::domains
