#include "numbers.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

#include "../../../core/support/agree.hpp"
#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../arithmetic/text.hpp"
#include "piece.hpp"

namespace pardel::checker {
namespace {

Error invalid(const std::string& message) { return {ErrorKind::invalid_input, message}; }

/// The numbers that one rank compares for all pieces.
class Referee {
 public:
  /// It compares the numbers from `first` to `end` - 1.
  Referee(std::uint64_t first, std::uint64_t end) : first_(first), end_(std::max(first, end)) {}

  /// Takes what one rank states: its vertices in the interior, as NumberSet::words(), and those at the border.
  void read(const std::vector<std::uint64_t>& inner, const std::vector<NumberedPoint>& border) {
    known_.unite(NumberSet(inner), contested_);
    add(border);
  }
  /// The numbers of vertices in the interior of a piece that other pieces have, too. Call it once, after all read().
  [[nodiscard]] std::vector<std::uint64_t> contested() {
    std::ranges::sort(border_, {}, &NumberedPoint::number);
    for (std::size_t i = 0; i < border_.size(); ++i) {
      const std::uint64_t number = border_[i].number - first_;
      if ((i == 0 || border_[i - 1].number != border_[i].number) && !known_.insert(number))
        contested_.push_back(number);
    }
    for (std::uint64_t& number : contested_) number += first_;
    return std::move(contested_);
  }
  void add(const std::vector<NumberedPoint>& more) { border_.insert(border_.end(), more.begin(), more.end()); }

  /// The error of the least number that has one. So the first rank with an error has that of the whole mesh.
  [[nodiscard]] Status judge() {
    const std::uint64_t missing = first_ + known_.first_missing();
    std::ranges::sort(border_, {}, [](const NumberedPoint& p) { return std::tuple(p.number, p.at.x, p.at.y); });
    const auto differ = [](const NumberedPoint& a, const NumberedPoint& b) {
      return a.number == b.number && !(a.at == b.at);
    };
    const auto two = std::ranges::adjacent_find(border_, differ);
    if (two != border_.end() && two->number < missing)
      return invalid("different points have the number " + std::to_string(two->number) + ", at " + to_text(two->at) +
                     " and " + to_text(std::next(two)->at));
    if (missing < end_) return invalid("no piece has the point with the number " + std::to_string(missing));
    return Done{};
  }

 private:
  std::uint64_t first_, end_;
  NumberSet known_;  ///< less first_
  std::vector<NumberedPoint> border_;
  std::vector<std::uint64_t> contested_;  ///< less first_
};

/// The points in the lists for their referees.
std::vector<std::vector<NumberedPoint>> to_referees(const std::vector<NumberedPoint>& points, const Referees& referees,
                                                    const Ranks& ranks) {
  std::vector<std::vector<NumberedPoint>> lists(static_cast<std::size_t>(ranks.count()));
  for (const NumberedPoint& point : points) lists[static_cast<std::size_t>(referees.of(point.number))].push_back(point);
  return lists;
}

}  // namespace

void NumbersOfRank::count(std::span<const std::uint64_t> number) {
  listed_ += number.size();
  for (const std::uint64_t one : number) largest_ = std::max(largest_, one);
}

void NumbersOfRank::add(std::span<const std::uint64_t> number, const Adjacency& adjacency) {
  NumberSet of_piece;
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] < no_index && !is_at_border(v, adjacency)) of_piece.insert(number[v]);
  }
  inner_.unite(of_piece, repeated_);
}

Result<std::uint64_t> count_points(const NumbersOfRank& here, Ranks& ranks) {
  const std::uint64_t listed = sum_of(here.listed(), ranks);
  const std::uint64_t largest = least_and_most_of(here.largest(), ranks).most;
  if (listed == 0) return std::uint64_t{0};
  if (largest >= listed)
    return invalid("a point has the number " + std::to_string(largest) + ", but the pieces have only " +
                   std::to_string(listed) + " points");
  if (largest + 1 >= no_index)
    return Error{ErrorKind::resources,
                 "the mesh has " + std::to_string(largest + 1) + " points, more than can be checked at once"};
  return largest + 1;
}

Result<std::uint64_t> check_numbers(const NumbersOfRank& here, const std::vector<NumberedPoint>& border,
                                    const FindPoints& find, Ranks& ranks) {
  Result<std::uint64_t> count = count_points(here, ranks);
  if (!count) return count;
  const Referees referees(*count, ranks.count());
  std::vector<std::vector<std::uint64_t>> inner;
  inner.reserve(static_cast<std::size_t>(ranks.count()));
  for (int rank = 0; rank < ranks.count(); ++rank)
    inner.push_back(here.inner().words(referees.first(rank), referees.share()));
  inner = exchange_lists(std::move(inner), ranks);
  const auto of_ranks = exchange_lists(to_referees(border, referees, ranks), ranks);
  Referee referee(referees.first(ranks.rank()), std::min(*count, referees.first(ranks.rank() + 1)));
  for (std::size_t rank = 0; rank < inner.size(); ++rank) referee.read(inner[rank], of_ranks[rank]);

  std::vector<std::uint64_t> contested = referee.contested();
  contested.insert(contested.end(), here.repeated().begin(), here.repeated().end());
  contested = concatenated(lists_of_all(contested, ranks));
  std::ranges::sort(contested);
  if (!contested.empty()) {
    const Result<std::vector<NumberedPoint>> found = find(contested);
    if (Status all = agree(found ? Status(Done{}) : found.error(), ranks); !all) return all.error();
    referee.add(concatenated(exchange_lists(to_referees(*found, referees, ranks), ranks)));
  }
  if (Status all = agree_on_input(referee.judge(), ranks); !all) return all.error();
  return *count;
}

}  // namespace pardel::checker
