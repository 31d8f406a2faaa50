#include "check_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../cli/certificate_report.hpp"
#include "../cli/distinct_files.hpp"
#include "../cli/memory.hpp"
#include "../cli/memory_watch.hpp"
#include "../cli/output.hpp"
#include "../cli/refusal.hpp"
#include "../cli/threads_option.hpp"
#include "../cli/verdict.hpp"
#include "../core/formats.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/stopwatch.hpp"
#include "../properties/checker/check_pieces.hpp"
#include "problem.hpp"

namespace pardel::mpi {
namespace {

using namespace cli;

constexpr const char* check_footer =
    R"(The certificate is that of 'pardel check', with the number of ranks as one more entry of --json. No rank holds the
whole mesh. The number of ranks may differ from the number of pieces; a rank with several pieces holds one at a time. Exit status 0: the mesh is right; 1: it is
wrong, and the violations are listed with their places.

Example:
  mpirun -n 4 pardel-mpi check pipe.poly pipe.pvtu --max-area 1e-6 --json certificate.json)";

struct CheckArguments {
  std::filesystem::path domain, mesh;
  GoalOptions goal;
  double max_circumradius = 0;
  std::filesystem::path json;
  int threads = 0;
  bool quiet = false;
};

void add_check_options(CLI::App& app, CheckArguments& arguments) {
  app.add_option("IN.poly", arguments.domain, "The domain: .poly, .node or .geojson")->required()->type_name("");
  app.add_option("MESH.pvtu", arguments.mesh, "The mesh: a .pvtu with its pieces")->required()->type_name("");
  add_goal_options(app, arguments.goal, largest_angle_to_check);
  app.add_option("--max-circumradius", arguments.max_circumradius, "No circumradius above this, compared exactly")
      ->check(positive_number("a radius"))
      ->type_name("LENGTH")
      ->group("Goal");
  app.add_option("--json", arguments.json, "Write the certificate as JSON, with all violations; - is standard output")
      ->type_name("FILE|-");
  add_threads_option(app, arguments.threads, "the certificate")
      ->description("Number of threads of each rank; 0 or all (default): its share of the processors of its machine");
  app.add_flag("-q,--quiet", arguments.quiet, "Print nothing on standard output except the certificate of --json -");
  app.footer(check_footer);
}

Status check_arguments_of(const CheckArguments& arguments, const Ranks& ranks) {
  if (Status fine = check_inputs(std::array{arguments.domain, arguments.goal.sizes, arguments.goal.sources}, ranks);
      !fine)
    return fine;
  if (arguments.mesh.extension() != ".pvtu")
    return Error{ErrorKind::usage, fmt::format("the mesh {} must be a .pvtu", arguments.mesh.string())};
  const std::array outputs = {NamedFile{"--json", arguments.json}};
  const std::array inputs = {domain_input(arguments.domain), NamedFile{{}, arguments.mesh},
                             NamedFile{{}, arguments.goal.sizes, false}, NamedFile{{}, arguments.goal.sources, false}};
  if (Status fine = check_distinct(outputs, inputs); !fine) return fine;
  return check_folder(arguments.json);
}

/// The pieces of this rank, which follow each other in the .pvtu. They are read when the check asks for them.
class Pieces {
 public:
  Pieces(std::vector<std::filesystem::path> all, const Ranks& ranks) {
    const auto count = static_cast<std::size_t>(ranks.count()), rank = static_cast<std::size_t>(ranks.rank());
    for (std::size_t i = all.size() * rank / count; i < all.size() * (rank + 1) / count; ++i)
      files_.push_back(std::move(all[i]));
  }
  [[nodiscard]] PiecesOfRank to_read() {
    return {files_.size(), [this](std::size_t i) { return read(i); }};
  }
  [[nodiscard]] double seconds() const { return seconds_; }

