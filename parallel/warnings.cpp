#include "warnings.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "../core/support/shortest.hpp"
#include "diagnosis/far_part.hpp"
#include "segments/faces.hpp"
#include "segments/plane_sweep.hpp"

namespace pardel {

using namespace engine;

namespace {

std::vector<Index> degrees(const Pslg& pslg) {
  std::vector<Index> degree(pslg.points.size());
  for (const Segment& s : pslg.segments) {
    ++degree[s.a];
    ++degree[s.b];
  }
  return degree;
}

/// For each segment: true if both faces beside it are outside the domain.
std::vector<bool> segments_outside(const Pslg& pslg) {
  const Swept swept = sweep_plane({.points = pslg.points, .segments = pslg.segments, .queries = pslg.holes});
  const Faces faces(pslg.points, pslg.segments, swept.below);
  std::vector<bool> in_domain(faces.count(), true);
  in_domain[Faces::exterior] = false;
  for (std::size_t h = 0; h < pslg.holes.size(); ++h)
    in_domain[faces.above(swept.below[pslg.points.size() + h])] = false;
  std::vector<bool> outside(pslg.segments.size());
  for (Index s = 0; s < outside.size(); ++s) outside[s] = !in_domain[faces.left_of(s)] && !in_domain[faces.right_of(s)];
  return outside;
}

/// Groups of points that the chosen segments join.
class Groups {
 public:
  Groups(const Pslg& pslg, const std::vector<bool>& chosen) : parent_(pslg.points.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
    for (std::size_t s = 0; s < chosen.size(); ++s)
      if (chosen[s]) parent_[root(pslg.segments[s].a)] = root(pslg.segments[s].b);
  }
  Index root(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  std::vector<Index> parent_;
};

}  // namespace

const char* name(WarningKind kind) {
  constexpr std::array names{"open_outline", "far_part"};
  return names.at(static_cast<std::size_t>(kind));
}

std::string Warning::message(int base) const {
  const auto id = [&](Index i) { return std::to_string(static_cast<long long>(i) + base); };
  if (kind == WarningKind::far_part)
    return (segments.empty() ? "Point " + id(points[0]) : "Segment " + id(segments[0])) + " at " + shortest(where) +
           " lies far away from everything else. Without it, the extent of the domain would be " +
           shortest(extent_without) + ".";
  const std::string first = id(segments[0]);
  const std::string which = segments.size() == 1
                                ? "Segment " + first + " has an open end"
                                : std::to_string(segments.size()) + " segments, the first of them segment " + first +
                                      ", are joined but have an open end";
  return which + " at " + shortest(where) +
         (segments.size() == 1 ? " and lies outside the domain. It is" : " and lie outside the domain. They are") +
         " not in the mesh.";
}

std::vector<Warning> find_warnings(const ValidPslg& domain) {
  const Pslg& pslg = domain.pslg();
  std::vector<Warning> warnings;
  if (std::optional<Warning> warning = find_far_part(pslg)) warnings.push_back(std::move(*warning));
  const std::vector<Index> degree = degrees(pslg);
  if (domain.convex_hull() || std::find(degree.begin(), degree.end(), 1U) == degree.end()) return warnings;
  const std::vector<bool> outside = segments_outside(pslg);
  Groups groups(pslg, outside);
  std::vector<Index> open_end(pslg.points.size(), no_index), number(pslg.points.size(), no_index);
  for (Index s = 0; s < outside.size(); ++s)
    for (const Index end : {pslg.segments[s].a, pslg.segments[s].b})
      if (outside[s] && degree[end] == 1) open_end[groups.root(end)] = end;
  for (Index s = 0; s < outside.size(); ++s) {
    const Index group = groups.root(pslg.segments[s].a);
    if (!outside[s] || open_end[group] == no_index) continue;
    if (number[group] == no_index) {
      number[group] = static_cast<Index>(warnings.size());
      warnings.push_back({WarningKind::open_outline, {}, pslg.points[open_end[group]]});
    }
    warnings[number[group]].segments.push_back(s);
  }
  return warnings;
}

}  // namespace pardel
