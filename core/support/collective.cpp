#include "collective.hpp"

#include <algorithm>
#include <utility>

#include "exchange_lists.hpp"

namespace pardel {

std::vector<Ranks::Bytes> from_all(const Ranks::Bytes& message, Ranks& ranks) {
  return ranks.exchange(std::vector<Ranks::Bytes>(static_cast<std::size_t>(ranks.count()), message));
}

std::vector<Ranks::Bytes> to_first(Ranks::Bytes message, Ranks& ranks) {
  std::vector<Ranks::Bytes> messages(static_cast<std::size_t>(ranks.count()));
  messages.front() = std::move(message);
  return ranks.exchange(std::move(messages));
}

Ranks::Bytes from_first(const Ranks::Bytes& message, Ranks& ranks) {
  const Ranks::Bytes sent = ranks.rank() == 0 ? message : Ranks::Bytes{};
  return std::move(from_all(sent, ranks).front());
}

std::uint64_t sum_of(std::uint64_t value, Ranks& ranks) {
  ranks.add_up({&value, 1});
  return value;
}

std::uint64_t most_of(std::uint64_t value, Ranks& ranks) {
  return std::ranges::max(concatenated(lists_of_all(std::vector{value}, ranks)));
}

Digest sum_of(const Digest& digest, Ranks& ranks) {
  Digest sum;
  for (const Digest& of_rank : concatenated(lists_of_all(std::vector{digest}, ranks))) sum = sum + of_rank;
  return sum;
}

}  // namespace pardel
