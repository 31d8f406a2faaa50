// What a run of the engine on one thread does, stage by stage: the number of questions whether to go on, the numbers
// that the stage reports, and a fingerprint of what it makes.
#pragma once

#include <string>
#include <vector>

#include "../../../core/goal.hpp"
#include "../../../core/pslg.hpp"
#include "../../../parallel/options.hpp"
#include "../../fingerprint.hpp"

namespace pardel::recorded {

/// A domain that is meshed.
struct Run {
  std::string group;  ///< of runs that one test repeats
  std::string name;
  Pslg pslg;
  Goal goal;
  Options options;
  bool summary = false;  ///< one line with the fingerprint of all others
};
/// Small domains with goals and options of all kinds, and families of random domains.
[[nodiscard]] const std::vector<Run>& runs();
[[nodiscard]] std::vector<std::string> groups_of_runs();
/// One line per stage, or a summary; each begins with the name of the run.
[[nodiscard]] std::vector<std::string> record(const Run& run);

/// A Pslg that has to be repaired.
struct Mess {
  std::string group, name;
  Pslg pslg;
  bool summary = false;
};
[[nodiscard]] const std::vector<Mess>& messes();
[[nodiscard]] std::vector<std::string> groups_of_messes();
[[nodiscard]] std::vector<std::string> record(const Mess& mess);
/// Many points, which are triangulated on small tiles.
struct Cloud {
  std::string group, name;
  std::vector<Point> points;
  bool summary = false;
};
[[nodiscard]] const std::vector<Cloud>& clouds();
[[nodiscard]] std::vector<std::string> groups_of_clouds();
[[nodiscard]] std::vector<std::string> record(const Cloud& cloud);

/// The lines of the file `runs` for these lines of one record.
template <class What>
[[nodiscard]] std::vector<std::string> kept(const What& what, const std::vector<std::string>& lines) {
  if (!what.summary) return lines;
  return {what.name + ", all stages: " + testing::fingerprint(lines)};
}

}  // namespace pardel::recorded
