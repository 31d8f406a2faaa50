// Channels: domains for the lattice refiner. They are so long and narrow that even a small mesh covers many cells.
// Blocks are square and have so many points that some cell has all eight neighbours. Coordinates are integers. No two
// segments meet at less than 60 degrees, because Ruppert's proof does not cover smaller angles.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "../../../core/goal.hpp"
#include "../../../core/pslg.hpp"
#include "../../../core/support/enum_names.hpp"
#include "../../../ref/refinement.hpp"
#include "../../domains/generators/random.hpp"

namespace pardel::properties {

enum class Shape : std::uint8_t {
  bar,    ///< straight
  bend,   ///< an L
  ring,   ///< around a square hole
  slant,  ///< a short parallelogram with corners of 63 degrees; a split there may raise the largest circumradius
  block,  ///< a square piece of a triangular lattice of points
};

inline const char* name(Shape shape) {
  constexpr auto names = enum_names<Shape>({{Shape::bar, "bar"},
                                            {Shape::bend, "bend"},
                                            {Shape::ring, "ring"},
                                            {Shape::slant, "slant"},
                                            {Shape::block, "block"}});
  return names[shape];
}

struct Channel {
  Shape shape = Shape::bar;
  int width = 6;                  ///< lattice units, even, at least 6
  int length = 12;                ///< the length of a bar, an arm of a bend or a side of a ring, in multiples of width
  std::array<Point, 8> nudges{};  ///< added to the corners; each coordinate is -1, 0 or 1
  bool has_wall = false;          ///< a wall across a bar; the area bound is halved on its right
  bool has_crack = false;         ///< a segment of one width along the middle that touches no other segment
  std::uint64_t seed = 0;         ///< moves the inner points of a block by up to 1; 0: none is moved
  double max_area = 8;            ///< the area bound of the goal
  double coarse_area = 16;        ///< the area bound of the preprocessing
};

inline std::ostream& operator<<(std::ostream& out, const Channel& c) {
  return out << name(c.shape) << " of " << c.length << " widths of " << c.width << (c.has_wall ? ", a wall" : "")
             << (c.has_crack ? ", a crack" : "") << ", areas up to " << c.max_area << ", first up to " << c.coarse_area;
}

/// Adds a polygon with these corners, moved by the channel's nudges.
inline void add_polygon(Pslg& pslg, std::vector<Point> corners, const Channel& channel) {
  const auto first = static_cast<Index>(pslg.points.size()), n = static_cast<Index>(corners.size());
  for (Index k = 0; k < n; ++k) {
    const Point nudge = channel.nudges.at(first + k);
    pslg.points.push_back({corners[k].x + nudge.x, corners[k].y + nudge.y});
    pslg.segments.push_back({first + k, first + (k + 1) % n});
  }
}

/// Nearly equilateral triangles with sides of 8; the outline goes from point to point.
[[nodiscard]] inline Pslg block(const Channel& channel) {
  constexpr Index columns = 7, rows = 9;
  generators::Random random(channel.seed);
  Pslg pslg;
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const bool is_inner = i > 0 && i + 1 < columns && j > 0 && j + 1 < rows && channel.seed != 0;
      const double dx = is_inner ? random.between(-1, 1) : 0, dy = is_inner ? random.between(-1, 1) : 0;
      pslg.points.push_back({8.0 * i + 4.0 * (j % 2) + dx, 7.0 * j + dy});
    }
  for (Index i = 1; i < columns; ++i) {
    pslg.segments.push_back({i - 1, i});
    pslg.segments.push_back({(rows - 1) * columns + i - 1, (rows - 1) * columns + i});
  }
  for (Index j = 1; j < rows; ++j) {
    pslg.segments.push_back({(j - 1) * columns, j * columns});
    pslg.segments.push_back({j * columns - 1, (j + 1) * columns - 1});
  }
  return pslg;
}

[[nodiscard]] inline Pslg to_pslg(const Channel& channel) {
  if (channel.shape == Shape::block) return block(channel);
  const double w = channel.width, l = channel.width * channel.length;
  Pslg pslg;
  if (channel.shape == Shape::bend) {
    add_polygon(pslg, {{0, 0}, {l, 0}, {l, w}, {w, w}, {w, l}, {0, l}}, channel);
  } else if (channel.shape == Shape::ring) {
    add_polygon(pslg, {{0, 0}, {l, 0}, {l, l}, {0, l}}, channel);
    add_polygon(pslg, {{w, w}, {l - w, w}, {l - w, l - w}, {w, l - w}}, channel);
    pslg.holes.push_back({l / 2, l / 2});
  } else if (channel.shape == Shape::slant) {
    add_polygon(pslg, {{0, 0}, {l, 0}, {l + w / 2, w}, {w / 2, w}}, channel);
  } else if (channel.has_wall) {
    add_polygon(pslg, {{0, 0}, {l / 2, 0}, {l, 0}, {l, w}, {l / 2, w}, {0, w}}, channel);
    pslg.segments.push_back({1, 4});
    pslg.regions.push_back({{l - 2, w / 2}, 1, channel.max_area / 2});
  } else {
    add_polygon(pslg, {{0, 0}, {l, 0}, {l, w}, {0, w}}, channel);
  }
  if (channel.has_crack) {
    const auto first = static_cast<Index>(pslg.points.size());
    pslg.points.insert(pslg.points.end(), {{l / 2 + w, w / 2}, {l / 2 + 2 * w, w / 2}});
    pslg.segments.push_back({first, first + 1});
  }
  return pslg;
}

