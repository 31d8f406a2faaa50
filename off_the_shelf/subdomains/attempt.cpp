#include "attempt.hpp"

#include <cstring>
#include <exception>
#include <utility>

#include "../../core/support/stopwatch.hpp"
#include "../../parallel/arithmetic/floor.hpp"
#include "without_triangles.hpp"

namespace pardel::engine {
namespace {

bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0);
}

bool same_answer(const RefinedSubdomain& a, const RefinedSubdomain& b) {
  return a.ending == b.ending && same_bits(a.points, b.points) && a.edge_of_new_point == b.edge_of_new_point &&
         a.triangles == b.triangles;
}

}  // namespace

RefinedSubdomain MesherCaller::refine(const Subdomain& subdomain) {
  std::unique_lock<std::mutex> alone;
  if (!abilities_.is_thread_safe) alone = std::unique_lock(one_at_a_time_);
  try {
    return mesher_.refine(subdomain);
  } catch (const std::exception& e) {
    return without_triangles(RefinedSubdomain::Ending::failed, e.what());
  } catch (...) {
    return without_triangles(RefinedSubdomain::Ending::failed, "the mesher threw an exception");
  }
}

void refine_part(MesherCaller& mesher, bool twice, double min_edge, Attempt& result) {
  const Subdomain& subdomain = result.part.subdomain;
  Stopwatch watch;
  RefinedSubdomain answer = mesher.refine(subdomain);
  const bool is_other = twice && !same_answer(answer, mesher.refine(subdomain));
  result.mesher_seconds = watch.lap();
  if (is_other) {
    result.breach = Breach{BreachKind::other_answer, subdomain.points.front(),
                           "the same subdomain got another answer the second time"};
    return;
  }
  result.at_limit = answer.ending == RefinedSubdomain::Ending::limit;
  Result<VerifiedSubdomain, Breach> verified = verify(subdomain, std::move(answer), result.part.lines, Floor(min_edge));
  if (verified)
    result.answer = *std::move(verified);
  else
    result.breach = verified.error();
  result.verification_seconds = watch.lap();
}

}  // namespace pardel::engine
