// A library for LD_PRELOAD that lets calls of the system's functions fail. Two environment variables control it:
//   PARDEL_FAULT=KIND:N   call number N of this kind fails (from 1; 0: none)
//   PARDEL_FAULT=KIND:N+  that call and all later ones of this kind fail
//   PARDEL_FAULT=large:B  all calls for at least B bytes of memory of its own fail
//   PARDEL_CALLS=FILE     when the process ends, the number of calls of the kind is written to FILE
// Kinds: memory, map, open, unnamed, read, write, short, sync, close, rename, link, thread. `unnamed`: a file without a
// name (O_TMPFILE) cannot be made, as on file systems that have none. `short` lets fwrite and pwrite write only the
// first half of their bytes. Calls are counted from the beginning of main() to its end, because a program has
// no say before and after. Writing to standard error never fails: a test could not see the message.
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* block, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
}

namespace {

/// What PARDEL_FAULT asks for. It is read at the beginning of main() and allocates nothing.
struct Plan {
  std::string_view kind = {};
  long first = 0;
  bool and_later = false;
};
Plan plan;
std::atomic<long> calls{0};
std::atomic<bool> counts{false};
int (*real_main)(int, char**, char**) = nullptr;
std::atomic<std::FILE*> unreadable{nullptr};

void read_plan() {
  const char* text = std::getenv("PARDEL_FAULT");
  const char* colon = text != nullptr ? std::strchr(text, ':') : nullptr;
  if (colon == nullptr) return;
  char* end = nullptr;
  plan = {{text, static_cast<std::size_t>(colon - text)}, std::strtol(colon + 1, &end, 10), false};
  plan.and_later = *end == '+';
}

/// Counts a call of this kind. True if it has to fail.
bool fails(std::string_view kind) {
  if (!counts.load(std::memory_order_relaxed) || kind != plan.kind) return false;
  const long number = ++calls;
  return plan.first > 0 && (plan.and_later ? number >= plan.first : number == plan.first);
}

bool fails(std::string_view kind, int error) {
  if (!fails(kind)) return false;
  errno = error;
  return true;
}

/// True if a call for memory has to fail.
bool fails_for(std::string_view kind, std::size_t bytes) {
  if (fails(kind, ENOMEM)) return true;
  if (plan.kind != "large" || !counts.load(std::memory_order_relaxed)) return false;
  if (bytes < static_cast<std::size_t>(plan.first)) return false;
  errno = ENOMEM;
  return true;
}

/// The function of this name that the program would call without this library.
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

void write_number_of_calls() {
  const char* file = std::getenv("PARDEL_CALLS");
  if (file == nullptr) return;
  const int fd = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (fd >= 0) dprintf(fd, "%ld\n", calls.load());
}

int counting_main(int argc, char** argv, char** environment) {
  read_plan();
  counts = true;
  const int code = real_main(argc, argv, environment);
  counts = false;
  write_number_of_calls();
  return code;
}

}  // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader)(), void* stack_end) {
  real_main = main;
  return next<decltype(__libc_start_main)>("__libc_start_main")(counting_main, argc, argv, init, fini, loader,
                                                                stack_end);
}

void* malloc(std::size_t bytes) { return fails_for("memory", bytes) ? nullptr : __libc_malloc(bytes); }
void* calloc(std::size_t count, std::size_t bytes) {
  return fails_for("memory", count * bytes) ? nullptr : __libc_calloc(count, bytes);
}
void* realloc(void* block, std::size_t bytes) {
  return fails_for("memory", bytes) ? nullptr : __libc_realloc(block, bytes);
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return fails_for("memory", bytes) ? nullptr : __libc_memalign(alignment, bytes);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t bytes) {
  if (fails_for("memory", bytes)) return ENOMEM;
  *block = __libc_memalign(alignment, bytes);
  return *block == nullptr ? ENOMEM : 0;
}