[[nodiscard]] inline Goal goal_with(double max_area) {
  Goal goal;
  goal.max_area = max_area;
  goal.conforming = true;
  return goal;
}
[[nodiscard]] inline Goal goal_of(const Channel& channel) { return goal_with(channel.max_area); }
[[nodiscard]] inline Goal coarse_goal_of(const Channel& channel) {
  Goal goal = goal_with(channel.coarse_area);
  goal.region_caps = false;
  return goal;
}

[[nodiscard]] inline Channel random_channel(generators::Random& random, int /*size*/) {
  Channel channel;
  channel.shape = random.one_of<Shape>({Shape::bar, Shape::bar, Shape::bar, Shape::bar, Shape::bar, Shape::bar,
                                        Shape::bend, Shape::bend, Shape::ring, Shape::slant, Shape::slant});
  channel.width = 6 + 2 * random.between(0, 1);
  const double square = channel.width * channel.width;
  switch (channel.shape) {
    case Shape::bar:
      channel.length = random.between(8, 14);
      break;
    case Shape::bend:
      channel.length = random.between(6, 8);
      break;
    case Shape::ring:
      channel.length = random.between(6, 7);
      break;
    case Shape::slant:
      channel.length = random.between(1, 3);
      break;
    case Shape::block:
      break;
  }
  channel.has_wall = channel.shape == Shape::bar && random.chance(2);
  channel.has_crack = channel.shape != Shape::slant && random.chance(4);
  channel.coarse_area = channel.shape == Shape::slant ? 2 * square : square / random.between(1, 3);
  channel.max_area = channel.coarse_area / random.between(2, channel.shape == Shape::slant ? 16 : 3);
  const Channel straight = channel;
  if (random.chance(4)) return straight;
  for (Point& nudge : channel.nudges)
    nudge = {static_cast<double>(random.between(-1, 1)), static_cast<double>(random.between(-1, 1))};
  return ref::unsupported(to_pslg(channel), goal_of(channel)) ? straight : channel;
}

/// A block whose triangles, of about 28 units, need no preprocessing. The goal divides some of them.
[[nodiscard]] inline Channel random_block(generators::Random& random) {
  Channel channel;
  channel.shape = Shape::block;
  channel.seed = 1 + random.below(1'000'000);
  channel.coarse_area = 48;
  channel.max_area = random.between(22, 26);
  return channel;
}
[[nodiscard]] inline Channel random_channel_or_block(generators::Random& random, int size) {
  return random.chance(14) ? random_block(random) : random_channel(random, size);
}

/// Simpler channels: first with fewer features, then shorter, then with larger triangles.
[[nodiscard]] inline std::vector<Channel> simpler(const Channel& channel) {
  std::vector<Channel> all;
  const auto offer = [&](auto change) {
    Channel changed = channel;
    change(changed);
    if (!ref::unsupported(to_pslg(changed), goal_of(changed))) all.push_back(changed);
  };
  if (channel.shape == Shape::block) {
    if (channel.seed > 0) offer([](Channel& c) { c.seed = 0; });
    if (channel.max_area < 28) offer([](Channel& c) { ++c.max_area; });
    return all;
  }
  if (channel.shape == Shape::bend || channel.shape == Shape::ring) offer([](Channel& c) { c.shape = Shape::bar; });
  if (channel.has_wall) offer([](Channel& c) { c.has_wall = false; });
  if (channel.has_crack) offer([](Channel& c) { c.has_crack = false; });
  for (std::size_t k = 0; k < channel.nudges.size(); ++k)
    if (channel.nudges[k] != Point{}) offer([k](Channel& c) { c.nudges[k] = {}; });
  if (channel.length > (channel.shape == Shape::slant ? 1 : 5)) offer([](Channel& c) { --c.length; });
  if (channel.max_area < channel.coarse_area / 2) offer([](Channel& c) { c.max_area *= 1.5; });
  return all;
}

}  // namespace pardel::properties
