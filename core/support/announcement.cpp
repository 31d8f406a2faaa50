#include "announcement.hpp"

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
  std::uint64_t sum = mixed(bytes.size());
  std::size_t i = 0;
  for (; i + sizeof sum <= bytes.size(); i += sizeof sum) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, sizeof word);
    sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
    sum ^= sum >> 29U;
  }
  for (; i < bytes.size(); ++i) sum = mixed(sum + std::to_integer<std::uint64_t>(bytes[i]));
  return sum;
}

}  // namespace pardel
