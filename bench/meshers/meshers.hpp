// The meshers of this build by name.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "../../off_the_shelf/mesh_with_mesher.hpp"

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

/// Nothing if there is no scheme of this name.
[[nodiscard]] std::optional<Scheme> scheme_named(std::string_view text);

/// The names for mesher_for(): those of meshers(), and "program triangle" for each named program.
[[nodiscard]] std::vector<std::string> names_of_meshers();
/// For this number of threads: what is not thread-safe runs in as many worker processes; for one thread only if sizes
/// depend on the place, because workers get samples of them. To be called before the process uses threads. Null if the
/// mesher cannot be had here.
[[nodiscard]] std::unique_ptr<SubdomainMesher> mesher_for(const std::string& name, int threads, const Goal& goal);

}  // namespace pardel::bench
