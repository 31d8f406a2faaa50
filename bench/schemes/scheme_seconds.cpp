// scheme_seconds: turns what count_schemes has counted into seconds on a machine that a file describes. Prints the
// lines of a file of counts, each with "seconds".
//
//   count_schemes --scheme rounds --workers 16 > counts && scheme_seconds bench/machines/cluster.json counts
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "../model/network.hpp"

namespace pardel::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Machine {
  double seconds_per_triangle = 0;  ///< for one triangle that is read or written
  Network network;
};

std::ifstream opened(const char* path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(std::string(path) + " cannot be opened");
  return in;
}

Machine read_machine(const char* path) {
  std::ifstream in = opened(path);
  const Json json = Json::parse(in);
  return {json.at("seconds_per_triangle"), {json.at("latency"), json.at("bandwidth")}};
}

/// The critical path; the barriers, each a sum over all workers; and the messages, which are spread evenly over workers
/// and leave one after the other.
double seconds(const Json& counts, const Machine& machine) {
  const int workers = counts.at("workers");
  const double critical = counts.at("critical"), barriers = counts.at("barriers");
  const double messages = counts.at("messages"), bytes = counts.at("bytes");
  const double computing = critical * machine.seconds_per_triangle;
  const double waiting = workers == 1 ? 0 : barriers * machine.network.all_reduce(workers, sizeof(double));
  const double sending =
      (messages * machine.network.latency + bytes / machine.network.bandwidth) / static_cast<double>(workers);
  return computing + waiting + sending;
}

int run(const char* machine_file, const char* counts_file) {
  const Machine machine = read_machine(machine_file);
  std::ifstream in = opened(counts_file);
  for (std::string line; std::getline(in, line);) {
    Json counts = Json::parse(line);
    if (!counts.contains("error")) counts["seconds"] = seconds(counts, machine);
    std::cout << counts.dump() << '\n';
  }
  return 0;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: scheme_seconds MACHINE.json COUNTS\n", stderr);
    return 2;
  }
  try {
    return pardel::bench::run(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "scheme_seconds: %s\n", error.what());
    return 1;
  }
}
