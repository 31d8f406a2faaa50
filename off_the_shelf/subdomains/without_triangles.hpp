// An answer of a mesher that has no triangles.
#pragma once

#include <string>
#include <utility>

#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// `ending`: neither `finished` nor `limit`.
[[nodiscard]] inline RefinedSubdomain without_triangles(RefinedSubdomain::Ending ending, std::string why) {
  RefinedSubdomain answer;
  answer.ending = ending;
  answer.why = std::move(why);
  return answer;
}

}  // namespace pardel::engine
