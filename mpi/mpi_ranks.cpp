#include "mpi_ranks.hpp"

#include <mpi.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "../core/support/announcement.hpp"
#include "../core/support/stop_signal.hpp"

namespace pardel::mpi {
namespace {

constexpr int numbers_per_announcement = sizeof(Announcement) / sizeof(std::uint64_t);

/// Calls start(data, count, tag) for all parts of a message.
template <class Byte, class Start>
void for_each_part(Byte* bytes, std::size_t size, std::size_t bytes_per_part, const Start& start) {
  for (std::size_t at = 0, part = 0; at < size; at += bytes_per_part, ++part)
    start(bytes + at, static_cast<int>(std::min(bytes_per_part, size - at)), static_cast<int>(part));
}

Stopped does_not_match(int from, const std::string& what) {
  return {{ErrorKind::internal, "the message of rank " + std::to_string(from) + " " + what}};
}

}  // namespace

void check(int code) {
  if (code == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text{};
  int length = 0;
  MPI_Error_string(code, text.data(), &length);
  throw Stopped{{ErrorKind::internal, "MPI: " + std::string(text.data(), static_cast<std::size_t>(length))}};
}

MpiRanks::MpiRanks(std::size_t bytes_per_part) : bytes_per_part_(bytes_per_part) {
  check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN));
  check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_));
  check(MPI_Comm_size(MPI_COMM_WORLD, &count_));
}

/// Fills in the number and the seals of the step. Returns what the other ranks announce to this one.
std::vector<Announcement> MpiRanks::announce(std::vector<Announcement> sent) {
  ++steps_;
  for (Announcement& one : sent) {
    one.number = steps_;
    one = one.sealed();
  }
  std::vector<Announcement> announced(sent.size());
  check(MPI_Alltoall(sent.data(), numbers_per_announcement, MPI_UINT64_T, announced.data(), numbers_per_announcement,
                     MPI_UINT64_T, MPI_COMM_WORLD));
  for (int from = 0; from < count_; ++from)
    if (const std::string wrong = mismatch(announced[from], steps_, sent.front().step); !wrong.empty())
      throw does_not_match(from, wrong);
  return announced;
}

std::vector<Ranks::Bytes> MpiRanks::exchange(std::vector<Bytes> messages) {
  std::vector<Announcement> sent;
  for (int other = 0; other < count_; ++other) {
    const Bytes& message = messages[other];  // that of the rank for itself does not travel
    sent.push_back({.bytes = message.size(), .checksum = other == rank_ ? 0 : checksum(message)});
  }
  const std::vector<Announcement> announced = announce(std::move(sent));

  // All memory is taken before a request starts: MPI may write into the buffers until it has ended.
  std::vector<Bytes> arrived(count_);
  std::size_t parts = 0;
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    arrived[other].resize(announced[other].bytes);
    for (const Bytes* message : {&arrived[other], &messages[other]})
      parts += (message->size() + bytes_per_part_ - 1) / bytes_per_part_;
  }
  std::vector<MPI_Request> requests;
  requests.reserve(parts);
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    for_each_part(arrived[other].data(), arrived[other].size(), bytes_per_part_,
                  [&](std::byte* data, int count, int tag) {
                    check(MPI_Irecv(data, count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &requests.emplace_back()));
                  });
  }
  for (int other = 0; other < count_; ++other) {
    if (other == rank_) continue;
    for_each_part(messages[other].data(), messages[other].size(), bytes_per_part_,
                  [&](const std::byte* data, int count, int tag) {
                    check(MPI_Isend(data, count, MPI_BYTE, other, tag, MPI_COMM_WORLD, &requests.emplace_back()));
                  });
  }
  check(MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE));
  for (int from = 0; from < count_; ++from)
    if (from != rank_ && checksum(arrived[from]) != announced[from].checksum)
      throw does_not_match(from, "has another checksum");
  arrived[rank_] = std::move(messages[rank_]);
  return arrived;
}

void MpiRanks::add_up(std::span<std::uint64_t> values) {
  const Announcement mine{.step = RankStep::sum, .bytes = values.size_bytes()};
  const std::vector<Announcement> announced = announce(std::vector(static_cast<std::size_t>(count_), mine));
  for (int from = 0; from < count_; ++from)
    if (announced[from].bytes != mine.bytes) throw does_not_match(from, "has another number of terms");
  check(MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_UINT64_T, MPI_SUM,
                      MPI_COMM_WORLD));
}

}  // namespace pardel::mpi
