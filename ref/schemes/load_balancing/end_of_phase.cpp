// How the workers learn that a phase has ended.
#include <algorithm>

#include "balancer.hpp"

namespace pardel::schemes {

/// A wave goes down a binary tree of workers, and comes up again with the sums of their counters.
void Balancer::join_wave(int w) {
  Worker& me = workers_[at(w)];
  me.in_wave = true;
  me.replies = 0;
  me.sent_below = me.received_below = 0;
  for (const int child : {2 * w + 1, 2 * w + 2})
    if (child < static_cast<int>(workers_.size())) {
      ++me.replies;
      send({.kind = Kind::wave_down, .from = w, .to = child}, bytes_of_head);
    }
}

/// A worker replies when it has nothing to do, with the counters of that moment.
void Balancer::reply(int w) {
  Worker& me = workers_[at(w)];
  if (!me.in_wave || me.replies > 0 || me.running >= 0 || !me.ready.empty()) return;
  me.in_wave = false;
  me.sent_below += me.sent;
  me.received_below += me.received;
  if (w == 0) return judge();
  Event event{.kind = Kind::wave_up, .from = w, .to = (w - 1) / 2};
  event.sent = me.sent_below;
  event.received = me.received_below;
  send(std::move(event), bytes_of_head);
}

/// Mattern: as many messages were received when the first wave passed as were sent when the second one
/// did. Between the two waves there was a moment at which all of them had been received and nobody was active.
void Balancer::judge() {
  ++counts_.waves;
  const Worker& root = workers_[0];
  const bool announces = rules_.detection == Detection::one_wave
                             ? root.sent_below == root.received_below
                             : has_wave_before_ && received_before_ == root.sent_below;
  if (announces && has_ended()) {
    ended_ = true;
    return;
  }
  if (announces) ++counts_.false_ends;
  has_wave_before_ = true;
  received_before_ = root.received_below;
  post({.kind = Kind::wave_down, .from = 0, .to = 0}, rules_.latency + 1);
}

/// What no worker can know: nothing is in flight, and nobody has work.
bool Balancer::has_ended() const {
  return in_flight_ == 0 && std::ranges::all_of(workers_, [](const Worker& worker) {
           return worker.running < 0 && worker.waiting.empty();
         });
}

}  // namespace pardel::schemes
