// pardel_witnesses FOLDER: writes the .poly files of the witnesses that a search or a formula makes, and draws the
// pictures of all witnesses in this folder.
#include <filesystem>
#include <iostream>
#include <span>

#include "../../../core/formats.hpp"
#include "witness.hpp"

namespace {
using namespace pardel;

/// Prints the message of an error.
bool succeeded(const Status& status) {
  if (!status) std::cerr << status.error().message << '\n';
  return status.ok();
}

bool renew(const properties::Witness& witness, const std::filesystem::path& folder) {
  const std::filesystem::path poly = folder / (witness.name + ".poly");
  if (witness.make != nullptr && !succeeded(write_poly(properties::to_pslg(witness.make()), poly))) return false;
  const auto pslg = read_pslg(poly);
  if (!pslg) {
    std::cerr << pslg.error().message << '\n';
    return false;
  }
  return succeeded(properties::draw(properties::to_scene(*pslg), folder / (witness.name + ".svg")));
}

}  // namespace

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  if (arguments.size() != 2) {
    std::cerr << "usage: pardel_witnesses FOLDER\n";
    return 2;
  }
  bool all_renewed = true;
  for (const properties::Witness& witness : properties::all_witnesses())
    all_renewed = renew(witness, arguments[1]) && all_renewed;
  return all_renewed ? 0 : 1;
}
