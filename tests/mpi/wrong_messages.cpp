// A library for LD_PRELOAD that makes mistakes in the messages of one rank, or ends it. It uses MPI's profiling
// interface: each function MPI_X is replaced, and calls PMPI_X. PARDEL_WRONG=KIND:RANK:N names the mistake, and when it
// happens:
//   byte     one byte of the N-th message that the rank sends is changed
//   damaged       what the rank announces in its step N (an exchange or a sum) does not fit its seal
//   other_number  it announces its step N with another number
//   other_step    it announces a sum in place of an exchange, or an exchange in place of a sum
//   terms    it announces other terms of sums, from its step N on
//   longer   it announces messages that are 8 bytes longer, from its step N on. (If they were
//            shorter, MPI would have to cut messages off, and might then wait for ever.)
//   skip     it leaves out its step N, and goes on to the next one as if nothing had arrived
//   repeat   it takes part in its step N twice; for steps without messages (2 and 4: agreements)
//   signalS  it gets signal S, N microseconds after MPI_Init_thread() (before, mpirun itself may wait for ever)
//   reorder  on all ranks: messages start in random order, after random delays; this is no mistake (RANK is the seed)
#include <mpi.h>
#include <sys/types.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "../../core/support/announcement.hpp"
#include "../../properties/domains/generators/random.hpp"

namespace {

using pardel::Announcement;
using pardel::RankStep;

/// A message that has not started.
struct Waiting {
  const void* data;
  int count;
  MPI_Datatype type;
  int to, tag;
  MPI_Request* request;
};

struct Plan {
  std::string kind;
  int rank = -1;
  long number = 0;
  int self = 0;
  long steps = 0, messages = 0;
  bool skips = false;         ///< the present step
  std::vector<char> changed;  ///< the message with the wrong byte, while it is sent
  std::vector<Waiting> waiting;
  pardel::generators::Random random{0};

  Plan() {
    const char* text = std::getenv("PARDEL_WRONG");
    const std::string all = text == nullptr ? "none:0:0" : text;
    const std::size_t first = all.find(':'), second = all.find(':', first + 1);
    kind = all.substr(0, first);
    rank = std::stoi(all.substr(first + 1, second - first - 1));
    number = std::stol(all.substr(second + 1));
    PMPI_Comm_rank(MPI_COMM_WORLD, &self);
    random = pardel::generators::Random(static_cast<std::uint64_t>(rank * 100 + self));
  }
  [[nodiscard]] bool is(const char* what) const { return self == rank && kind == what; }
};

Plan& plan() {
  static Plan only;
  return only;
}

/// What the plan makes of an announcement.
void change(Announcement& one, long step) {
  const Plan& p = plan();
  const bool is_now = step == p.number, is_sum = one.step == RankStep::sum;
  const bool is_long = step >= p.number && !is_sum && one.bytes >= 8;
  if (is_now && p.is("damaged")) {
    ++one.number;
    return;
  }
  if (is_now && p.is("other_number")) ++one.number;
  if (is_now && p.is("other_step")) one.step = is_sum ? RankStep::exchange : RankStep::sum;
  if (step >= p.number && is_sum && p.is("terms")) one.bytes += 8;
  if (is_long && p.is("longer")) one.bytes += 8;
  one = one.sealed();
}

/// What another rank would announce for the same step if it had no message.
Announcement as_if_nothing_arrived(Announcement mine) {
  if (mine.step == RankStep::exchange) {
    mine.bytes = 0;
    mine.checksum = pardel::checksum({});
  }
  return mine.sealed();
}

}  // namespace

extern "C" {

int MPI_Init_thread(int* argc, char*** argv, int required, int* provided) {
  const int result = PMPI_Init_thread(argc, argv, required, provided);
  const std::string kind = plan().kind, prefix = "signal";
  if (plan().self == plan().rank && kind.starts_with(prefix))
    std::thread([signal = std::stoi(kind.substr(prefix.size())), after = plan().number] {
      std::this_thread::sleep_for(std::chrono::microseconds(after));
      kill(getpid(), signal);
    }).detach();
  return result;
}

int MPI_Alltoall(const void* sent, int sent_count, MPI_Datatype sent_type, void* received, int received_count,
                 MPI_Datatype received_type, MPI_Comm comm) {
  Plan& p = plan();
  const long step = ++p.steps;
  const auto call = [&](const void* data) {
    return PMPI_Alltoall(data, sent_count, sent_type, received, received_count, received_type, comm);
  };
  const bool is_now = step == p.number;
  if (is_now && p.is("repeat")) call(sent);
  int ranks = 0;
  PMPI_Comm_size(comm, &ranks);
  std::vector<Announcement> announced(static_cast<std::size_t>(ranks));
  std::memcpy(announced.data(), sent, announced.size() * sizeof(Announcement));
  p.skips = is_now && p.is("skip");
  if (p.skips) {
    for (Announcement& one : announced) one = as_if_nothing_arrived(one);
    std::memcpy(received, announced.data(), announced.size() * sizeof(Announcement));
    return MPI_SUCCESS;
  }
  for (Announcement& one : announced) change(one, step);
  return call(announced.data());
}

int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm comm, MPI_Request* request) {
  Plan& p = plan();
  if (p.skips) {
    *request = MPI_REQUEST_NULL;
    return MPI_SUCCESS;
  }
  if (p.kind == "reorder") {
    p.waiting.push_back({data, count, type, to, tag, request});
    return MPI_SUCCESS;
  }
  if (++p.messages == p.number && p.is("byte")) {
    p.changed.assign(static_cast<const char*>(data), static_cast<const char*>(data) + count);
    p.changed[p.changed.size() / 2] ^= 1;
    data = p.changed.data();
  }
  return PMPI_Isend(data, count, type, to, tag, comm, request);
}

int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  Plan& p = plan();
  p.random.shuffle(p.waiting);
  for (const Waiting& message : p.waiting) {
    std::this_thread::sleep_for(std::chrono::microseconds(p.random.below(200)));
    PMPI_Isend(message.data, message.count, message.type, message.to, message.tag, MPI_COMM_WORLD, message.request);
  }
  p.waiting.clear();
  return PMPI_Waitall(count, requests, statuses);
}

int MPI_Allreduce(const void* sent, void* received, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  return plan().skips ? MPI_SUCCESS : PMPI_Allreduce(sent, received, count, type, op, comm);
}

}  // extern "C"
