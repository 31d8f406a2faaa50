// What all ranks do together, by means of Ranks::exchange.
#pragma once

#include <vector>

#include "../digest.hpp"
#include "../ranks.hpp"
#include "../result.hpp"

namespace pardel {

/// Sends the message to all ranks. Returns the messages of all ranks, in the order of the ranks.
[[nodiscard]] std::vector<Ranks::Bytes> from_all(Ranks& ranks, const Ranks::Bytes& message);

/// Sends the message to the first rank. Returns there the messages of all ranks, and elsewhere empty ones.
[[nodiscard]] std::vector<Ranks::Bytes> to_first(Ranks& ranks, Ranks::Bytes message);

/// Returns on all ranks the message of the first one.
[[nodiscard]] Ranks::Bytes from_first(Ranks& ranks, const Ranks::Bytes& message);

/// The sum of the values of all ranks.
[[nodiscard]] std::uint64_t sum_of(Ranks& ranks, std::uint64_t value);

/// Of things that are numbered rank by rank: how many belong to the ranks before this one, and to all ranks.
struct ShareOfRank {
  std::uint64_t before = 0, all = 0;
};
/// `here`: how many belong to this rank.
[[nodiscard]] ShareOfRank share_of_rank(Ranks& ranks, std::uint64_t here);

/// The digest of a mesh whose parts have these digests.
[[nodiscard]] Digest sum_of(Ranks& ranks, const Digest& digest);

/// The error of the first rank that has one, on all ranks. Its message names the rank, unless all ranks have an error.
[[nodiscard]] Status agree(Ranks& ranks, const Status& here);

}  // namespace pardel
