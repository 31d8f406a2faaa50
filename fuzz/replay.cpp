// replay FILE|FOLDER...: runs a fuzz target on stored inputs, without a fuzzer. Prints the path of each input before it
// runs, so after a crash the last path is the input that crashed. Fails if there are no inputs.
#include <cstdio>

#include "fuzz_one.hpp"
#include "stored_inputs.hpp"

int main(int argc, char** argv) {
  using namespace pardel::fuzz;
  std::size_t replayed = 0;
  for (int i = 1; i < argc; ++i) {
    for (const auto& file : files_below(argv[i])) {
      std::printf("%s\n", file.c_str());
      std::fflush(stdout);
      fuzz_one(bytes_of(file));
      ++replayed;
    }
  }
  std::printf("%zu inputs replayed\n", replayed);
  return replayed > 0 ? 0 : 1;
}
