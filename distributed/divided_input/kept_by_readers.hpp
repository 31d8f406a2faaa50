// Values that stay with the ranks that have read them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../core/pslg.hpp"
#include "../../core/ranks.hpp"
#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/share_of_rank.hpp"

namespace pardel::engine {

/// The values of items that are numbered rank by rank, as the ranks have read them. Others find them by the number of
/// the item. So they need not travel with the items, and no rank searches for a number.
template <class Value>
class KeptByReaders {
 public:
  /// Collective. `values`: those of the items that this rank has read, item by item.
  KeptByReaders(std::vector<Value> values, std::size_t per_item, std::uint64_t items, Ranks& ranks)
      : per_item_(per_item),
        values_(std::move(values)),
        first_(concatenated(lists_of_all(std::vector{share_of_rank(items, ranks).before}, ranks))) {}

  [[nodiscard]] std::size_t per_item() const { return per_item_; }
  /// The values of the items with these numbers, item by item. Collective.
  [[nodiscard]] std::vector<Value> of(const std::vector<std::uint64_t>& numbers, Ranks& ranks) const {
    const auto reader = [&](std::size_t i) {
      return static_cast<int>(std::ranges::upper_bound(first_, numbers[i]) - first_.begin()) - 1;
    };
    const auto answer = [&](const std::vector<std::uint64_t>& asked) {
      std::vector<Value> answers;
      answers.reserve(per_item_ * asked.size());
      for (const std::uint64_t number : asked) {
        const std::uint64_t first = first_[ranks.rank()], end = (number - first + 1) * per_item_;
        if (number < first || end > values_.size()) throw Reader::does_not_match();
        const auto last = values_.begin() + static_cast<std::ptrdiff_t>(end);
        answers.insert(answers.end(), last - static_cast<std::ptrdiff_t>(per_item_), last);
      }
      return answers;
    };
    return answers_of_ranks<Value>(numbers, per_item_, ranks, reader, answer);
  }

 private:
  std::size_t per_item_;
  std::vector<Value> values_;
  std::vector<std::uint64_t> first_;  ///< for each rank, the number of the first item that it has read
};

/// The points and segments of a domain, and the attributes of the points.
struct KeptDomain {
  KeptByReaders<double> attributes;
  KeptByReaders<Point> points;
  KeptByReaders<Segment> segments;
};

}  // namespace pardel::engine
