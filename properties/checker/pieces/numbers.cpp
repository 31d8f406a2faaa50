#include "numbers.hpp"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "../../../core/support/agree.hpp"
#include "../../../core/support/collective.hpp"
#include "../../../core/support/message.hpp"
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
  [[nodiscard]] std::span<const std::uint64_t> words() const { return words_; }
  static constexpr std::uint64_t no_number = UINT64_MAX;

 private:
  std::uint64_t first_;
  std::vector<std::uint64_t> words_;
};

/// The numbers that one rank compares for all pieces.
class Referee {
 public:
  Referee(std::uint64_t first, std::uint64_t end) : end_(end), known_(first, end > first ? end - first : 0) {}

  /// Takes the message of one rank: its vertices in the interior, and those at the border.
  void read(const Ranks::Bytes& message) {
    Reader reader(message);
    known_.unite(reader.list<std::uint64_t>(), contested_);
    add(reader.list<BorderVertex>());
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
  Writer message;
  message.list(here);
  std::uint64_t largest = 0;
  for (const Ranks::Bytes& from : from_all(message.take(), ranks))
    largest = std::max(largest, Reader(from).list<std::uint64_t>().at(0));
  if (listed == 0) return std::uint64_t{0};
  if (largest >= listed)
    return invalid("a point has the number " + std::to_string(largest) + ", but the pieces have only " +
                   std::to_string(listed) + " points");
  if (largest + 1 >= no_index)
    return Error{ErrorKind::resources,
                 "the mesh has " + std::to_string(largest + 1) + " points, more than can be checked at once"};
  return largest + 1;
}

/// The vertices of a piece, as it tells the referees about them.
class Witness {
 public:
  Witness(std::span<const Point> points, std::span<const std::uint64_t> number, const Adjacency& adjacency,
          const Referees& referees, Ranks& ranks)
      : points_(points), number_(number), adjacency_(adjacency), referees_(referees), ranks_(ranks) {}

  /// The messages to the referees: vertices in the interior, and those at the border. Error: a number is there twice.
  [[nodiscard]] Result<std::vector<Ranks::Bytes>> statements() const {
    std::vector<NumberSet> inner;
    for (int rank = 0; rank < ranks_.count(); ++rank) inner.emplace_back(referees_.first(rank), referees_.share());
    BorderLists border = lists();
    for (Index v = 0; v < points_.size(); ++v) {
      const auto referee = static_cast<std::size_t>(referees_.of(number_[v]));
      if (is_at_border(v, adjacency_))
        border[referee].push_back({number_[v], points_[v]});
      else if (!inner[referee].insert(number_[v]))
        return invalid("two vertices of a piece have the number " + std::to_string(number_[v]));
    }
    std::vector<Ranks::Bytes> messages;
    for (std::size_t rank = 0; rank < inner.size(); ++rank) {
      Writer message;
      message.list(inner[rank].words());
      message.list(border[rank]);
      messages.push_back(message.take());
    }
    return messages;
  }
  /// The messages about vertices in the interior with contested numbers, which are sorted.
  [[nodiscard]] std::vector<Ranks::Bytes> further_statements(const std::vector<std::uint64_t>& contested) const {
    BorderLists border = lists();
    for (Index v = 0; !contested.empty() && v < points_.size(); ++v)
      if (!is_at_border(v, adjacency_) && std::ranges::binary_search(contested, number_[v]))
        border[static_cast<std::size_t>(referees_.of(number_[v]))].push_back({number_[v], points_[v]});
    std::vector<Ranks::Bytes> messages;
    for (const std::vector<BorderVertex>& list : border) {
      Writer message;
      message.list(list);
      messages.push_back(message.take());
    }
    return messages;
  }

 private:
  using BorderLists = std::vector<std::vector<BorderVertex>>;
  [[nodiscard]] BorderLists lists() const { return BorderLists(static_cast<std::size_t>(ranks_.count())); }

  std::span<const Point> points_;
  std::span<const std::uint64_t> number_;
  const Adjacency& adjacency_;
  Referees referees_;
  Ranks& ranks_;
};

}  // namespace

Result<std::uint64_t> check_numbers(std::span<const Point> points, std::span<const std::uint64_t> number,
                                    const Adjacency& adjacency, Ranks& ranks) {
  const Result<std::uint64_t> count = count_points(number, ranks);
  if (!count) return count;
  const Referees referees(*count, ranks.count());
  const Witness witness(points, number, adjacency, referees, ranks);
  Result<std::vector<Ranks::Bytes>> statements = witness.statements();
  if (Status all = agree(statements ? Status(Done{}) : statements.error(), ranks); !all) return all.error();

  Referee referee(referees.first(ranks.rank()), std::min(*count, referees.first(ranks.rank() + 1)));
  for (const Ranks::Bytes& message : ranks.exchange(std::move(*statements))) referee.read(message);
  Writer message;
  message.list(referee.contested());
  std::vector<std::uint64_t> contested;
  for (const Ranks::Bytes& from : from_all(message.take(), ranks)) {
    const auto more = Reader(from).list<std::uint64_t>();
    contested.insert(contested.end(), more.begin(), more.end());
  }
  std::ranges::sort(contested);
  for (const Ranks::Bytes& further : ranks.exchange(witness.further_statements(contested)))
    referee.add(Reader(further).list<BorderVertex>());
  if (Status all = agree(referee.judge(), ranks); !all) return all.error();
  return *count;
}

}  // namespace pardel::checker
