// SizeSource: a place at which an edge length is wanted, and from which wanted lengths grow.
#pragma once

#include "pslg.hpp"

namespace pardel {

/// A straight piece from a to b. The wanted length changes linearly from at_a to at_b. A piece with a == b is a point,
/// with the length at_a. Coordinates are finite; lengths are finite and > 0.
struct SizeSource {
  Point a, b;
  double at_a = 0, at_b = 0;
  friend bool operator==(const SizeSource&, const SizeSource&) = default;
};

}  // namespace pardel
