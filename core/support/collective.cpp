#include "collective.hpp"

#include <array>
#include <utility>

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

Digest sum_of(const Digest& digest, Ranks& ranks) {
  // Halves of words, so that the carry from the lower word is not lost.
  constexpr std::uint64_t half = 0xffffffffU;
  std::array parts{digest.low & half, digest.low >> 32U, digest.high & half, digest.high >> 32U};
  ranks.add_up(parts);
  const std::uint64_t second = parts[1] + (parts[0] >> 32U);
  const std::uint64_t third = parts[2] + (second >> 32U);
  return {(parts[3] + (third >> 32U)) << 32U | (third & half), second << 32U | (parts[0] & half)};
}

}  // namespace pardel
