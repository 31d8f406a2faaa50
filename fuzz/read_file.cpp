// The fuzz target of one reader. Compiled once for each format; PARDEL_MAIN_FILE is the name of the file that is read.
#include "fuzz_one.hpp"
#include "readers.hpp"

namespace pardel::fuzz {

int fuzz_one(std::span<const std::uint8_t> bytes) { return fuzz_reader(bytes, PARDEL_MAIN_FILE); }

}  // namespace pardel::fuzz
