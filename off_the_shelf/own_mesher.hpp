// pardel's own sequential refiner as a SubdomainMesher. It can serve every scheme. It needs
// no limit on time, because the limit on new points ends every task.
#pragma once

#include <memory>

#include "subdomain_mesher.hpp"

namespace pardel {

[[nodiscard]] std::unique_ptr<SubdomainMesher> own_mesher();

}  // namespace pardel
