#include "collective.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <utility>

namespace pardel {

std::vector<Ranks::Bytes> from_all(Ranks& ranks, const Ranks::Bytes& message) {
  return ranks.exchange(std::vector<Ranks::Bytes>(static_cast<std::size_t>(ranks.count()), message));
}

std::vector<Ranks::Bytes> to_first(Ranks& ranks, Ranks::Bytes message) {
  std::vector<Ranks::Bytes> messages(static_cast<std::size_t>(ranks.count()));
  messages.front() = std::move(message);
  return ranks.exchange(std::move(messages));
}

Ranks::Bytes from_first(Ranks& ranks, const Ranks::Bytes& message) {
  const Ranks::Bytes sent = ranks.rank() == 0 ? message : Ranks::Bytes{};
  return std::move(from_all(ranks, sent).front());
}

std::uint64_t sum_of(Ranks& ranks, std::uint64_t value) {
  ranks.add_up({&value, 1});
  return value;
}

ShareOfRank share_of_rank(Ranks& ranks, std::uint64_t here) {
  std::vector<std::uint64_t> of_rank(static_cast<std::size_t>(ranks.count()), 0);
  of_rank[static_cast<std::size_t>(ranks.rank())] = here;
  ranks.add_up(of_rank);
  ShareOfRank share;
  for (std::size_t rank = 0; rank < of_rank.size(); ++rank) {
    if (rank < static_cast<std::size_t>(ranks.rank())) share.before += of_rank[rank];
    share.all += of_rank[rank];
  }
  return share;
}

Digest sum_of(Ranks& ranks, const Digest& digest) {
  // Halves of words, so that the carry from the lower word is not lost.
  constexpr std::uint64_t half = 0xffffffffU;
  std::array parts{digest.low & half, digest.low >> 32U, digest.high & half, digest.high >> 32U};
  ranks.add_up(parts);
  const std::uint64_t second = parts[1] + (parts[0] >> 32U);
  const std::uint64_t third = parts[2] + (second >> 32U);
  return {(parts[3] + (third >> 32U)) << 32U | (third & half), second << 32U | (parts[0] & half)};
}

Status agree(Ranks& ranks, const Status& here) {
  Ranks::Bytes message;
  if (!here) {
    const std::string& text = here.error().message;
    message.resize(text.size() + 1);
    message[0] = static_cast<std::byte>(here.error().kind);
    std::memcpy(message.data() + 1, text.data(), text.size());
  }
  const std::vector<Ranks::Bytes> all = from_all(ranks, message);
  const auto failed = std::ranges::find_if(all, [](const Ranks::Bytes& from) { return !from.empty(); });
  if (failed == all.end()) return Done{};
  Error error{static_cast<ErrorKind>((*failed)[0]), {}};
  const bool is_everywhere = std::ranges::none_of(all, [](const Ranks::Bytes& from) { return from.empty(); });
  if (!is_everywhere) error.message = "rank " + std::to_string(failed - all.begin()) + ": ";
  for (std::size_t i = 1; i < failed->size(); ++i) error.message += static_cast<char>((*failed)[i]);
  return error;
}

}  // namespace pardel
