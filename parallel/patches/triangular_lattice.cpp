#include "triangular_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pardel::engine {
namespace {

/// Adds a span that does not begin before the last one. Joins the two if there is no gap between them.
void append_merged(const Span& span, std::vector<Span>& merged) {
  if (!merged.empty() && merged.back().row == span.row && span.low <= merged.back().high + 2)
    merged.back().high = std::max(merged.back().high, span.high);
  else
    merged.push_back(span);
}

}  // namespace

TriangularLattice::TriangularLattice(Point origin, double edge, const Box& bounds)
    : origin_(origin), half_edge_(edge / 2), height_(edge * (std::numbers::sqrt3 / 2)), bounds_(bounds) {}

int TriangularLattice::first_row(double y) const { return static_cast<int>(std::ceil((y - origin_.y) / height_)); }
int TriangularLattice::last_row(double y) const { return static_cast<int>(std::floor((y - origin_.y) / height_)); }

void TriangularLattice::add_between(int row, double from, double to, std::vector<Span>& spans) const {
  from = std::max(from, bounds_.min_x);
  to = std::min(to, bounds_.max_x);
  if (!(from <= to)) return;
  const int low = static_cast<int>(std::ceil((from - origin_.x) / half_edge_));
  const int high = static_cast<int>(std::floor((to - origin_.x) / half_edge_));
  const Span span{row, low + ((low ^ row) & 1), high - ((high ^ row) & 1)};
  if (span.low <= span.high) spans.push_back(span);
}

void TriangularLattice::add_crossings(Point a, Point b, std::vector<Crossing>& crossings) const {
  const auto [bottom, top] = std::minmax({a.y, b.y});
  const int last = last_row(top) + 1;  // one more, and one before the first: the rounding of a row is uncertain
  for (int row = first_row(bottom) - 1; row <= last; ++row)
    if (const double y = at(0, row).y; bottom <= y && y < top)
      crossings.push_back({row, a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x)});
}

std::vector<Span> TriangularLattice::inside(std::vector<Crossing> crossings) const {
  std::ranges::sort(crossings,
                    [](const Crossing& c, const Crossing& d) { return c.row != d.row ? c.row < d.row : c.x < d.x; });
  std::vector<Span> spans, result;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    add_between(crossings[i].row, crossings[i].x, crossings[i + 1].x, spans);
  for (const Span& span : spans) append_merged(span, result);
  return result;
}

void TriangularLattice::add_near(Point a, Point b, double distance, std::vector<Span>& spans) const {
  const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  const double ux = length > 0 ? (b.x - a.x) / length : 1, uy = length > 0 ? (b.y - a.y) / length : 0;
  const double bottom = std::max(std::min(a.y, b.y) - distance, bounds_.min_y);
  const double top = std::min(std::max(a.y, b.y) + distance, bounds_.max_y);
  if (!(bottom <= top)) return;
  for (int row = first_row(bottom); row <= last_row(top); ++row) {
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
  for (const Span& span : spans) append_merged(span, result);
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
