#include "border.hpp"

#include <tuple>

#include "../../../core/support/exchange_lists.hpp"

namespace pardel::checker {
namespace {

/// A side on its way to the referee of the smaller one of its ends.
struct TravellingSide {
  std::uint64_t low, high;  ///< the numbers of the ends
  std::uint64_t apex;
  Point at;
  Index triangle, place;
  std::uint32_t question;  ///< its position among the sides that the rank sends to this referee
  std::int32_t rank;
  bool rising;  ///< runs from low to high
};

/// The answers to the sides that one rank has sent.
using Answers = std::vector<Across>;

Across as_across(const TravellingSide& side) { return {side.rank, side.triangle, side.place, side.apex, side.at}; }

/// Joins the first rising with the first falling side of each edge.
void join(std::vector<TravellingSide>& sides, std::vector<Answers>& answers) {
  std::ranges::sort(sides, [](const TravellingSide& a, const TravellingSide& b) {
    return std::tuple(a.low, a.high, !a.rising, a.triangle) < std::tuple(b.low, b.high, !b.rising, b.triangle);
  });
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(), [&](const TravellingSide& side) {
      return side.low != first->low || side.high != first->high;
    });
    const auto falling = std::find_if(first, last, [](const TravellingSide& side) { return !side.rising; });
    if (falling != first && falling != last) {
      answers[first->rank][first->question] = as_across(*falling);
      answers[falling->rank][falling->question] = as_across(*first);
    }
    first = last;
  }
}

}  // namespace

std::vector<BorderSide> join_border(const Piece& piece) {
  const auto boundary = piece.adjacency.boundary();
  const auto count = static_cast<std::size_t>(piece.ranks.count());
  const Referees referees(piece.points, piece.ranks.count());
  std::vector<std::vector<TravellingSide>> sent(count);
  std::vector<int> referee_of;
  for (const auto& [from, to, left] : boundary) {
    const std::uint64_t a = piece.number[from], b = piece.number[to];
    const Index apex = piece.adjacency.triangles()[left.triangle].v[left.edge];
    const int referee = referees.of(std::min(a, b));
    referee_of.push_back(referee);
    sent[referee].push_back({std::min(a, b), std::max(a, b), piece.number[apex], piece.mesh().points[apex],
                             piece.subject.names.triangle(left.triangle), left.triangle,
                             static_cast<std::uint32_t>(sent[referee].size()), piece.ranks.rank(), a < b});
  }
  const std::vector<std::vector<TravellingSide>> asked = exchange_lists(sent, piece.ranks);
  std::vector<TravellingSide> sides = concatenated(asked);
  std::vector<Answers> answers;
  for (const std::vector<TravellingSide>& of_rank : asked) answers.emplace_back(of_rank.size());
  join(sides, answers);
  const std::vector<Answers> arrived = exchange_lists(answers, piece.ranks);
  std::vector<std::size_t> next(count, 0);
  std::vector<BorderSide> border;
  for (std::size_t i = 0; i < boundary.size(); ++i)
    border.push_back({boundary[i], arrived.at(referee_of[i]).at(next[referee_of[i]]++)});
  return border;
}

}  // namespace pardel::checker
