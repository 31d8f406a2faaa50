// Prints the file `runs`.
#include <iostream>

#include "run_record.hpp"

int main() {
  namespace recorded = pardel::recorded;
  std::cout << "# What the stages of the engine do (recorded_runs_test.cpp). Made by\n"
               "#   cmake --build BUILD --target recorded_runs\n"
               "# which is right when the algorithm was changed on purpose, and only then.\n";
  for (const auto& run : recorded::runs())
    for (const std::string& line : recorded::kept(run, recorded::record(run))) std::cout << line << '\n';
  for (const auto& cloud : recorded::clouds())
    for (const std::string& line : recorded::kept(cloud, recorded::record(cloud))) std::cout << line << '\n';
  for (const auto& mess : recorded::messes())
    for (const std::string& line : recorded::kept(mess, recorded::record(mess))) std::cout << line << '\n';
}
