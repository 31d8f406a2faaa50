#include "triangle_library.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <span>
#include <string>

extern "C" {
#include <triangle.h>
}

#include "bounds.hpp"

namespace pardel::bench {
namespace {

/// What Triangle has allocated.
class Output {
 public:
  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  ~Output() {
    trifree(arrays.pointlist);
    trifree(arrays.trianglelist);
  }
  triangulateio arrays{};
};

/// Runs Triangle on a subdomain with more switches. `caps`: the largest area for each triangle, or empty.
///
/// z: numbers from 0. Q: print nothing. B, P: neither markers nor segments in the output. r, p: refine this mesh with
/// these segments. YY: no segment is split. S: a limit on the new points.
RefinedSubdomain run_triangle(const Subdomain& subdomain, std::string switches, std::vector<double> caps) {
  std::vector<Point> points = subdomain.points;
  std::vector<std::array<Index, 3>> triangles = subdomain.triangles;
  std::vector<int> segments;
  for (const SubdomainEdge& e : subdomain.edges)
    segments.insert(segments.end(), {static_cast<int>(e.a), static_cast<int>(e.b)});

  triangulateio in{};
  in.pointlist = &points.data()->x;
  in.numberofpoints = static_cast<int>(points.size());
  in.trianglelist = reinterpret_cast<int*>(triangles.data());
  in.numberoftriangles = static_cast<int>(triangles.size());
  in.numberofcorners = 3;
  in.segmentlist = segments.data();
  in.numberofsegments = static_cast<int>(subdomain.edges.size());
  if (!caps.empty()) {
    in.trianglearealist = caps.data();
    switches += "a";
  }
  constexpr std::size_t most = 1U << 30U;
  switches += "zQBPrpYYS" + std::to_string(std::min(most, subdomain.most_new_points));
  Output out;
  triangulate(switches.data(), &in, &out.arrays, nullptr);

  RefinedSubdomain answer;
  if (out.arrays.numberofpoints < static_cast<int>(points.size())) {
    answer.ending = RefinedSubdomain::Ending::failed;
    answer.why = "Triangle has lost points";
    return answer;
  }
  const auto* const corners = reinterpret_cast<const std::array<Index, 3>*>(out.arrays.trianglelist);
  for (int i = 0; i < out.arrays.numberofpoints; ++i)
    answer.points.push_back({out.arrays.pointlist[2 * i], out.arrays.pointlist[2 * i + 1]});
  answer.triangles.assign(corners, corners + out.arrays.numberoftriangles);
  answer.edge_of_new_point.assign(answer.points.size() - points.size(), no_index);
  if (answer.edge_of_new_point.size() >= subdomain.most_new_points) answer.ending = RefinedSubdomain::Ending::limit;
  return answer;
}

class TriangleMesher final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = false,
            .keeps_frozen_edges = true,
            .splits_segments = false,
            .exempts_small_angles = true,
            .is_thread_safe = false};
  }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    std::array<char, 64> angle{};
    std::snprintf(angle.data(), angle.size(), "q%.15f", subdomain.goal.min_angle_deg);  // Triangle reads no exponents
    return run_triangle(subdomain, angle.data(), caps_of(subdomain));
  }

 private:
  /// The areas for each triangle, which its parts inherit. A bound on edges becomes one on areas: that of a right
  /// triangle with two such edges, halved, because most triangles are much smaller than their cap.
  static std::vector<double> caps_of(const Subdomain& subdomain) {
    constexpr double area_of_unit_edge = 0.25;
    const Bounds bounds(subdomain);
    std::vector<double> caps;
    for (std::size_t i = 0; i < subdomain.triangles.size(); ++i) {
      const auto& v = subdomain.triangles[i];
      const Point a = subdomain.points[v[0]], b = subdomain.points[v[1]], c = subdomain.points[v[2]];
      const double edge = bounds.max_edge_at({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
      const double region = subdomain.max_areas.empty() ? subdomain.goal.max_area : subdomain.max_areas[i];
      caps.push_back(std::min(region, area_of_unit_edge * edge * edge));
    }
    // Triangle takes infinity as any number.
    if (std::ranges::all_of(caps, [](double cap) { return cap == std::numeric_limits<double>::infinity(); })) return {};
    return caps;
  }
};

#ifdef PARDEL_TRIANGLE_HOOK

/// What the hook asks while Triangle runs. Triangle gives it no other place, and is not thread-safe in any case.
const Bounds* bounds_of_run = nullptr;

struct WithBounds {
  explicit WithBounds(const Bounds& bounds) { bounds_of_run = &bounds; }
  WithBounds(const WithBounds&) = delete;
  WithBounds& operator=(const WithBounds&) = delete;
  ~WithBounds() { bounds_of_run = nullptr; }
};

/// Triangle rounds the circumcentre in another way, so those at the border of the cell are left out.
bool is_unsuitable(const Bounds& bounds, Point a, Point b, Point c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y;
  const double uu = ux * ux + uy * uy, vv = vx * vx + vy * vy, twice_cross = 2 * (ux * vy - uy * vx);
  const Point centre{a.x + (vy * uu - uy * vv) / twice_cross, a.y + (ux * vv - vx * uu) / twice_cross};
  const double margin = 1e-9 * std::hypot(centre.x - a.x, centre.y - a.y);
  for (const Point p : {Point{centre.x - margin, centre.y - margin}, Point{centre.x + margin, centre.y + margin}})
    if (!bounds.may_insert(p, a)) return false;
  const Bounds::Quality quality = bounds.quality(a, b, c);
  return bounds.is_too_large(quality) || bounds.is_thin(quality);
}

/// -u: split what the hook says. -D: a circumcentre encroaches upon a segment if it lies in its diametral circle.
/// Without this switch the size of the lens around a segment follows from the angle of -q, and without -q there is
/// none. With -q, Triangle would also split thin triangles about which the hook says no. So the bound on angles is
/// decided by the hook. Without -q, Triangle inserts circumcentres, not off-centres, and does not exempt triangles at
/// small input angles.
class TriangleWithHook final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = true,
            .keeps_frozen_edges = true,
            .splits_segments = false,
            .exempts_small_angles = false,
            .is_thread_safe = false};
  }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    const Bounds bounds(subdomain);
    const WithBounds with(bounds);
    return run_triangle(subdomain, "uD", {});
  }
};

#endif

}  // namespace

std::unique_ptr<SubdomainMesher> triangle_library() { return std::make_unique<TriangleMesher>(); }

#ifdef PARDEL_TRIANGLE_HOOK

std::unique_ptr<SubdomainMesher> triangle_library_with_hook() { return std::make_unique<TriangleWithHook>(); }

#endif

}  // namespace pardel::bench

#ifdef PARDEL_TRIANGLE_HOOK
/// Triangle's hook. The program's definition takes the place of the one in the shared library.
extern "C" int triunsuitable(double* a, double* b, double* c, double /*area*/) {
  using pardel::bench::bounds_of_run;
  return bounds_of_run != nullptr &&
         pardel::bench::is_unsuitable(*bounds_of_run, {a[0], a[1]}, {b[0], b[1]}, {c[0], c[1]});
}
#endif
