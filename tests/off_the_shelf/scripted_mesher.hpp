// A mesher that is a function of a test, and a subdomain for it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "../../off_the_shelf/in_processes.hpp"

namespace pardel {

class ScriptedMesher final : public SubdomainMesher {
 public:
  using Script = std::function<RefinedSubdomain(const Subdomain&)>;
  explicit ScriptedMesher(Script script, MesherAbilities abilities = {true, true, true, true, false})
      : script_(std::move(script)), abilities_(abilities) {}
  [[nodiscard]] MesherAbilities abilities() const override { return abilities_; }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override { return script_(subdomain); }

 private:
  Script script_;
  MesherAbilities abilities_;
};

/// The mesher in `workers` processes.
inline std::unique_ptr<SubdomainMesher> scripted_in_processes(ScriptedMesher::Script script, int workers = 1) {
  return std::move(in_processes(std::make_unique<ScriptedMesher>(std::move(script)), workers)).value();
}

/// The answer of a mesher that does nothing, with some words.
inline RefinedSubdomain unchanged(const Subdomain& subdomain, std::string why = {}) {
  RefinedSubdomain answer;
  answer.points = subdomain.points;
  answer.triangles = subdomain.triangles;
  answer.why = std::move(why);
  return answer;
}

/// The triangle with a corner at (x, 0) and legs of length 1.
inline Subdomain one_triangle(double x = 0) {
  Subdomain subdomain;
  subdomain.points = {{x, 0}, {x + 1, 0}, {x, 1}};
  subdomain.triangles = {{0, 1, 2}};
  subdomain.edges = {{0, 1, false, true}, {1, 2, false, false}, {2, 0, false, false}};
  subdomain.most_new_points = 1000;
  subdomain.seconds = 60;
  return subdomain;
}

}  // namespace pardel
