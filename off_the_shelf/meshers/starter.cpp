#include "starter.hpp"

#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "../../core/support/child_process.hpp"
#include "worker.hpp"

namespace pardel::engine {
namespace {

// The messages to the starter, and its replies. Each is one packet.
struct Request {
  enum class What : std::uint32_t { start, end };
  What what;
  Index number;
};
struct Reply {
  int error;   ///< of start: an error number; 0: the packet has a socket
  int status;  ///< of end: as from waitpid()
};

Error not_started(int error_number) {
  return {ErrorKind::resources, "no process can be started: " + std::generic_category().message(error_number)};
}

/// Sends a packet, and with it a copy of a descriptor unless its number is negative.
bool send_packet(int to, const void* data, std::size_t size, int descriptor) {
  iovec bytes{const_cast<void*>(data), size};
  alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof descriptor)> rights{};
  msghdr packet{};
  packet.msg_iov = &bytes;
  packet.msg_iovlen = 1;
  if (descriptor >= 0) {
    packet.msg_control = rights.data();
    packet.msg_controllen = rights.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&packet);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof descriptor);
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
  }
  while (sendmsg(to, &packet, MSG_NOSIGNAL) < 0)
    if (errno != EINTR) return false;
  return true;
}

/// Receives a packet, and the descriptor that comes with it. False if there is none of this size.
bool receive_packet(int from, void* data, std::size_t size, Descriptor* received = nullptr) {
  iovec bytes{data, size};
  int descriptor = -1;
  alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof descriptor)> rights{};
  msghdr packet{};
  packet.msg_iov = &bytes;
  packet.msg_iovlen = 1;
  packet.msg_control = rights.data();
  packet.msg_controllen = rights.size();
  ssize_t count = 0;
  do count = recvmsg(from, &packet, MSG_CMSG_CLOEXEC);
  while (count < 0 && errno == EINTR);
  const cmsghdr* const header = CMSG_FIRSTHDR(&packet);
  if (received != nullptr && header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    std::memcpy(&descriptor, CMSG_DATA(header), sizeof descriptor);
    *received = Descriptor(descriptor);
  }
  return count == static_cast<ssize_t>(size);
}

int wait_for_end(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) break;
  return status;
}

std::string how_it_ended(int status) {
  if (WIFEXITED(status)) return "exit code " + std::to_string(WEXITSTATUS(status));
  return signal_name(WTERMSIG(status));
}

/// Blocks all signals of this thread while it lives.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// In a new copy of the caller's process: keeps nothing that could disturb the caller. The signals of a terminal go to
/// the caller's group of processes only. exit() runs no function of the caller's, and writes no buffer of it.
void leave_caller(int descriptor) {
  setpgid(0, 0);
  const auto kept = static_cast<unsigned>(descriptor);
  if (kept > 3) close_range(3, kept - 1, 0);
  close_range(std::max(3U, kept + 1), ~0U, 0);
  on_exit([](int status, void*) { _exit(status); }, nullptr);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  pthread_sigmask(SIG_SETMASK, &none, nullptr);
}

/// Keeps free memory for the next task. A small process would otherwise return it to the system after each task and
/// take it again: measured with Triangle, this doubles the time.
void keep_memory() {
  constexpr int most_kept = 1 << 30, largest_on_heap = 1 << 25;
  mallopt(M_TRIM_THRESHOLD, most_kept);
  mallopt(M_MMAP_THRESHOLD, largest_on_heap);
}

/// The main program of the starter.
class StarterProcess {
 public:
  StarterProcess(Descriptor control, SubdomainMesher& mesher) : control_(std::move(control)), mesher_(mesher) {}

  /// Returns when the other end of the control socket is closed. What is thrown must not reach the caller of fork().
  void run() noexcept {
    Request request{};
    while (receive_packet(control_.number(), &request, sizeof request)) {
      Reply reply{};
      if (request.what == Request::What::start) {
        start(request.number);
      } else {
        reply.status = end(request.number);
        send_packet(control_.number(), &reply, sizeof reply, -1);
      }
    }
    while (!workers_.empty()) end(workers_.begin()->first);
  }

 private:
  void start(Index number) {
    auto ends = connected_sockets(SOCK_STREAM);
    const pid_t process = ends ? fork() : -1;
    Reply reply{.error = process < 0 ? errno : 0, .status = 0};
    if (process == 0) {
      ends->first = {};
      be_worker(*std::move(ends));
    }
    if (process > 0) {
      setpgid(process, process);  // here and there, so that the group exists before it is killed
      workers_[number] = process;
    }
    send_packet(control_.number(), &reply, sizeof reply, process > 0 ? ends->first.number() : -1);
  }

  [[noreturn]] void be_worker(std::pair<Descriptor, Descriptor> ends) {
    setpgid(0, 0);
    // The starter has one thread, so this signal comes when the starter ends, not when a thread of it does.
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() == starter_) {
      control_ = {};
      keep_memory();
      Channel channel(std::move(ends.second));
      serve(mesher_, channel);
    }
    _exit(0);
  }

  int end(Index number) {
    const auto worker = workers_.find(number);
    if (worker == workers_.end()) return 0;
    kill(-worker->second, SIGKILL);  // before waitpid(), while the number cannot be that of another process
    const int status = wait_for_end(worker->second);
    workers_.erase(worker);
    return status;
  }

  Descriptor control_;
  SubdomainMesher& mesher_;
  std::map<Index, pid_t> workers_;
  pid_t starter_ = getpid();
};

}  // namespace

Result<std::unique_ptr<Starter>> Starter::make(SubdomainMesher& mesher) {
  auto ends = connected_sockets(SOCK_SEQPACKET);
  if (!ends) return not_started(errno);
  pid_t process = 0;
  {
    // No handler of the caller may run in the new process.
    const BlockedSignals blocked;
    process = fork();
    if (process == 0) {
      leave_caller(ends->second.number());
      StarterProcess(std::move(ends->second), mesher).run();
      _exit(0);
    }
  }
  if (process < 0) return not_started(errno);
  return std::unique_ptr<Starter>(new Starter(std::move(ends->first), process));
}

Starter::Starter(Descriptor control, pid_t process)
    : control_(std::move(control)), process_(process), owner_(getpid()) {}

Starter::~Starter() {
  if (getpid() != owner_) return;
  shutdown(control_.number(), SHUT_RDWR);  // also if another process has a copy of the descriptor
  wait_for_end(process_);
}

Result<Channel> Starter::start(Index number) {
  const std::scoped_lock lock(one_at_a_time_);
  const Request request{Request::What::start, number};
  Reply reply{};
  Descriptor socket;
  if (!send_packet(control_.number(), &request, sizeof request, -1) ||
      !receive_packet(control_.number(), &reply, sizeof reply, &socket))
    return Error{ErrorKind::resources, "the process that starts the others has ended"};
  if (reply.error != 0) return not_started(reply.error);
  if (socket.number() < 0) return not_started(EMFILE);
  return Channel(std::move(socket));
}

std::string Starter::end(Index number) {
  const std::scoped_lock lock(one_at_a_time_);
  const Request request{Request::What::end, number};
  Reply reply{};
  if (!send_packet(control_.number(), &request, sizeof request, -1) ||
      !receive_packet(control_.number(), &reply, sizeof reply))
    return "the process that starts the others has ended";
  return how_it_ended(reply.status);
}

}  // namespace pardel::engine
