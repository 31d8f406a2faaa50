#include "made.hpp"

#include <fmt/core.h>

#include "../cli/memory.hpp"
#include "../core/support/collective.hpp"
#include "outputs.hpp"

namespace pardel::mpi {

void print(const Made& made, std::string_view lines, const char* making, int threads,
           std::span<const std::filesystem::path> outputs, bool quiet, Job& job) {
  const Digest all = sum_of(made.digest, job.ranks());
  const std::uint64_t least = least_and_most_of(made.least, job.ranks()).least,
                      most = least_and_most_of(made.most, job.ranks()).most;
  const LeastAndMost memory = least_and_most_of(cli::peak_memory(), job.ranks());
  const auto bytes = static_cast<double>(sum_of(cli::peak_memory(), job.ranks()));
  const auto margins = static_cast<double>(sum_of(made.margin, job.ranks()));
  if (!job.is_first() || quiet) return;
  constexpr double mib = 0x1p20;
  fmt::print("ranks   {}, with {} threads each; each has read {} input\n", job.count(), threads,
             made.divided ? "a part of the" : "the whole");
  fmt::print("{}", lines);
  fmt::print("pieces  {} to {} triangles, {:.0f} to {:.0f} MiB of memory\n", least, most,
             static_cast<double>(memory.least) / mib, static_cast<double>(memory.most) / mib);
  if (made.triangles > 0)
    fmt::print("memory  {:.0f} bytes per triangle{}\n", bytes / static_cast<double>(made.triangles),
               margins > 0 ? fmt::format("; ranks held {:.2f} % more triangles than their own",
                                         100 * margins / static_cast<double>(made.triangles))
                           : "");
  fmt::print("digest  {}\n", to_string(all));
  const std::string check = made.valid ? fmt::format("check {:.3f}, ", made.seconds.check) : "";
  fmt::print("time    {:.3f} s (read {:.3f}, {} {:.3f}, pieces {:.3f}, {}write {:.3f})\n", made.seconds.all,
             made.seconds.read, making, made.seconds.refine, made.seconds.pieces, check, made.seconds.write);
  fmt::print("output  {}\n", names_of(outputs));
}

}  // namespace pardel::mpi