  /// A field of sizes without a value in one of the triangles is an error.
  [[nodiscard]] Status require_sizes(const Goal& goal, const Certificate& certificate) {
    Status have = Done{};
    for (std::size_t i = 0; i < files_.size() && have && may_lack_sizes(goal, certificate); ++i) {
      const auto piece = read(i);
      have = piece ? cli::require_sizes((*piece)->mesh, goal, certificate) : piece.error();
    }
    return have;
  }

 private:
  Result<std::shared_ptr<const NumberedMesh>> read(std::size_t i) {
    const Stopwatch watch;
    Result<NumberedMesh> piece = read_vtu_piece(files_[i]);
    if (!piece) return piece.error();
    seconds_ += watch.seconds();
    return std::make_shared<const NumberedMesh>(std::move(*piece));
  }

  std::vector<std::filesystem::path> files_;
  double seconds_ = 0;  ///< spent on reading
};

template <class T>
Status status_of(const Result<T>& result) {
  if (result) return Done{};
  return result.error();
}

Result<ExitCode> run_check(const CheckArguments& arguments, Job& job) {
  const MemoryWatch memory_watch(available_memory(job.ranks_here()));
  if (Status fine = job.agree(check_arguments_of(arguments, job.ranks())); !fine) return fine.error();
  use_threads(arguments.threads > 0 ? arguments.threads : job.threads_per_rank());
  const Stopwatch watch;
  // As 'pardel check', the first rank writes why an input is refused to the file of --json.
  const auto refusal = [&](const Refusal& why) {
    return job.is_first() ? refused(why, arguments.domain, arguments.json) : why.error;
  };
  const Result<Problem, Refusal> problem = read_problem(
      arguments.domain, arguments.goal, {.threads = arguments.threads, .in_sources = CrossingPolygons::repaired});
  if (const auto common = common_refusal(problem, job)) return refusal(*common);
  const double input_seconds = watch.seconds();
  Result<std::vector<std::filesystem::path>> files = files_of_pieces(arguments.mesh);
  if (Status all = job.agree(status_of(files)); !all) return refusal(all.error());
  Pieces pieces(std::move(*files), job.ranks());
  const CheckOptions options{
      .max_violations = most_kept(arguments.json), .max_circumradius = arguments.max_circumradius, .foreign = true};
  Result<Certificate> checked = check(problem->domain.pslg(), pieces.to_read(), problem->goal, options, job.ranks());
  if (!checked) return refusal(Error{checked.error().kind, arguments.mesh.string() + ": " + checked.error().message});
  checked->ranks = job.count();
  const Certificate& certificate = *checked;
  if (Status sized = job.agree(pieces.require_sizes(problem->goal, certificate)); !sized) return sized.error();
  const double seconds = watch.seconds();

  const LeastAndMost memory = least_and_most_of(peak_memory(), job.ranks());
  Status written = Done{};
  if (job.is_first()) {
    if (!arguments.quiet && !is_standard_output(arguments.json)) {
      constexpr double mib = 0x1p20;
      const NumbersInWitnesses numbers{.first_of_domain = problem->domain.pslg().first_id.value};
      print_certificate(certificate, arguments.json, numbers, arguments.max_circumradius);
      fmt::print("ranks   {}, {:.0f} to {:.0f} MiB of memory\n", job.ranks().count(),
                 static_cast<double>(memory.least) / mib, static_cast<double>(memory.most) / mib);
      const double read_seconds = input_seconds + pieces.seconds();
      fmt::print("time    {:.3f} s (read {:.3f}, check {:.3f})\n", seconds, read_seconds, seconds - read_seconds);
    }
    if (!arguments.json.empty()) written = write_text(to_json(certificate) + "\n", arguments.json);
  }
  if (Status all = job.agree(written); !all) return all.error();
  return certificate.valid ? ExitCode::done : ExitCode::violations;
}

}  // namespace

Command add_check(CLI::App& program, Job& job) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* app = program.add_subcommand("check", "Prove that a mesh in pieces is right for its domain");
  add_check_options(*app, *arguments);
  return {app, [arguments, &job] { return run_check(*arguments, job); }};
}

}  // namespace pardel::mpi
