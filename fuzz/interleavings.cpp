// The lattice refiner of ref/, one cell after the other and in the interleaving that the bytes select: in each step,
// any of the unfinished cells of a colour insert a point. Every interleaving must give the same mesh, and the checker
// must certify it.
#include "../properties/checker/check.hpp"
#include "../properties/theorems/refinement/channels.hpp"
#include "../ref/decomposition/cell_refiner.hpp"
#include "../ref/independent.hpp"
#include "fuzz_one.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

using properties::Channel;
using properties::Shape;

/// Small channels: exact arithmetic takes long.
Channel decode_channel(Supply& bytes) {
  Channel channel;
  channel.shape = bytes.one_of({Shape::slant, Shape::bar});
  channel.length = channel.shape == Shape::slant ? 1 + bytes.below(2) : 5 + bytes.below(3);
  channel.has_wall = bytes.flag(64) && channel.shape == Shape::bar;
  channel.has_crack = bytes.flag(64) && channel.shape == Shape::bar;
  const double square = channel.width * channel.width;
  channel.coarse_area = channel.shape == Shape::slant ? 2 * square : square / (1 + bytes.below(2));
  channel.max_area = channel.coarse_area / (2 + bytes.below(channel.shape == Shape::slant ? 6 : 2));
  const Channel straight = channel;
  for (Point& nudge : channel.nudges) {
    const int x = bytes.below(3), y = bytes.below(3);
    nudge = {static_cast<double>((x + 1) % 3 - 1), static_cast<double>((y + 1) % 3 - 1)};
  }
  return ref::unsupported(to_pslg(channel), goal_of(channel)) ? straight : channel;
}

/// In each step, a cell works if its bit in the next byte is set; at least one does.
ref::Turns turns_of(Supply& bytes) {
  return [&bytes](const std::set<ref::Cell>& unfinished) {
    std::set<ref::Cell> chosen;
    unsigned bits = bytes.byte();
    for (const ref::Cell& cell : unfinished) {
      if (bits % 2 == 1) chosen.insert(cell);
      bits = bits / 2 + (bits % 2) * 128;
    }
    if (chosen.empty()) chosen.insert(*unfinished.rbegin());
    return chosen;
  };
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  Supply supply(bytes);
  const Channel channel = decode_channel(supply);
  const Pslg pslg = to_pslg(channel);
  const auto refine = [&](const ref::Turns& turns) {
    return ref::refine_on_lattice(pslg, goal_of(channel), coarse_goal_of(channel), turns);
  };
  const auto expected = refine(ref::one_after_the_other), found = refine(turns_of(supply));
  if (!expected || !found) fail("the reference rejects the channel");
  const auto triangles = [](const Mesh& mesh) { return triangles_as_points(ref::to_plain_mesh(mesh)); };
  if (triangles(expected->mesh) != triangles(found->mesh)) fail("the mesh depends on the interleaving");
  const Certificate certificate = check(pslg, found->mesh, goal_of(channel));
  if (!certificate.valid) fail(certificate.violations.front().message());
  return 0;
}

}  // namespace pardel::fuzz
