// One task: the mesher refines a part, and its answer is verified.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "part.hpp"
#include "verify.hpp"

namespace pardel::engine {

/// A part, and what became of it.
struct Attempt {
  Part part;
  std::optional<VerifiedSubdomain> answer;  ///< without a value if the answer was not usable
  std::optional<Breach> breach;             ///< why it was not
  bool at_limit = false;
  double extraction_seconds = 0, mesher_seconds = 0, verification_seconds = 0;
};

/// Calls a mesher that is not trusted: an exception is an answer that failed. Calls from several threads wait for each
/// other if the mesher is not thread-safe.
class MesherCaller {
 public:
  MesherCaller(SubdomainMesher& mesher, const MesherAbilities& abilities) : mesher_(mesher), abilities_(abilities) {}
  [[nodiscard]] const MesherAbilities& abilities() const { return abilities_; }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain);

 private:
  SubdomainMesher& mesher_;
  MesherAbilities abilities_;
  std::mutex one_at_a_time_;
};

/// Lets the mesher refine the part of `result`, verifies the answer, and fills in the rest of `result`. `twice`: asks a
/// second time, and finds a breach if the answers differ. `min_edge`: see Options.
void refine_part(MesherCaller& mesher, bool twice, double min_edge, Attempt& result);

}  // namespace pardel::engine
