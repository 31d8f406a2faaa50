#include "triangular_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pardel::engine {

TriangularLattice::TriangularLattice(Point origin, double edge)
    : origin_(origin), half_edge_(edge / 2), height_(edge * (std::numbers::sqrt3 / 2)) {}

int TriangularLattice::first_row(double y) const { return static_cast<int>(std::ceil((y - origin_.y) / height_)); }
int TriangularLattice::last_row(double y) const { return static_cast<int>(std::floor((y - origin_.y) / height_)); }

void TriangularLattice::add_between(int row, double from, double to, std::vector<Span>& spans) const {
  const int low = static_cast<int>(std::ceil((from - origin_.x) / half_edge_));
  const int high = static_cast<int>(std::floor((to - origin_.x) / half_edge_));
  const Span span{row, low + ((low ^ row) & 1), high - ((high ^ row) & 1)};
  if (span.low <= span.high) spans.push_back(span);
}

void TriangularLattice::add_inside(Point a, Point b, Point c, std::vector<Span>& spans) const {
  const double slack = 1e-6 * half_edge_;
  const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
  for (int row = first_row(bottom - slack); row <= last_row(top + slack); ++row) {
    const double y = std::clamp(at(0, row).y, bottom, top);
    double from = INFINITY, to = -INFINITY;
    for (const auto& [p, q] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      if (y < std::min(p.y, q.y) || y > std::max(p.y, q.y)) continue;
      // Where the side crosses the row; of a horizontal side, one end: the other sides end at the other one.
      const double x = p.y == q.y ? p.x : p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
      from = std::min(from, x);
      to = std::max(to, x);
    }
    add_between(row, from - slack, to + slack, spans);
  }
}

void TriangularLattice::add_near(Point a, Point b, double distance, std::vector<Span>& spans) const {
  const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  const double ux = length > 0 ? (b.x - a.x) / length : 1, uy = length > 0 ? (b.y - a.y) / length : 0;
  const auto [bottom, top] = std::minmax({a.y, b.y});
  for (int row = first_row(bottom - distance); row <= last_row(top + distance); ++row) {
    const double y = at(0, row).y;
    double from = INFINITY, to = -INFINITY;
    for (const Point end : {a, b}) {  // the disks around the ends
      const double half = std::sqrt(std::max(0.0, distance * distance - (y - end.y) * (y - end.y)));
      if (std::abs(y - end.y) > distance) continue;
      from = std::min(from, end.x - half);
      to = std::max(to, end.x + half);
    }
    // The rectangle along the segment: for (x, y) = a + s u + t v, with v normal to u, 0 <= s <= length and
    // |t| <= distance.
    double low = -INFINITY, high = INFINITY;
    const auto limit = [&](double slope, double offset, double least, double most) {
      if (slope == 0) {
        if (offset < least || offset > most) high = -INFINITY;
        return;
      }
      const auto [left, right] = std::minmax({(least - offset) / slope, (most - offset) / slope});
      low = std::max(low, left);
      high = std::min(high, right);
    };
    limit(ux, (y - a.y) * uy, 0, length);
    limit(-uy, (y - a.y) * ux, -distance, distance);
    if (low <= high) {
      from = std::min(from, a.x + low);
      to = std::max(to, a.x + high);
    }
    if (from <= to) add_between(row, from, to, spans);
  }
}

std::vector<Span> merged(std::vector<Span> spans) {
  std::ranges::sort(spans, [](const Span& s, const Span& t) { return s.row != t.row ? s.row < t.row : s.low < t.low; });
  std::vector<Span> result;
  for (const Span& span : spans) {
    if (!result.empty() && result.back().row == span.row && span.low <= result.back().high + 2)
      result.back().high = std::max(result.back().high, span.high);
    else
      result.push_back(span);
  }
  return result;
}

std::vector<Span> without(const std::vector<Span>& spans, const std::vector<Span>& removed) {
  std::vector<Span> result;
  auto next = removed.begin();
  for (const Span& span : spans) {
    while (next != removed.end() && (next->row < span.row || (next->row == span.row && next->high < span.low))) ++next;
    int low = span.low;
    for (auto hole = next; hole != removed.end() && hole->row == span.row && hole->low <= span.high; ++hole) {
      if (hole->low > low) result.push_back({span.row, low, hole->low - 2});
      low = hole->high + 2;
    }
    if (low <= span.high) result.push_back({span.row, low, span.high});
  }
  return result;
}

}  // namespace pardel::engine