void* mmap(void* place, std::size_t bytes, int protection, int flags, int fd, off_t offset) {
  // A shared mapping is a message between processes, as MPI makes them.
  const bool fail = (flags & MAP_SHARED) != 0 ? fails("map", ENOMEM) : fails_for("map", bytes);
  return fail ? MAP_FAILED : next<decltype(mmap)>("mmap")(place, bytes, protection, flags, fd, offset);
}
void* mremap(void* block, std::size_t old_bytes, std::size_t new_bytes, int flags, ...) {
  return fails_for("map", new_bytes) ? MAP_FAILED
                                     : next<decltype(mremap)>("mremap")(block, old_bytes, new_bytes, flags);
}

std::FILE* fopen(const char* file, const char* mode) {
  return fails("open", EMFILE) ? nullptr : next<decltype(fopen)>("fopen")(file, mode);
}
std::FILE* fopen64(const char* file, const char* mode) {
  return fails("open", EMFILE) ? nullptr : next<decltype(fopen)>("fopen64")(file, mode);
}
std::FILE* fdopen(int fd, const char* mode) {
  return fails("open", ENOMEM) ? nullptr : next<decltype(fdopen)>("fdopen")(fd, mode);
}
int dup(int fd) { return fails("open", EMFILE) ? -1 : next<decltype(dup)>("dup")(fd); }
int open(const char* file, int flags, ...) {
  const bool is_unnamed = (flags & O_TMPFILE) == O_TMPFILE;
  if (fails("open", EMFILE) || (is_unnamed && fails("unnamed", EOPNOTSUPP))) return -1;
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 || is_unnamed ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  return next<decltype(open)>("open")(file, flags, mode);
}

/// After a failed call, ferror() reports an error of the file.
std::size_t fread(void* data, std::size_t size, std::size_t count, std::FILE* file) {
  if (!fails("read", EIO)) return next<decltype(fread)>("fread")(data, size, count, file);
  unreadable = file;
  return 0;
}
int ferror(std::FILE* file) { return file == unreadable ? 1 : next<decltype(ferror)>("ferror")(file); }

std::size_t fwrite(const void* data, std::size_t size, std::size_t count, std::FILE* file) {
  const auto write = next<decltype(fwrite)>("fwrite");
  if (file == stderr) return write(data, size, count, file);
  if (fails("write", ENOSPC)) return 0;
  if (!fails("short")) return write(data, size, count, file);
  const std::size_t half = write(data, size, count / 2, file);
  errno = ENOSPC;
  return half;
}
ssize_t pwrite(int fd, const void* data, std::size_t size, off_t offset) {
  if (fails("write", ENOSPC)) return -1;
  return next<decltype(pwrite)>("pwrite")(fd, data, fails("short") ? (size + 1) / 2 : size, offset);
}
int fflush(std::FILE* file) { return fails("write", ENOSPC) ? EOF : next<decltype(fflush)>("fflush")(file); }
int fsync(int fd) { return fails("sync", EIO) ? -1 : next<decltype(fsync)>("fsync")(fd); }
/// A file that cannot be closed without an error is closed nevertheless.
int fclose(std::FILE* file) {
  if (file == unreadable) unreadable = nullptr;  // another file may get the same address
  const int result = next<decltype(fclose)>("fclose")(file);
  return fails("close", EIO) ? EOF : result;
}

/// Counts only the files to which a program only writes; libraries close much else.
int close(int fd) {
  struct stat about {};
  const bool is_output = counts.load(std::memory_order_relaxed) && (fcntl(fd, F_GETFL) & O_ACCMODE) == O_WRONLY &&
                         fstat(fd, &about) == 0 && S_ISREG(about.st_mode);
  const int result = next<decltype(close)>("close")(fd);
  return is_output && fails("close", EIO) ? -1 : result;
}

int rename(const char* from, const char* to) {
  return fails("rename", EACCES) ? -1 : next<decltype(rename)>("rename")(from, to);
}

int link(const char* from, const char* to) {
  return fails("link", EPERM) ? -1 : next<decltype(link)>("link")(from, to);
}

/// Gives a file without a name its name.
int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) {
  return fails("link", EPERM) ? -1 : next<decltype(linkat)>("linkat")(from_folder, from, to_folder, to, flags);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*), void* argument) {
  return fails("thread") ? EAGAIN
                         : next<decltype(pthread_create)>("pthread_create")(thread, attributes, work, argument);
}

}  // extern "C"
