// The program pardel-mpi.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../cli/end_process.hpp"
#include "../cli/failure_watch.hpp"
#include "../cli/help.hpp"
#include "../cli/interrupt_watch.hpp"
#include "../cli/processors.hpp"
#include "../cli/usage_message.hpp"
#include "../core/support/stop_signal.hpp"
#include "absent_options.hpp"
#include "check_command.hpp"
#include "job.hpp"
#include "mesh_command.hpp"
#include "triangulate_command.hpp"

namespace pardel::mpi {
namespace {

using cli::ExitCode;

constexpr const char* description =
    "pardel-mpi: guaranteed-quality Delaunay meshes, made and checked by the processes of an MPI job.";

constexpr const char* footer = R"(Start it with mpirun or srun:
  mpirun -n 4 pardel-mpi mesh pipe.poly -o pipe.pvtu --max-area 1e-6
  mpirun -n 4 pardel-mpi check pipe.poly pipe.pvtu --max-area 1e-6

Exit status: as 'pardel --help' lists. If one rank cannot go on, it ends all ranks, with its exit status.)";

/// All ranks have the same arguments; the first one prints. If one rank cannot use its arguments, none begins.
ExitCode run(int argc, char** argv, Job& job) {
  CLI::App program(description, "pardel-mpi");
  program.set_version_flag("-V,--version", "pardel-mpi " PARDEL_VERSION);
  program.footer(footer);
  program.formatter(std::make_shared<cli::HelpFormatter>());
  program.failure_message(
      [](const CLI::App* app, const CLI::Error& error) { return cli::usage_message(app, error, absent_options); });
  program.require_subcommand(1);
  const std::array commands{add_mesh(program, job), add_triangulate(program, job), add_check(program, job)};
  std::vector<std::string> arguments(argv + 1, argv + argc);
  cli::expand_help(arguments);
  std::ranges::reverse(arguments);      // as CLI11 wants them
  std::optional<CLI::ParseError> stop;  // also for --help and --version
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& thrown) {
    stop = thrown;
  }
  const Status all = job.agree(stop ? Status(Error{ErrorKind::usage, stop->what()}) : Status(Done{}));
  if (stop && job.is_first()) return program.exit(*stop) == 0 ? ExitCode::done : ExitCode::usage;
  if (stop) return stop->get_exit_code() == 0 ? ExitCode::done : ExitCode::usage;
  if (!all) return job.is_first() ? cli::report(all.error(), "pardel-mpi") : ExitCode::usage;
  const auto given = std::ranges::find_if(commands, [](const cli::Command& command) { return command.app->parsed(); });
  const Result<ExitCode> result = given->run();
  if (result) return *result;
  return job.is_first() ? cli::report(result.error(), "pardel-mpi") : cli::exit_code(result.error().kind);
}

/// An error of one rank ends all of them. Then mpirun sends SIGTERM to the others, whose messages would hide that of
/// the rank that has failed.
ExitCode run_in_job(int argc, char** argv, cli::InterruptWatch& interrupt_watch) {
  Job job;
  if (job.count() > 1) interrupt_watch.end_silently_on_sigterm();
  static const std::string name = "pardel-mpi: rank " + std::to_string(job.ranks().rank());
  cli::name_process(name.c_str());
  try {
    return run(argc, argv, job);
  } catch (const Stopped& stopped) {  // by a self-check of the messages
    job.abort(stopped.error);
  } catch (const Error& thrown) {
    job.abort(thrown);
  } catch (const std::bad_alloc&) {
    job.abort({ErrorKind::resources, "out of memory"});
  } catch (const std::exception& unexpected) {
    job.abort({ErrorKind::resources, unexpected.what()});
  }
}

ExitCode guarded(int argc, char** argv) {
  cli::name_process("pardel-mpi");
  const cli::FailureWatch failure_watch;
  try {
    cli::InterruptWatch interrupt_watch;  // before MPI starts threads
    cli::keep_to_processor_quota();
    return run_in_job(argc, argv, interrupt_watch);
  } catch (const std::exception& unexpected) {  // the job has not started; mpirun ends the other ranks
    return cli::report({ErrorKind::resources, unexpected.what()}, "pardel-mpi");
  }
}

}  // namespace
}  // namespace pardel::mpi

int main(int argc, char** argv) { return static_cast<int>(pardel::mpi::guarded(argc, argv)); }
