#include "patch.hpp"

#include <algorithm>

namespace pardel::engine {
namespace {

/// The least place of a row that is not less than x, and the greatest one that is not greater.
int place_from(int x, int row) { return x + ((x ^ row) & 1); }
int place_to(int x, int row) { return x - ((x ^ row) & 1); }

/// The places that are corners of triangles of the strips, of which some lie below the row and the others above.
std::vector<Span> corners(std::span<const Strip> below, std::span<const Strip> above, int row) {
  std::vector<Span> result;
  for (const auto& strips : {below, above})
    for (const Strip& s : strips) result.push_back({row, place_from(s.low, row), place_to(s.high + 2, row)});
  return merged(std::move(result));
}

/// The places whose six triangles belong to the strips.
std::vector<Span> inner_places(std::span<const Strip> below, std::span<const Strip> above, int row) {
  std::vector<Span> result;
  for (std::size_t b = 0, a = 0; b < below.size() && a < above.size();) {
    const int low = place_from(std::max(below[b].low, above[a].low) + 2, row);
    const int high = place_to(std::min(below[b].high, above[a].high), row);
    if (low <= high) result.push_back({row, low, high});
    below[b].high < above[a].high ? ++b : ++a;
  }
  return result;
}

/// Calls visit(x) for the places from `low` to `high`, two apart, at which none of the strips has a triangle.
template <class Visit>
void for_each_gap(std::span<const Strip> strips, int low, int high, const Visit& visit) {
  auto next = std::ranges::lower_bound(strips, low, {}, &Strip::high);
  for (int x = low; x <= high; x += 2) {
    while (next != strips.end() && next->high < x) ++next;
    if (next != strips.end() && next->low <= x)
      x = place_to(next->high, x);  // places of one row are even or odd together
    else
      visit(x);
  }
}

/// The bounds of each row in a list that is sorted by rows.
template <class T>
std::vector<std::size_t> starts_of_rows(const std::vector<T>& all, int first_row) {
  std::vector<std::size_t> start{0};
  if (all.empty()) return start;
  start.reserve(static_cast<std::size_t>(all.back().row - first_row) + 2);
  std::size_t i = 0;
  for (int row = first_row; row <= all.back().row; ++row) {
    while (i < all.size() && all[i].row == row) ++i;
    start.push_back(i);
  }
  return start;
}

}  // namespace

Patch::Patch(const TriangularLattice& lattice, const std::vector<Span>& places) : lattice_(lattice) {
  if (places.empty()) return;
  first_row_ = places.front().row;
  find_strips(places);
  find_pieces();
}

void Patch::find_strips(const std::vector<Span>& places) {
  // The spans of two neighbouring rows are visited together, from left to right.
  for (auto lower = places.begin(); lower != places.end();) {
    const int row = lower->row;
    const auto upper_begin = std::find_if(lower, places.end(), [&](const Span& s) { return s.row != row; });
    auto upper = upper_begin;
    while (lower != upper_begin && upper != places.end() && upper->row == row + 1) {
      // Standing triangles at x have x and x + 2 below, x + 1 above; hanging ones the other way round.
      const int standing_low = std::max(lower->low, upper->low - 1);
      const int standing_high = std::min(lower->high - 2, upper->high - 1);
      const int hanging_low = std::max(upper->low, lower->low - 1);
      const int hanging_high = std::min(upper->high - 2, lower->high - 1);
      int low = std::min(standing_low, hanging_low), high = std::max(standing_high, hanging_high);
      if (standing_low > standing_high) low = hanging_low, high = hanging_high;
      if (hanging_low > hanging_high) low = standing_low, high = standing_high;
      if (low <= high) {
        strips_.push_back({row, low, high, triangles_});
        triangles_ += strips_.back().count();
      }
      lower->high < upper->high ? ++lower : ++upper;
    }
    lower = upper_begin;
  }
  strip_start_ = starts_of_rows(strips_, first_row_);
}

void Patch::find_pieces() {
  if (strips_.empty()) return;
  const auto add = [&](int row, int low, int high, bool on_border) {
    if (low > high) return;
    std::size_t& next = on_border ? border_points_ : inner_points_;
    pieces_.push_back({row, low, high, on_border, next});
    next += pieces_.back().count();
  };
  for (int row = first_row_; row <= strips_.back().row + 1; ++row) {
    const std::vector<Span> inner = inner_places(strips_above(row - 1), strips_above(row), row);
    auto next = inner.begin();
    for (const Span& used : corners(strips_above(row - 1), strips_above(row), row)) {
      int low = used.low;
      for (; next != inner.end() && next->low <= used.high; ++next) {
        add(row, low, next->low - 2, true);
        add(row, next->low, next->high, false);
        low = next->high + 2;
      }
      add(row, low, used.high, true);
    }
  }
  piece_start_ = starts_of_rows(pieces_, first_row_);
}

std::size_t Patch::border_point(int x, int row) const {
  const Piece& piece = *std::ranges::lower_bound(pieces_of(row), x, {}, &Piece::high);
  return piece.first + static_cast<std::size_t>(x - piece.low) / 2;
}

std::optional<std::size_t> Patch::triangle_at(int x, int row) const {
  const std::span<const Strip> strips = strips_above(row);
  const auto strip = std::ranges::lower_bound(strips, x, {}, &Strip::high);
  if (strip == strips.end() || x < strip->low) return {};
  return strip->first + static_cast<std::size_t>(x - strip->low);
}

std::vector<BorderSide> Patch::border() const {
  std::vector<BorderSide> all;
  for (const Strip& strip : strips_) {
    const int row = strip.row, low = strip.low, high = strip.high;
    const auto stands = [&](int x) { return ((x ^ row) & 1) == 0; };
    // The corners of the strip's triangles go up and down between the two rows.
    const auto corner = [&](int x) { return border_point(x, stands(x) ? row : row + 1); };
    const auto number = [&](int x) { return strip.first + static_cast<std::size_t>(x - low); };
    const auto add = [&](int from, int to, int triangle, unsigned side) {
      all.push_back({corner(from), corner(to), number(triangle), side});
    };
    stands(low) ? add(low + 1, low, low, 1) : add(low, low + 1, low, 1);
    stands(high) ? add(high + 2, high + 1, high, 0) : add(high + 1, high + 2, high, 2);
    for_each_gap(strips_above(row - 1), place_from(low, row), high, [&](int x) { add(x, x + 2, x, 2); });
    for_each_gap(strips_above(row + 1), place_from(low, row + 1), high, [&](int x) { add(x + 2, x, x, 0); });
  }
  return all;
}

}  // namespace pardel::engine
