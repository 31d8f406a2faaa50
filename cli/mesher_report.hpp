// What a sequential mesher has done in a run of `pardel mesh --mesher`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "../off_the_shelf/mesh_with_mesher.hpp"

namespace pardel::cli {

struct MesherOfRun {
  std::string name;
  Scheme scheme = Scheme::frozen;
  MesherReport report;
};

[[nodiscard]] nlohmann::ordered_json mesher_json(const MesherOfRun& mesher);
/// A line for the summary, and one for each kind of breach.
[[nodiscard]] std::string mesher_text(const MesherOfRun& mesher);

}  // namespace pardel::cli
