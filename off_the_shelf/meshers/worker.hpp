// What a process does that runs a mesher for another one.
#pragma once

#include "../subdomain_mesher.hpp"
#include "channel.hpp"

namespace pardel::engine {

/// Answers subdomains (messages.hpp) with what the mesher makes of them, until the other end is closed. An exception of
/// the mesher becomes an answer that failed.
void serve(SubdomainMesher& mesher, Channel& channel) noexcept;

}  // namespace pardel::engine
