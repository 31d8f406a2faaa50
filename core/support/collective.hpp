// What all ranks do together, by means of Ranks::exchange.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "../digest.hpp"
#include "../ranks.hpp"

namespace pardel {

/// Sends the message to all ranks. Returns the messages of all ranks, in the order of the ranks.
[[nodiscard]] std::vector<Ranks::Bytes> from_all(const Ranks::Bytes& message, Ranks& ranks);

/// Sends the message to the first rank. Returns there the messages of all ranks, and elsewhere empty ones.
[[nodiscard]] std::vector<Ranks::Bytes> to_first(Ranks::Bytes message, Ranks& ranks);

/// Returns on all ranks the message of the first one.
[[nodiscard]] Ranks::Bytes from_first(const Ranks::Bytes& message, Ranks& ranks);
/// The same for a text.
[[nodiscard]] std::string text_from_first(std::string_view text, Ranks& ranks);

/// The sum of the values of all ranks.
[[nodiscard]] std::uint64_t sum_of(std::uint64_t value, Ranks& ranks);

struct LeastAndMost {
  std::uint64_t least, most;
};
/// Of the values of all ranks.
[[nodiscard]] LeastAndMost least_and_most_of(std::uint64_t value, Ranks& ranks);

/// The digest of a mesh whose parts have these digests.
[[nodiscard]] Digest sum_of(const Digest& digest, Ranks& ranks);

}  // namespace pardel
