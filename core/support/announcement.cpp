#include "announcement.hpp"

#include <array>
#include <cstring>

#include "hash.hpp"

namespace pardel {
namespace {

std::string name_of(std::uint64_t number, RankStep step) {
  return (step == RankStep::sum ? "sum " : "exchange ") + std::to_string(number);
}

}  // namespace

Announcement Announcement::sealed() const {
  Announcement result = *this;
  result.seal = mixed(mixed(mixed(mixed(number) + static_cast<std::uint64_t>(step)) + bytes) + checksum);
  return result;
}

std::string mismatch(const Announcement& theirs, std::uint64_t number, RankStep step) {
  if (theirs.seal != theirs.sealed().seal) return "is announced by damaged numbers";
  if (theirs.number != number || theirs.step != step)
    return "belongs to " + name_of(theirs.number, theirs.step) + ", not to " + name_of(number, step);
  return {};
}

std::uint64_t checksum(std::span<const std::byte> bytes) {
  // Four sums at a time, so that the processor need not wait for one before it continues with the next.
  std::array<std::uint64_t, 4> sums{1, 2, 3, 4};
  std::size_t i = 0;
  for (; i + sizeof sums <= bytes.size(); i += sizeof sums) {
    std::array<std::uint64_t, 4> words{};
    std::memcpy(words.data(), bytes.data() + i, sizeof words);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      sums[k] = (sums[k] ^ words[k]) * 0x9e3779b97f4a7c15u;
      sums[k] ^= sums[k] >> 29U;
    }
  }
  std::uint64_t all = mixed(bytes.size());
  for (const std::uint64_t sum : sums) all = mixed(all + sum);
  for (; i < bytes.size(); ++i) all = mixed(all + std::to_integer<std::uint64_t>(bytes[i]));
  return all;
}

}  // namespace pardel
