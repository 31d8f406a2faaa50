#include "lattice_domain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

#include "../../../core/support/enum_names.hpp"

namespace pardel::generators {
namespace {

Point to_point(LatticePoint p, LatticePoint offset, int scale) {
  return {std::ldexp(static_cast<double>(p.x + offset.x), scale),
          std::ldexp(static_cast<double>(p.y + offset.y), scale)};
}

std::ostream& operator<<(std::ostream& out, LatticePoint p) { return out << '(' << p.x << ", " << p.y << ')'; }

constexpr auto family_names = enum_names<Family>({
    {Family::general_position, "general_position"},
    {Family::cocircular_grid, "cocircular_grid"},
    {Family::collinear_runs, "collinear_runs"},
    {Family::near_duplicates, "near_duplicates"},
    {Family::small_angles, "small_angles"},
    {Family::thin_channels, "thin_channels"},
    {Family::nested_holes, "nested_holes"},
    {Family::touching_holes, "touching_holes"},
    {Family::cracks, "cracks"},
    {Family::isolated_points, "isolated_points"},
    {Family::far_offset, "far_offset"},
});

}  // namespace

const std::vector<Family>& all_families() {
  static const std::vector<Family> families = [] {
    std::vector<Family> all;
    for (std::size_t i = 0; i < family_names.size(); ++i) all.push_back(static_cast<Family>(i));
    return all;
  }();
  return families;
}

const char* name(Family family) { return family_names[family]; }

std::ostream& operator<<(std::ostream& out, const LatticeDomain& domain) {
  out << name(domain.family) << ": points";
  for (const LatticePoint p : domain.points) out << ' ' << p;
  out << "; segments";
  for (const Segment& s : domain.segments) {
    out << ' ' << s.a << '-' << s.b;
    if (s.marker != 0) out << '#' << s.marker;
  }
  if (!domain.holes.empty()) out << "; holes / 4";
  for (const LatticePoint h : domain.holes) out << ' ' << h;
  if (!domain.regions.empty()) out << "; regions / 4";
  for (const LatticeRegion& r : domain.regions) out << ' ' << r.seed << ' ' << r.attribute << " <= " << r.max_area;
  if (domain.offset != LatticePoint{}) out << "; offset " << domain.offset;
  if (domain.exponent != 0) out << "; times 2^" << -domain.exponent;
  if (domain.decorations.on.any()) out << "; " << to_string(domain.decorations);
  return out;
}

Pslg to_pslg(const LatticeDomain& domain) {
  const int scale = -domain.exponent;
  const auto place = [&](LatticePoint p) { return to_point(p, domain.offset, scale); };
  const LatticePoint offset_in_quarters{4 * domain.offset.x, 4 * domain.offset.y};
  const auto place_seed = [&](LatticePoint p) { return to_point(p, offset_in_quarters, scale - 2); };
  Pslg pslg;
  for (const LatticePoint p : domain.points) pslg.points.push_back(place(p));
  pslg.segments = domain.segments;
  for (const Segment& s : domain.segments) pslg.has_segment_markers |= s.marker != 0;
  for (const LatticePoint h : domain.holes) pslg.holes.push_back(place_seed(h));
  for (const LatticeRegion& r : domain.regions)
    pslg.regions.push_back({place_seed(r.seed), r.attribute, std::ldexp(r.max_area, 2 * scale)});
  return decorated(std::move(pslg), domain.decorations);
}

Weight weight(const LatticeDomain& domain) {
  Weight w;
  w.things = domain.points.size() + domain.segments.size() + domain.holes.size() + domain.regions.size();
  w.oddities = (domain.offset != LatticePoint{}) + (domain.exponent != 0) + domain.decorations.on.count();
  for (const Segment& s : domain.segments) w.oddities += s.marker != 0;
  for (const LatticeRegion& r : domain.regions) w.oddities += std::isfinite(r.max_area) + (r.attribute != 0);
  for (const LatticePoint p : domain.points) w.magnitude += static_cast<std::uint64_t>(std::abs(p.x) + std::abs(p.y));
  return w;
}

}  // namespace pardel::generators
