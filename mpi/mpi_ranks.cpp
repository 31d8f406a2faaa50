#include "mpi_ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "../core/support/hash.hpp"
#include "../core/support/stop_signal.hpp"

namespace pardel::mpi {
namespace {

/// What a rank tells another one before it sends a message.
struct Announcement {
  std::uint64_t exchange, bytes, checksum;
};
constexpr int numbers_per_announcement = sizeof(Announcement) / sizeof(std::uint64_t);

/// MPI counts the elements of a message with an int, so long messages travel in parts.
constexpr std::size_t bytes_per_part = std::size_t{1} << 30U;

std::uint64_t checksum(const Ranks::Bytes& bytes) {
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

std::size_t parts_of(std::size_t bytes) { return (bytes + bytes_per_part - 1) / bytes_per_part; }

/// Calls start(data, count, tag) for all parts of a message.
template <class Byte, class Start>
void for_each_part(Byte* bytes, std::size_t size, const Start& start) {
  for (std::size_t at = 0, part = 0; at < size; at += bytes_per_part, ++part)
    start(bytes + at, static_cast<int>(std::min(bytes_per_part, size - at)), static_cast<int>(part));
}

Stopped does_not_match(int from, const std::string& what) {
  return {{ErrorKind::internal, "the message of rank " + std::to_string(from) + " " + what}};
}

}  // namespace

MpiRanks::MpiRanks() {
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
}

std::vector<Ranks::Bytes> MpiRanks::exchange(std::vector<Bytes> messages) {
  ++exchanges_;
  std::vector<Announcement> sent, announced(count_);
  for (const Bytes& message : messages) sent.push_back({exchanges_, message.size(), checksum(message)});
  MPI_Alltoall(sent.data(), numbers_per_announcement, MPI_UINT64_T, announced.data(), numbers_per_announcement,
               MPI_UINT64_T, MPI_COMM_WORLD);
  for (int from = 0; from < count_; ++from)
    if (announced[from].exchange != exchanges_)
      throw does_not_match(from, "belongs to exchange " + std::to_string(announced[from].exchange) + ", not to " +
                                     std::to_string(exchanges_));

  // All memory is taken before a request starts: MPI may write into the buffers until it has ended.
  std::vector<Bytes> arrived(count_);
  std::size_t parts = 0;
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    arrived[other].resize(announced[other].bytes);
    parts += parts_of(arrived[other].size()) + parts_of(messages[other].size());
  }
  std::vector<MPI_Request> requests;
  requests.reserve(parts);
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    for_each_part(arrived[other].data(), arrived[other].size(), [&](std::byte* data, int count, int tag) {
      MPI_Irecv(data, count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &requests.emplace_back());
    });
  }
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    for_each_part(messages[other].data(), messages[other].size(), [&](const std::byte* data, int count, int tag) {
      MPI_Isend(data, count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &requests.emplace_back());
    });
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  arrived[rank_] = std::move(messages[rank_]);
  for (int from = 0; from < count_; ++from)
    if (checksum(arrived[from]) != announced[from].checksum) throw does_not_match(from, "has another checksum");
  return arrived;
}

void MpiRanks::add_up(std::span<std::uint64_t> values) {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_UINT64_T, MPI_SUM, MPI_COMM_WORLD);
}

}  // namespace pardel::mpi
