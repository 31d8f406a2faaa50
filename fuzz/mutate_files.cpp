// The mutator of the readers. From time to time it replaces the input by a correct file of a random small mesh, domain
// or raster, or by an input that stands for one; otherwise libFuzzer changes bytes of it. So files with all their
// sections need not be guessed.
#include <algorithm>
#include <string>

#include "known_files/known_file.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  using namespace pardel::fuzz;
  pardel::generators::Random random(seed);
  const std::size_t choice = random.below(32);
  std::string input;
  if (choice == 0) input = input_for_known_file(random.next());
  if (choice == 1 || choice == 2) input = any_known_file(random, PARDEL_MAIN_FILE).bytes;
  if (input.empty() || input.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::copy(input.begin(), input.end(), data);
  return choice < 2 ? input.size() : LLVMFuzzerMutate(data, input.size(), max_size);
}
