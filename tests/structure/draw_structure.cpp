// draw_structure ROOT: prints the includes between the folders of the repository, each with the number of #include
// lines.
#include <cstdio>

#include "rules.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw_structure ROOT\n");
    return 2;
  }
  using namespace pardel::structure;
  for (const std::string& arrow : drawing(read_source_tree(argv[1]))) std::printf("%s\n", arrow.c_str());
}
