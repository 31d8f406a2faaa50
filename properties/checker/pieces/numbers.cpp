#include "numbers.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/support/agree.hpp"
#include "../../../core/support/collective.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "piece.hpp"

namespace pardel::checker {
namespace {

Error invalid(const std::string& message) { return {ErrorKind::invalid_input, message}; }

struct BorderVertex {
  std::uint64_t number;
  Point at;
};

/// A set of numbers from a first one on, one bit each.
class NumberSet {
 public:
  static constexpr std::uint64_t bits = 64;

  NumberSet(std::uint64_t first, std::uint64_t count) : first_(first), words_((count + bits - 1) / bits) {}
  /// False if the number is in the set already.
  bool insert(std::uint64_t number) {
    const std::uint64_t at = number - first_, bit = std::uint64_t{1} << at % bits;
    const bool is_new = (words_[at / bits] & bit) == 0;
    words_[at / bits] |= bit;
    return is_new;
  }
  /// Adds the other set, and appends the numbers that both sets have to `common`.
  void unite(std::span<const std::uint64_t> other, std::vector<std::uint64_t>& common) {
    for (std::size_t i = 0; i < std::min(words_.size(), other.size()); ++i) {
      for (std::uint64_t both = words_[i] & other[i]; both != 0; both &= both - 1)
        common.push_back(first_ + i * bits + static_cast<std::uint64_t>(std::countr_zero(both)));
      words_[i] |= other[i];
    }
  }
  /// The least number below `end` that is not in the set; no_number if there is none.
  [[nodiscard]] std::uint64_t missing(std::uint64_t end) const {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const std::uint64_t number = first_ + i * bits + static_cast<std::uint64_t>(std::countr_one(words_[i]));
      if (~words_[i] != 0) return number < end ? number : no_number;
    }
    return no_number;
  }
  [[nodiscard]] std::vector<std::uint64_t> take_words() && { return std::move(words_); }
  static constexpr std::uint64_t no_number = UINT64_MAX;

 private:
  std::uint64_t first_;
  std::vector<std::uint64_t> words_;
};

/// The numbers that one rank compares for all pieces.
class Referee {
 public:
  Referee(std::uint64_t first, std::uint64_t end) : end_(end), known_(first, end > first ? end - first : 0) {}

  /// Takes what one rank states: its vertices in the interior, as the words of a NumberSet, and those at the border.
  void read(const std::vector<std::uint64_t>& inner, const std::vector<BorderVertex>& border) {
    known_.unite(inner, contested_);
    add(border);
  }
  /// The numbers of vertices in the interior of a piece that other pieces have, too. Call it once, after all read().
  [[nodiscard]] const std::vector<std::uint64_t>& contested() {
    std::ranges::sort(border_, {}, &BorderVertex::number);
    for (std::size_t i = 0; i < border_.size(); ++i)
      if ((i == 0 || border_[i - 1].number != border_[i].number) && !known_.insert(border_[i].number))
        contested_.push_back(border_[i].number);
    return contested_;
  }
  void add(const std::vector<BorderVertex>& more) { border_.insert(border_.end(), more.begin(), more.end()); }

  [[nodiscard]] Status judge() {
    if (const std::uint64_t missing = known_.missing(end_); missing != NumberSet::no_number)
      return invalid("no piece has the point with the number " + std::to_string(missing));
    std::ranges::sort(border_, {}, &BorderVertex::number);
    for (std::size_t i = 1; i < border_.size(); ++i)
      if (border_[i - 1].number == border_[i].number && !(border_[i - 1].at == border_[i].at))
        return invalid("two pieces have different points with the number " + std::to_string(border_[i].number));
    return Done{};
  }

