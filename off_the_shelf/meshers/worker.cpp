#include "worker.hpp"

#include <exception>

#include "../../core/support/stop_signal.hpp"
#include "messages.hpp"

namespace pardel::engine {
namespace {

Channel::Bytes answer_to(SubdomainMesher& mesher, const Channel::Bytes& subdomain) {
  RefinedSubdomain failed;
  failed.ending = RefinedSubdomain::Ending::failed;
  try {
    return to_bytes(mesher.refine(subdomain_from(subdomain)));
  } catch (const std::exception& e) {
    failed.why = e.what();
  } catch (const Stopped& stopped) {
    failed.why = stopped.error.message;
  } catch (...) {
    failed.why = "the mesher threw an exception";
  }
  return to_bytes(failed);
}

}  // namespace

void serve(SubdomainMesher& mesher, Channel& channel) noexcept {
  using Outcome = Channel::Outcome;
  Channel::Message message;
  while (channel.receive(message) == Outcome::done &&
         channel.send(message.number, answer_to(mesher, message.body)) == Outcome::done) {
  }
}

}  // namespace pardel::engine
