#include "border.hpp"

#include <tuple>
#include <utility>

#include "../../../core/support/exchange_lists.hpp"

namespace pardel::checker {
namespace {

/// A side on its way to the referee of the smaller one of its ends.
struct TravellingSide {
  Index low, high;  ///< the numbers of the ends
  Across triangle;  ///< the side, as the triangle across it sees it
  bool rising;      ///< runs from low to high
};

/// What is across side number `side` of a rank.
struct Answer {
  Index side;
  Across across;
};

/// Joins the first rising with the first falling side of each edge. Returns the answers for each rank.
std::vector<std::vector<Answer>> joined(std::vector<TravellingSide>& sides, std::size_t ranks) {
  std::ranges::sort(sides, [](const TravellingSide& a, const TravellingSide& b) {
    return std::tuple(a.low, a.high, !a.rising, a.triangle.triangle, a.triangle.side) <
           std::tuple(b.low, b.high, !b.rising, b.triangle.triangle, b.triangle.side);
  });
  std::vector<std::vector<Answer>> answers(ranks);
  const auto tell = [&](const TravellingSide& side, const TravellingSide& other) {
    answers.at(static_cast<std::size_t>(side.triangle.rank)).push_back({side.triangle.side, other.triangle});
  };
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const TravellingSide& side) {
      return side.low != first->low || side.high != first->high;
    });
    const auto falling = std::find_if(first, last, [](const TravellingSide& side) { return !side.rising; });
    if (falling != first && falling != last) {
      tell(*first, *falling);
      tell(*falling, *first);
    }
    first = last;
  }
  return answers;
}

}  // namespace

Border::Border(const PiecesRead& read, std::uint64_t points, Ranks& ranks) {
  const auto count = static_cast<std::size_t>(ranks.count());
  const Referees referees(points, ranks.count());
  std::vector<std::vector<TravellingSide>> sent(count);
  first_.push_back(0);
  for (std::size_t i = 0; i < read.pieces.size(); ++i) {
    const KeptPart& part = read.pieces[i].part;
    for (std::size_t s = 0; s < part.sides.size(); ++s) {
      const KeptSide& side = part.sides[s];
      const Index a = part.vertices[side.from].number, b = part.vertices[side.to].number;
      const KeptVertex& apex = part.vertices[side.apex];
      const Across seen{ranks.rank(), static_cast<Index>(first_.back() + s), read.first_triangle[i] + side.triangle,
                        apex.number, apex.at};
      sent[static_cast<std::size_t>(referees.of(std::min(a, b)))].push_back(
          {std::min(a, b), std::max(a, b), seen, a < b});
    }
    first_.push_back(first_.back() + part.sides.size());
  }
  std::vector<TravellingSide> sides = concatenated(exchange_lists(std::move(sent), ranks));
  across_.resize(first_.back());
  for (const Answer& answer : concatenated(exchange_lists(joined(sides, count), ranks)))
    across_.at(answer.side) = answer.across;
}

}  // namespace pardel::checker
