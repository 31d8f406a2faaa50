// replay FILE|FOLDER...: runs a fuzz target on stored inputs, without a fuzzer. Prints the path of each input before it
// runs, so after a crash the last path is the input that crashed. Exit code 1: there are no inputs; 2: an input cannot
// be read.
#include <cstdio>
#include <optional>
#include <system_error>

#include "fuzz_one.hpp"
#include "stored_inputs.hpp"

namespace {

/// What read(place) returns. If it throws std::system_error: prints the message, and returns nothing.
template <class Read>
auto read_or_complain(const Read& read, const std::filesystem::path& place) -> std::optional<decltype(read(place))> {
  try {
    return read(place);
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "replay: %s\n", error.what());
    return {};
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pardel::fuzz;
  std::size_t replayed = 0;
  for (int i = 1; i < argc; ++i) {
    const auto files = read_or_complain(files_below, argv[i]);
    if (!files) return 2;
    for (const auto& file : *files) {
      std::printf("%s\n", file.c_str());
      std::fflush(stdout);
      const auto bytes = read_or_complain(bytes_of, file);
      if (!bytes) return 2;
      fuzz_one(*bytes);
      ++replayed;
    }
  }
  std::printf("%zu inputs replayed\n", replayed);
  return replayed > 0 ? 0 : 1;
}
