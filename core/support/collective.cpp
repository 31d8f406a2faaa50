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

std::string text_from_first(std::string_view text, Ranks& ranks) {
  const Ranks::Bytes message = from_first(to_bytes(std::vector(text.begin(), text.end())), ranks);
  const std::vector<char> letters = list_in<char>(message);
  return {letters.begin(), letters.end()};
}

std::uint64_t sum_of(std::uint64_t value, Ranks& ranks) {
  ranks.add_up({&value, 1});
  return value;
}

LeastAndMost least_and_most_of(std::uint64_t value, Ranks& ranks) {
  const auto [least, most] = std::ranges::minmax(concatenated(lists_of_all(std::vector{value}, ranks)));
  return {least, most};
}

Digest sum_of(const Digest& digest, Ranks& ranks) {
  Digest sum;
  for (const Digest& of_rank : concatenated(lists_of_all(std::vector{digest}, ranks))) sum = sum + of_rank;
  return sum;
}

}  // namespace pardel
