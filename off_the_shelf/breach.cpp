#include "breach.hpp"

#include <numeric>

#include "../core/support/enum_names.hpp"

namespace pardel {

const char* name(BreachKind kind) {
  constexpr auto names = enum_names<BreachKind>({{BreachKind::failed, "failed"},
                                                 {BreachKind::crashed, "crashed"},
                                                 {BreachKind::timed_out, "timed_out"},
                                                 {BreachKind::unreadable, "unreadable"},
                                                 {BreachKind::moved_point, "moved_point"},
                                                 {BreachKind::unusable_point, "unusable_point"},
                                                 {BreachKind::too_many_points, "too_many_points"},
                                                 {BreachKind::wrong_index, "wrong_index"},
                                                 {BreachKind::unused_point, "unused_point"},
                                                 {BreachKind::wrong_orientation, "wrong_orientation"},
                                                 {BreachKind::overlap, "overlap"},
                                                 {BreachKind::lost_edge, "lost_edge"},
                                                 {BreachKind::open_edge, "open_edge"},
                                                 {BreachKind::split_frozen_edge, "split_frozen_edge"},
                                                 {BreachKind::off_segment, "off_segment"},
                                                 {BreachKind::outside_cell, "outside_cell"},
                                                 {BreachKind::too_short_edge, "too_short_edge"},
                                                 {BreachKind::too_near_edge, "too_near_edge"},
                                                 {BreachKind::other_answer, "other_answer"}});
  static_assert(names.size() == breach_kinds);
  return names[kind];
}

void Breaches::add(const Breach& breach) {
  const auto kind = static_cast<std::size_t>(breach.kind);
  if (count[kind]++ == 0) first[kind] = breach;
}

std::uint64_t Breaches::total() const { return std::accumulate(count.begin(), count.end(), std::uint64_t{0}); }

}  // namespace pardel
