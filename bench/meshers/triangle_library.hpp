// Shewchuk's Triangle, called through its library. Triangle is not free software: nothing that is installed contains
// it.
#pragma once

#include <memory>

#include "../../off_the_shelf/subdomain_mesher.hpp"

namespace pardel::bench {

/// Triangle as it is: switches -q and -a. Keeps frozen edges and splits no segments. It ends the process by exit() if
/// it finds a mistake, and has global variables: use it in_processes().
[[nodiscard]] std::unique_ptr<SubdomainMesher> triangle_library();

/// Triangle with its hook triunsuitable() (switch -u), which decides about each triangle and so obeys a cell, too. Not
/// defined if the library is static: the hook of the program takes the place of the one in a shared library.
[[nodiscard]] std::unique_ptr<SubdomainMesher> triangle_library_with_hook();

}  // namespace pardel::bench
