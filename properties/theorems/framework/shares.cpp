#include "shares.hpp"

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace pardel::properties {
namespace {

// RapidCheck keeps nothing but tags of a case. So a promise is a tag, too: this word, the share, a blank, the kind.
const std::string promise = "promised ";

}  // namespace

void classify(bool is_of_kind, const std::string& kind, double least_percent) {
  if (!(least_percent > 0)) throw std::invalid_argument("the promised share of \"" + kind + "\" is not positive");
  std::ostringstream tag;
  tag << promise << least_percent << ' ' << kind;
  RC_TAG(tag.str());
  if (is_of_kind) RC_TAG(kind);
}

Shares shares_of(const rc::detail::Distribution& distribution) {
  Shares shares;
  for (const auto& [tags, count] : distribution) {
    std::set<std::string> kinds;
    for (std::string tag : tags) {
      std::erase(tag, '"');  // RapidCheck quotes strings
      if (!tag.starts_with(promise)) {
        kinds.insert(tag);
        continue;
      }
      std::istringstream text(tag.substr(promise.size()));
      double least = 0;
      std::string kind;
      text >> least >> std::ws;
      std::getline(text, kind);
      shares.promised[kind] = std::max(shares.promised[kind], least);
    }
    for (const std::string& kind : kinds) shares.cases[kind] += static_cast<std::uint64_t>(count);
  }
  return shares;
}

std::vector<std::string> broken_promises(const Shares& shares, std::uint64_t cases) {
  constexpr std::uint64_t enough_cases = 500;
  std::vector<std::string> broken;
  if (cases < enough_cases) return broken;
  for (const auto& [kind, least] : shares.promised) {
    const auto found = shares.cases.find(kind);
    const std::uint64_t count = found == shares.cases.end() ? 0 : found->second;
    if (100 * static_cast<double>(count) >= least * static_cast<double>(cases)) continue;
    std::ostringstream sentence;
    sentence << "Only " << count << " of " << cases << " cases are of the kind \"" << kind << "\"; at least " << least
             << " % must be.";
    broken.push_back(sentence.str());
  }
  return broken;
}

}  // namespace pardel::properties
