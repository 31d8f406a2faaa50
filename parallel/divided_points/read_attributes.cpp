#include "read_attributes.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/share_of_rank.hpp"

namespace pardel::engine {

ReadAttributes::ReadAttributes(PartOfPoints& read, Ranks& ranks)
    : per_point_(std::exchange(read.attributes_per_point, 0)),
      values_(std::exchange(read.point_attributes, {})),
      first_(concatenated(lists_of_all(std::vector{share_of_rank(read.points.size(), ranks).before}, ranks))) {}

std::vector<double> ReadAttributes::of(const std::vector<std::uint64_t>& numbers, Ranks& ranks) const {
  const auto reader = [&](std::size_t i) {
    return static_cast<int>(std::ranges::upper_bound(first_, numbers[i]) - first_.begin()) - 1;
  };
  const auto answer = [&](const std::vector<std::uint64_t>& asked) {
    std::vector<double> answers;
    answers.reserve(per_point_ * asked.size());
    for (const std::uint64_t number : asked) {
      const std::uint64_t first = first_[ranks.rank()], end = (number - first + 1) * per_point_;
      if (number < first || end > values_.size()) throw Reader::does_not_match();
      const auto last = values_.begin() + static_cast<std::ptrdiff_t>(end);
      answers.insert(answers.end(), last - static_cast<std::ptrdiff_t>(per_point_), last);
    }
    return answers;
  };
  return answers_of_ranks<double>(numbers, per_point_, ranks, reader, answer);
}

}  // namespace pardel::engine