 private:
  std::uint64_t end_;
  NumberSet known_;
  std::vector<BorderVertex> border_;
  std::vector<std::uint64_t> contested_;
};

/// The number of points of the whole mesh, from the largest number. All pieces together have at least as many points.
Result<std::uint64_t> count_points(std::span<const std::uint64_t> number, Ranks& ranks) {
  const std::uint64_t listed = sum_of(number.size(), ranks);
  const std::vector<std::uint64_t> here{number.empty() ? 0 : *std::ranges::max_element(number)};
  const std::uint64_t largest = std::ranges::max(concatenated(lists_of_all(here, ranks)));
  if (listed == 0) return std::uint64_t{0};
  if (largest >= listed)
    return invalid("a point has the number " + std::to_string(largest) + ", but the pieces have only " +
                   std::to_string(listed) + " points");
  if (largest + 1 >= no_index)
    return Error{ErrorKind::resources,
                 "the mesh has " + std::to_string(largest + 1) + " points, more than can be checked at once"};
  return largest + 1;
}

/// What a piece states about its vertices, to each referee.
struct Statements {
  std::vector<std::vector<std::uint64_t>> inner;  ///< the words of a NumberSet
  std::vector<std::vector<BorderVertex>> border;
};

/// Error: a number is there twice.
Result<Statements> statements(std::span<const Point> points, std::span<const std::uint64_t> number,
                              const Adjacency& adjacency, const Referees& referees, const Ranks& ranks) {
  std::vector<NumberSet> inner;
  for (int rank = 0; rank < ranks.count(); ++rank) inner.emplace_back(referees.first(rank), referees.share());
  Statements result{{}, std::vector<std::vector<BorderVertex>>(inner.size())};
  for (Index v = 0; v < points.size(); ++v) {
    const auto referee = static_cast<std::size_t>(referees.of(number[v]));
    if (is_at_border(v, adjacency))
      result.border[referee].push_back({number[v], points[v]});
    else if (!inner[referee].insert(number[v]))
      return invalid("two vertices of a piece have the number " + std::to_string(number[v]));
  }
  for (NumberSet& set : inner) result.inner.push_back(std::move(set).take_words());
  return result;
}

/// To each referee, the vertices in the interior with contested numbers. `contested` is sorted.
std::vector<std::vector<BorderVertex>> contested_vertices(const std::vector<std::uint64_t>& contested,
                                                          std::span<const Point> points,
                                                          std::span<const std::uint64_t> number,
                                                          const Adjacency& adjacency, const Referees& referees,
                                                          const Ranks& ranks) {
  std::vector<std::vector<BorderVertex>> result(static_cast<std::size_t>(ranks.count()));
  for (Index v = 0; !contested.empty() && v < points.size(); ++v)
    if (!is_at_border(v, adjacency) && std::ranges::binary_search(contested, number[v]))
      result[static_cast<std::size_t>(referees.of(number[v]))].push_back({number[v], points[v]});
  return result;
}

}  // namespace

Result<std::uint64_t> check_numbers(std::span<const Point> points, std::span<const std::uint64_t> number,
                                    const Adjacency& adjacency, Ranks& ranks) {
  const Result<std::uint64_t> count = count_points(number, ranks);
  if (!count) return count;
  const Referees referees(*count, ranks.count());
  const Result<Statements> here = statements(points, number, adjacency, referees, ranks);
  if (Status all = agree(here ? Status(Done{}) : here.error(), ranks); !all) return all.error();
  const auto inner = exchange_lists(here->inner, ranks);
  const auto border = exchange_lists(here->border, ranks);
  Referee referee(referees.first(ranks.rank()), std::min(*count, referees.first(ranks.rank() + 1)));
  for (std::size_t rank = 0; rank < inner.size(); ++rank) referee.read(inner[rank], border[rank]);

  std::vector<std::uint64_t> contested = concatenated(lists_of_all(referee.contested(), ranks));
  std::ranges::sort(contested);
  referee.add(
      concatenated(exchange_lists(contested_vertices(contested, points, number, adjacency, referees, ranks), ranks)));
  if (Status all = agree(referee.judge(), ranks); !all) return all.error();
  return *count;
}

}  // namespace pardel::checker
