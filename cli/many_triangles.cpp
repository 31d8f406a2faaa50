#include "many_triangles.hpp"

#include <utility>

#include "exit_code.hpp"

namespace pardel::cli {

void warn_of_many_triangles(WarnOfMany how, std::optional<LeastSize>& large, Options& options) {
  constexpr double many = 50e6;
  if (options.max_vertices > 0 && 2 * static_cast<double>(options.max_vertices) < many) return;
  options.before_refinement = [how = std::move(how), &large](const LeastSize& size) -> Status {
    if (size.expected < many) return Done{};
    large = size;
    const char* places = size.names_narrow_part() ? "; 'pardel doctor' lists narrow places" : "";
    warn(how.input + ": warning: " + size.message() + " " + how.advice + places, how.program);
    return Done{};
  };
}

}  // namespace pardel::cli
