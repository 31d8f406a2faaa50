#include "trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <system_error>

#include "../../core/formats.hpp"
#include "../../core/support/child_process.hpp"
#include "../../core/support/shell_words.hpp"

namespace pardel::harness {
namespace fs = std::filesystem;
namespace {

/// If a signal ended the child of a shell, the shell exits with this number plus the number of the signal.
constexpr int shell_signal_base = 128;

/// Signals that mean a crash. Other signals stop a program from outside.
constexpr int crash_signals[] = {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGSYS, SIGKILL};

Outcome failed(Verdict verdict, std::string kind, std::string message) {
  return {verdict, {{std::move(kind), std::move(message)}}, {}, {}};
}

Outcome judge_file(const Trials& trials, const Pslg& pslg, const Goal& goal, const fs::path& folder,
                   const fs::path& log) {
  const fs::path out = output_in(folder, trials.mesher);
  std::error_code ignored;
  if (!fs::exists(out, ignored)) {
    const std::string said = telling_line(log, folder);
    return failed(Verdict::refused, "no output",
                  fmt::format("it did not write {}{}", out.filename().string(), said.empty() ? "" : ", but: " + said));
  }
  const Result<Mesh> mesh = read_mesh(out);
  if (!mesh) return failed(Verdict::wrong, "unreadable", replaced(mesh.error().message, folder.string() + '/', ""));
  return judge(pslg, *mesh, goal, trials.delaunay);
}

Result<Outcome> outcome_of(const ChildRun& run, const Trials& trials, const Pslg& pslg, const Goal& goal,
                           const fs::path& folder, const fs::path& log) {
  switch (run.ending) {
    case ChildEnding::not_started:
      return Error{ErrorKind::resources, fmt::format("no process: {}", std::strerror(run.number))};
    case ChildEnding::interrupted:
      return Error{ErrorKind::cancelled, "interrupted"};
    case ChildEnding::timed_out:
      return failed(Verdict::hung, "time limit", fmt::format("not finished within {} s", trials.limits.seconds));
    case ChildEnding::signalled:
      return failed(Verdict::crashed, signal_name(run.number), telling_line(log, folder));
    case ChildEnding::exited:
      break;
  }
  const auto& success = trials.mesher.success_codes;
  if (std::find(success.begin(), success.end(), run.number) != success.end()) {
    return judge_file(trials, pslg, goal, folder, log);
  }
  for (const int signal : crash_signals) {
    if (run.number == shell_signal_base + signal) {
      return failed(Verdict::crashed, signal_name(signal), telling_line(log, folder));
    }
  }
  return failed(Verdict::refused, fmt::format("exit code {}", run.number), telling_line(log, folder));
}

}  // namespace

Goal goal_for(const Trials& trials, const Pslg& pslg) {
  Goal goal;
  goal.min_angle_deg = trials.min_angle_deg;
  goal.region_caps = false;
  if (trials.max_area_fraction > 0) {
    const auto [left, right] = std::minmax_element(pslg.points.begin(), pslg.points.end(),
                                                   [](const Point& p, const Point& q) { return p.x < q.x; });
    const auto [low, high] = std::minmax_element(pslg.points.begin(), pslg.points.end(),
                                                 [](const Point& p, const Point& q) { return p.y < q.y; });
    goal.max_area = trials.max_area_fraction * (right->x - left->x) * (high->y - low->y);
  }
  return goal;
}

fs::path input_in(const fs::path& folder) { return folder / "domain.poly"; }
fs::path output_in(const fs::path& folder, const Mesher& mesher) { return folder / ("domain.1." + mesher.suffix); }

Result<Outcome> try_mesher(const Trials& trials, const LatticeDomain& domain, const fs::path& folder) {
  std::error_code error;
  fs::remove_all(folder, error);
  if (!error) fs::create_directories(folder, error);
  if (error) return Error{ErrorKind::io, fmt::format("{}: {}", folder.string(), error.message())};
  const Pslg pslg = to_pslg(domain);
  if (Status written = write_poly(pslg, input_in(folder)); !written) return written.error();

  const Goal goal = goal_for(trials, pslg);
  const fs::path log = folder / "log";
  const auto words = command(trials.mesher, input_in(folder), output_in(folder, trials.mesher), goal);
  return outcome_of(run_child(words, log, trials.limits, trials.stop), trials, pslg, goal, folder, log);
}

}  // namespace pardel::harness
