#include "territory.hpp"

#include <algorithm>
#include <cmath>

#include "../mesh/extent.hpp"
#include "../mesh/triangle.hpp"

namespace pardel::schemes {
namespace {

/// So many samples are taken of the domain, and of each worker's part.
constexpr double samples_at_least = 256, samples_per_worker = 64;

double area(const std::array<Point, 3>& p) { return twice_area(p[0], p[1], p[2]) / 2; }

/// Calls visit(centroid, part) for parts of a triangle that are at most `largest` large.
template <class Visit>
void visit_parts(const std::array<Point, 3>& p, double largest, const Visit& visit) {
  if (!(area(p) > largest)) {
    visit(centroid(p[0], p[1], p[2]), p);
    return;
  }
  const auto middle = [](Point a, Point b) { return Point{(a.x + b.x) / 2, (a.y + b.y) / 2}; };
  const Point ab = middle(p[0], p[1]), bc = middle(p[1], p[2]), ca = middle(p[2], p[0]);
  for (const std::array<Point, 3>& part :
       {std::array{p[0], ab, ca}, std::array{ab, p[1], bc}, std::array{ca, bc, p[2]}, std::array{ab, bc, ca}})
    visit_parts(part, largest, visit);
}

}  // namespace

Territory::Territory(const LinkedMesh& mesh, const Bounds& bounds, int workers) : workers_(workers) {
  double whole = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) whole += area({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
  const double largest = whole / std::max(samples_at_least, samples_per_worker * workers);
  std::vector<Sample> samples;
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (!mesh.in_use(t)) continue;
    visit_parts({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, largest, [&](Point p, const auto& part) {
      samples.push_back({p, std::max(1.0, area(part) / bounds.wanted_area(p, mesh.faces[t].region))});
    });
  }
  root_ = divide(samples, 0, samples.size(), 0, workers);
}

int Territory::divide(std::vector<Sample>& samples, std::size_t from, std::size_t to, int first, int count) {
  if (count == 1 || to - from < 2) return -first - 1;
  Extent extent;
  double weight = 0;
  for (std::size_t k = from; k < to; ++k) {
    const auto& [p, w] = samples[k];
    extent.include(p);
    weight += w;
  }
  const bool in_x = extent.width() >= extent.height();
  const auto key = [in_x](const Sample& s) { return in_x ? std::pair(s.p.x, s.p.y) : std::pair(s.p.y, s.p.x); };
  const auto begin = samples.begin();
  std::sort(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to),
            [&](const Sample& a, const Sample& b) { return key(a) < key(b); });
  const int lower = count / 2;
  const double wanted = weight * lower / count;
  std::size_t cut = from;
  for (double sum = 0; cut < to - 1 && (cut == from || sum + samples[cut].weight / 2 < wanted); ++cut)
    sum += samples[cut].weight;
  const auto place = static_cast<int>(cuts_.size());
  cuts_.push_back({in_x, key(samples[cut]).first, 0, 0});
  const int below = divide(samples, from, cut, first, lower);
  const int above = divide(samples, cut, to, first + lower, count - lower);
  cuts_[static_cast<std::size_t>(place)].low = below;
  cuts_[static_cast<std::size_t>(place)].high = above;
  return place;
}

int Territory::owner(Point p) const {
  int child = root_;
  while (child >= 0) {
    const Cut& cut = cuts_[static_cast<std::size_t>(child)];
    child = (cut.in_x ? p.x : p.y) < cut.at ? cut.low : cut.high;
  }
  return -child - 1;
}

std::vector<Territory::Line> Territory::borders(Point low, Point high) const {
  std::vector<Line> lines;
  add_borders(root_, low, high, lines);
  return lines;
}

void Territory::add_borders(int child, Point low, Point high, std::vector<Line>& lines) const {
  if (child < 0) return;
  const Cut& cut = cuts_[static_cast<std::size_t>(child)];
  lines.push_back({cut.in_x, cut.at, cut.in_x ? low.y : low.x, cut.in_x ? high.y : high.x});
  add_borders(cut.low, low, cut.in_x ? Point{cut.at, high.y} : Point{high.x, cut.at}, lines);
  add_borders(cut.high, cut.in_x ? Point{cut.at, low.y} : Point{low.x, cut.at}, high, lines);
}

int Territory::owner(const LinkedMesh& mesh, Index t) const { return owner(centroid(mesh, t)); }

std::uint64_t most_owned(const LinkedMesh& mesh, const Territory& territory) {
  std::vector<std::uint64_t> owned(static_cast<std::size_t>(territory.workers()), 0);
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t)) ++owned[static_cast<std::size_t>(territory.owner(mesh, t))];
  return *std::ranges::max_element(owned);
}

}  // namespace pardel::schemes
