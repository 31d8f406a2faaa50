#include "write_strips.hpp"

#include <algorithm>

#include "../threads/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// Finds the points at places of a row. The places that are asked for ascend.
class RowCursor {
 public:
  RowCursor(std::span<const Piece> pieces, Index first_border, Index first_inner)
      : piece_(pieces.begin()), end_(pieces.end()), first_border_(first_border), first_inner_(first_inner) {}
  [[nodiscard]] Index at(int x) {
    go_to(x);
    const std::size_t number = piece_->first + static_cast<std::size_t>(x - piece_->low) / 2;
    return (piece_->on_border ? first_border_ : first_inner_) + static_cast<Index>(number);
  }
  /// From x up to this place, the points have consecutive numbers.
  [[nodiscard]] int last(int x) {
    go_to(x);
    return piece_->high;
  }

 private:
  void go_to(int x) {
    while (piece_ + 1 != end_ && x > piece_->high) ++piece_;
  }

  std::span<const Piece>::iterator piece_, end_;
  Index first_border_, first_inner_;
};

/// Finds the triangles of strips between two rows. The places that are asked for ascend.
class StripCursor {
 public:
  /// The triangles of the patch are numbered from `first_triangle`.
  StripCursor(std::span<const Strip> strips, Index first_triangle)
      : strip_(strips.begin()), end_(strips.end()), first_triangle_(first_triangle) {}
  /// The triangle at x, or no_index if there is none.
  [[nodiscard]] Index at(int x) {
    if (!go_to(x)) return no_index;
    return first_triangle_ + static_cast<Index>(strip_->first) + static_cast<Index>(x - strip_->low);
  }
  /// From x up to this place, the triangles have consecutive numbers. Less than x if there is no triangle at x.
  [[nodiscard]] int last(int x) { return go_to(x) ? strip_->high : x - 1; }

 private:
  /// True if there is a triangle at x.
  [[nodiscard]] bool go_to(int x) {
    while (strip_ != end_ && x > strip_->high) ++strip_;
    return strip_ != end_ && x >= strip_->low;
  }

  std::span<const Strip>::iterator strip_, end_;
  Index first_triangle_;
};

/// Writes the triangles of a strip, from left to right. Sides on the border of the patch get no neighbours.
class StripWriter {
 public:
  StripWriter(const Patch& patch, const PlacesOfPatch& places, const Strip& strip, const TriangleRange& to)
      : strip_(strip),
        first_(places.first_triangle + static_cast<Index>(strip.first)),
        lower_(patch.pieces_of(strip.row), places.first_border, places.first_inner),
        upper_(patch.pieces_of(strip.row + 1), places.first_border, places.first_inner),
        below_(patch.strips_above(strip.row - 1), places.first_triangle),
        above_(patch.strips_above(strip.row + 1), places.first_triangle),
        to_(to) {}

  void write() {
    for (int x = strip_.low; x <= strip_.high;) {
      const int pairs = stands(x) && x > strip_.low ? even_pairs(x) : 0;
      if (pairs > 0)
        write_pairs(x, pairs);
      else
        write_one(x);
      x += std::max(2 * pairs, 1);
    }
  }

 private:
  [[nodiscard]] bool stands(int x) const { return ((x ^ strip_.row) & 1) == 0; }
  [[nodiscard]] Index id(int x) const { return first_ + static_cast<Index>(x - strip_.low); }
  [[nodiscard]] Index point(int x) { return stands(x) ? lower_.at(x) : upper_.at(x); }

  /// From x on, so many pairs of a standing and a hanging triangle have neighbours on all sides, and corners and
  /// neighbours whose numbers go up evenly. Nearly all triangles of a large patch belong to such pairs.
  [[nodiscard]] int even_pairs(int x) {
    const int last =
        std::min({lower_.last(x), upper_.last(x + 1) - 1, below_.last(x) + 2, above_.last(x + 1) + 1, strip_.high});
    return (last - x) / 2;
  }

  void write_pairs(int x, int pairs) {
    Index lower = lower_.at(x), upper = upper_.at(x + 1), below = below_.at(x), above = above_.at(x + 1);
    Triangle* to = &to_[id(x)];
    for (Index here = id(x), end = here + 2 * static_cast<Index>(pairs); here != end; here += 2) {
      *to++ = {{lower, lower + 1, upper}, {here + 1, here - 1, below}};
      *to++ = {{lower + 1, upper + 1, upper}, {above, here, here + 2}};
      ++lower, ++upper, below += 2, above += 2;
    }
  }

  void write_one(int x) {
    const Index left = point(x), middle = point(x + 1), right = point(x + 2);
    const Index before = x > strip_.low ? id(x) - 1 : no_index;
    const Index after = x < strip_.high ? id(x) + 1 : no_index;
    if (stands(x))
      to_[id(x)] = {{left, right, middle}, {after, before, below_.at(x)}};
    else
      to_[id(x)] = {{middle, right, left}, {above_.at(x), before, after}};
  }

  const Strip& strip_;
  Index first_;  ///< the first triangle of the strip
  RowCursor lower_, upper_;
  StripCursor below_, above_;
  TriangleRange to_;
};

}  // namespace

std::vector<PlacesOfPatch> places_of(std::span<const RegionPatch> patches, Index first_border, std::size_t points,
                                     std::size_t triangles) {
  std::vector<PlacesOfPatch> places;
  std::size_t border = first_border;
  for (const auto& [region, patch] : patches) {
    places.push_back({static_cast<Index>(border), static_cast<Index>(points), static_cast<Index>(triangles)});
    border += patch.border_points();
    points += patch.inner_points();
    triangles += patch.triangles();
  }
  return places;
}

void write_strips(const Patch& patch, const PlacesOfPatch& places, std::span<const Strip> strips,
                  const TriangleRange& to, const Threads& threads) {
  parallel_runs(threads, strips.size(), [&](std::size_t s) { StripWriter(patch, places, strips[s], to).write(); });
}

}  // namespace pardel::engine
