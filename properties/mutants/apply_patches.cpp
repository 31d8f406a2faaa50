// apply_patches ROOT COPY FOLDER...: makes a copy of the project's sources that contains all mutants. patch.hpp
// describes the patches and the copy.
#include <exception>
#include <iostream>

#include "patch.hpp"

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::cerr << "usage: apply_patches ROOT COPY FOLDER...\n";
    return 2;
  }
  const auto errors = pardel::mutants::copy_with_mutants(argv[1], {argv + 3, argv + argc}, argv[2]);
  for (const std::string& error : errors) std::cerr << "error: " << error << '\n';
  return errors.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 1;
}
