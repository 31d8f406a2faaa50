// What ranks tell each other before they communicate, so that they notice when they no longer do the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace pardel {

/// The two functions of Ranks that communicate.
enum class RankStep : std::uint64_t { exchange = 1, sum = 2 };

/// What a rank is about to do with another one.
struct Announcement {
  std::uint64_t number = 0;  ///< of the step, counted from 1
  RankStep step = RankStep::exchange;
  std::uint64_t bytes = 0;     ///< of the message, or of the terms of a sum
  std::uint64_t checksum = 0;  ///< of the message; of a sum: 0
  std::uint64_t seal = 0;      ///< of the numbers above

  /// The same with its seal.
  [[nodiscard]] Announcement sealed() const;
};

/// What is wrong with the announcement of another rank: "belongs to sum 3, not to exchange 3". Empty if it belongs to
/// this step.
[[nodiscard]] std::string mismatch(const Announcement& theirs, std::uint64_t number, RankStep step);

/// Another number for nearly every other sequence of bytes. O(bytes).
[[nodiscard]] std::uint64_t checksum(std::span<const std::byte> bytes);

}  // namespace pardel
