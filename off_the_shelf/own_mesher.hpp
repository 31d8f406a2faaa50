// pardel's own sequential refiner as a SubdomainMesher. It can serve every scheme.
#pragma once

#include <memory>

#include "subdomain_mesher.hpp"

namespace pardel {

[[nodiscard]] std::unique_ptr<SubdomainMesher> own_mesher();

}  // namespace pardel
