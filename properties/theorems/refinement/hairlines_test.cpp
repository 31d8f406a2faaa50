// Gaps outside the domain that are about as narrow as the distance from one double to the next: rounding must not move
// the boundary across them.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "../../../parallel/validate.hpp"
#include "../../domains/dealt_domain.hpp"
#include "../framework/mesh_of_ranks.hpp"
#include "../framework/shares.hpp"
#include "decorated.hpp"

namespace pardel::properties {
namespace {

constexpr const char* families_with_hairlines =
    "parcels beside a square, a notch with an apex, sectors around a common corner, a hole with narrow teeth, turned "
    "by "
    "random angles, where gaps are half a unit in the last place to 2^-10 wide";

using Ring = std::vector<Point>;

class Drawing {
 public:
  Drawing() : offset_(*rc::gen::element(Point{0, 0}, Point{3, 7}, Point{500'000, 4'000'000}, Point{0x1p-10, 0})) {
    const double turn = *rc::gen::inRange(0, 1000) * (2 * std::numbers::pi / 1000);
    cosine_ = std::cos(turn);
    sine_ = std::sin(turn);
    unit_ = 0x1p-53 * std::max({1.0, std::abs(offset_.x), std::abs(offset_.y)});
  }

  [[nodiscard]] Pslg draw() {
    switch (*rc::gen::inRange(0, 4)) {
      case 0:
        parcels();
        break;
      case 1:
        notch();
        break;
      case 2:
        sectors();
        break;
      default:
        teeth();
        break;
    }
    return std::move(pslg_);
  }

 private:
  [[nodiscard]] double some_gap() const {
    const double units = *rc::gen::element(1.0, 2.0, 3.0, 4.0, 10.0, 100.0, 0x1p20, 0x1p30, 0x1p43);
    return std::min(units * unit_, 0x1p-10);
  }
  [[nodiscard]] static double some_length(int least, int most) { return *rc::gen::inRange(least, most) / 1000.0; }
  [[nodiscard]] Point turned(Point p) const {
    return {offset_.x + cosine_ * p.x - sine_ * p.y, offset_.y + sine_ * p.x + cosine_ * p.y};
  }

  void add(const Ring& ring) {
    const auto first = static_cast<Index>(pslg_.points.size()), count = static_cast<Index>(ring.size());
    for (Index i = 0; i < count; ++i) {
      pslg_.points.push_back(turned(ring[i]));
      pslg_.segments.push_back({first + i, first + (i + 1) % count, 0});
    }
  }

  void parcels() {
    add({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const double beside = 1 + some_gap();
    for (double low = -0.3; low < 1.2;) {
      const double high = low + some_length(50, 600), slant = *rc::gen::element(0.0, 1.0, 2.0) * unit_;
      add({{beside, low}, {1.5, low + 0.01}, {1.5, high}, {beside + slant, high}});
      low = high + some_gap();
    }
  }

  void notch() {
    const Point apex{0.7, 0.4};
    add({{-1, 0}, {0, 0}, apex, {some_gap(), 0}, {2, 0}, {2, 1}, {-1, 1}});
    const double spike = *rc::gen::element(0.0, 0x1p-24, 0x1p-12);
    if (spike == 0) return;
    pslg_.points.push_back(turned({apex.x + 0.3 * spike, apex.y + spike}));
    pslg_.segments.push_back({2, static_cast<Index>(pslg_.points.size() - 1), 0});
  }

  void sectors() {
    pslg_.points.push_back(turned({0, 0}));
    double from = 0;
    for (int sector = 0; sector < 4; ++sector) {
      const double to = from + some_length(200, 700), length = some_length(300, 1000);
      const auto next = static_cast<Index>(pslg_.points.size());
      pslg_.points.push_back(turned({length * std::cos(from), length * std::sin(from)}));
      pslg_.points.push_back(turned({std::cos(to), std::sin(to)}));
      for (const auto& [a, b] : {std::pair<Index, Index>{0, next}, {next, next + 1}, {next + 1, 0}})
        pslg_.segments.push_back({a, b, 0});
      from = to + some_gap();
    }
  }

  void teeth() {
    add({{-1, -1}, {2, -1}, {2, 2}, {-1, 2}});
    const int count = *rc::gen::inRange(1, 5);
    const double width = some_gap();
    Ring hole;
    for (int tooth = 0; tooth < count; ++tooth) {
      const double x = static_cast<double>(tooth) / count;
      hole.insert(hole.end(), {{x, 0}, {x + width, 0.8}, {x + 2 * width, 0}});
    }
    hole.insert(hole.end(), {{1, 0}, {1, -0.2}, {0, -0.2}});
    add(hole);
    pslg_.holes = {turned({0.5, -0.1})};
  }

  Pslg pslg_;
  Point offset_;
  double cosine_ = 1, sine_ = 0;
  double unit_;  ///< in the last place of the coordinates
};

Goal some_goal() {
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return {.max_edge = 0.1};
    case 1:
      return {.max_area = 0.01};
    case 2:
      return {.min_angle_deg = 30};
    case 3:
      return {.conforming = true};
    default:
      return {};
  }
}

/// Without the lattices of the paper: a spike of 2^-24 would need a great many of them.
Options options_for_small_features() {
  Options options = some_options();
  if (options.decomposition == Decomposition::paper) options.decomposition = Decomposition::automatic;
  return options;
}

/// A valid domain with hairlines. Rounding makes some drawings invalid.
Pslg some_domain(Exhibit& exhibit) {
  Pslg pslg = Drawing().draw();
  RC_PRE(static_cast<bool>(validate(pslg)));
  exhibit.show(pslg);
  return pslg;
}

PARDEL_PROPERTY(Hairlines, outside_the_domain_are_not_crossed,
                {.statement = "Gaps outside the domain are as narrow as rounding. Boundary edges of the mesh never "
                              "cross: it conforms and is constrained Delaunay, and each triangle that misses a bound "
                              "is listed in the report. Two threads and several ranks make the same mesh.",
                 .source = "properties/THEORY.md, refinement: hairlines",
                 .families = families_with_hairlines}) {
  const Problem problem{some_domain(exhibit), some_goal()};
  Options options = options_for_small_features();
  const Meshed result = meshed(problem, exhibit, options);
  require_certified({problem, options, {}, {}}, result, true);
  classify(result.report.goal_met(), "all bounds are met", 80);
  options.threads = 2;
  RC_ASSERT(value_of(mesh(problem.pslg, problem.goal, options)).mesh == result.mesh);

  const int count = *rc::gen::element(1, 1, 2, 3);
  if (count == 1) return;
  options.threads = 1;
  const bool is_dealt = can_divide_points(problem.goal, options) && *rc::gen::arbitrary<bool>();
  const ValidPslg domain = std::move(validate(problem.pslg)).value();
  const std::string difference = difference_on_ranks(result.mesh, count, [&](pardel::Ranks& ranks) {
    return is_dealt ? mesh(domains::equal_part(problem.pslg, ranks), problem.goal, options, ranks)
                    : mesh(domain, problem.goal, options, ranks);
  });
  RC_ASSERT(difference == "");
}

PARDEL_PROPERTY(Hairlines, outside_a_mesh_are_not_crossed_when_it_is_refined,
                {.statement = "Refine the triangulation of a domain with gaps as narrow as rounding, or a mesh with "
                              "vertices inside its segments. Boundary edges never cross: the refined mesh conforms to "
                              "the domain and is constrained Delaunay.",
                 .source = "properties/THEORY.md, refinement: hairlines",
                 .families = families_with_hairlines}) {
  const Pslg pslg = some_domain(exhibit);
  // Vertices inside segments, too, may lie beside a gap.
  const bool is_divided = *rc::gen::arbitrary<bool>();
  const Goal first{.min_angle_deg = 0, .max_edge = 0.4};
  const Mesh coarse = value_of(is_divided ? mesh(pslg, first, options_for_small_features()) : triangulate(pslg)).mesh;
  require_valid(check(pslg, coarse, {.min_angle_deg = 0}));
  const Meshed result =
      value_of(refine(coarse, {}, Goal{.max_edge = *rc::gen::element(0.2, 0.1)}, options_for_small_features()));
  exhibit.show(pslg, result.mesh);
  require_valid(check(pslg, result.mesh, {.min_angle_deg = 0}));
}

}  // namespace
}  // namespace pardel::properties
