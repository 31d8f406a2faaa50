#include "agree.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "exchange_lists.hpp"

namespace pardel {

namespace {

Status agreed(const Status& here, Ranks& ranks, bool names_rank) {
  std::vector<char> message;  // empty, or the kind of the error and its text
  if (!here) {
    const std::string& text = here.error().message;
    message.resize(1 + text.size());
    message[0] = static_cast<char>(here.error().kind);
    std::ranges::copy(text, message.begin() + 1);
  }
  const std::vector<std::vector<char>> all = lists_of_all(message, ranks);
  const auto is_done = [](const std::vector<char>& from) { return from.empty(); };
  const auto failed = std::ranges::find_if_not(all, is_done);
  if (failed == all.end()) return Done{};
  Error error{static_cast<ErrorKind>(failed->front()), {}};
  if (names_rank && std::ranges::any_of(all, is_done))
    error.message = "rank " + std::to_string(failed - all.begin()) + ": ";
  for (const char c : std::span(*failed).subspan(1)) error.message += c;
  return error;
}

}  // namespace

Status agree(const Status& here, Ranks& ranks) { return agreed(here, ranks, true); }
Status agree_on_input(const Status& here, Ranks& ranks) { return agreed(here, ranks, false); }

}  // namespace pardel
