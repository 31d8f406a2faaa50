// The meshers of this build by name.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel::bench {

/// A mesher, and what it is called.
struct NamedMesher {
  std::string_view name;
  std::unique_ptr<SubdomainMesher> (*make)();
};

/// pardel's own refiner, and the adaptors whose libraries were found when this was built.
[[nodiscard]] const std::vector<NamedMesher>& meshers();

/// Null if there is no mesher of this name.
[[nodiscard]] std::unique_ptr<SubdomainMesher> mesher_named(std::string_view name);

}  // namespace pardel::bench
