// Makes meshes of all kinds, and prints how many of each the checker refuses; of right ones, how many it accepts.
#include <charconv>
#include <cstdio>
#include <cstring>

#include "wrong_mesh.hpp"

namespace {

using namespace pardel;

/// The number after an option, or `otherwise` if the option is not there. Ends the program if it is no number.
std::uint64_t number(int argc, char** argv, const char* option, std::uint64_t otherwise) {
  for (int i = 1; i + 1 < argc; ++i) {
    if (std::strcmp(argv[i], option) != 0) continue;
    const char* end = argv[i + 1] + std::strlen(argv[i + 1]);
    std::uint64_t value = 0;
    if (std::from_chars(argv[i + 1], end, value).ptr == end) return value;
    std::fprintf(stderr, "%s: not a number: %s\n", option, argv[i + 1]);
    std::exit(2);
  }
  return otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc % 2 == 0) {
    std::fputs("usage: wrong_meshes [--seed N] [--cases N]\n", stderr);
    return 2;
  }
  const std::uint64_t seed = number(argc, argv, "--seed", 1), cases = number(argc, argv, "--cases", 100);
  int status = 0;
  std::uint64_t all = 0;
  std::printf("%-20s %-72s %7s %7s\n", "family", "kind", "cases", "found");
  for (const wrong_meshes::Kind& kind : wrong_meshes::all()) {
    std::uint64_t made = 0, found = 0;
    std::string first;
    for (std::uint64_t i = 0; i < cases; ++i) {
      const auto mesh = wrong_meshes::make(kind, seed + i);
      if (!mesh) continue;
      ++made;
      const std::string missed =
          wrong_meshes::missed(kind, *mesh, check(mesh->pslg, mesh->mesh, mesh->goal, mesh->options));
      if (missed.empty())
        ++found;
      else if (first.empty())
        first = "seed " + std::to_string(seed + i) + ": " + missed;
    }
    all += made;
    std::printf("%-20.*s %-72.*s %7ju %7ju\n", int(kind.family.size()), kind.family.data(), int(kind.name.size()),
                kind.name.data(), std::uintmax_t(made), std::uintmax_t(found));
    if (made == 0) first = "no mesh could be made";
    if (!first.empty()) {
      std::printf("    %s\n", first.c_str());
      status = 1;
    }
  }
  std::printf("%zu kinds, %ju meshes\n", wrong_meshes::all().size(), std::uintmax_t(all));
  return status;
}
