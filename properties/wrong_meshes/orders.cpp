// The order of chains around an input point, changed within two units.
#include "families.hpp"

namespace pardel::wrong_meshes {
namespace orders {
namespace {

using generators::Random;
using enum ViolationKind;

/// Segments from (4, 8) to (10, 8) and to a point of y = 8 and a few units, further right. In the mesh the chain of the
/// longer one passes below the end of the shorter one.
template <int others>
std::optional<WrongMesh> longer_below_shorter(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  drawing.ring({drawing.point(0, 0), drawing.point(20, 0), drawing.point(20, 16), drawing.point(0, 16)});
  const int units = random.between(1, 2);
  const Index apex = drawing.point(4, 8), near = drawing.point(10, 8), far = drawing.point(beside(16, units));
  const bool begin_there = random.between(0, 1) == 0;
  const auto from_apex = [&](Index to) { return begin_there ? drawing.segment(apex, to) : drawing.segment(to, apex); };
  from_apex(near);
  const Index longer = from_apex(far);
  const std::pair<double, double> ends[] = {{1, 8}, {4, 12}, {5, 3}};
  for (int i = 0; i < others; ++i) drawing.segment(apex, drawing.point(ends[i].first, ends[i].second));
  drawing.on(longer, beside(10, -1));
  drawing.fault({drawing.at(apex)}, 1);
  return finished(drawing, random);
}

/// The ends of the two segments are joined by a third, so that they bound a thin face. In the mesh it is turned over.
std::optional<WrongMesh> face_turned_over(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing(some_place(random));
  const Beside beside(drawing.place);
  drawing.ring({drawing.point(0, 0), drawing.point(20, 0), drawing.point(20, 16), drawing.point(0, 16)});
  const Index apex = drawing.point(4, 8), near = drawing.point(10, 8), far = drawing.point(beside(16, 1));
  drawing.segment(apex, near);
  const Index longer = drawing.segment(apex, far);
  drawing.segment(near, far);
  drawing.on(longer, beside(10, -1));
  drawing.region(2, 2, 1);
  drawing.fault({drawing.at(apex), drawing.at(near), drawing.at(far)}, 1);
  return drawing.draw();
}

/// Two segments around the apex have no order.
std::optional<WrongMesh> only_two(std::uint64_t seed) { return longer_below_shorter<0>(seed); }

const std::vector<ViolationKind> order{wrong_chain_order};

const Kind kinds[] = {
    {"orders", "of three chains around a point two have changed places", order, longer_below_shorter<1>},
    {"orders", "of four chains around a point two have changed places", order, longer_below_shorter<2>},
    {"orders", "of five chains around a point two have changed places", order, longer_below_shorter<3>},
    {"orders", "a thin face is turned over", {wrong_chain_order, wrong_face, broken_segment}, face_turned_over},
    {"right", "two chains around a point lie on either side of each other", {}, only_two},
};

}  // namespace
}  // namespace orders

std::span<const Kind> kinds_of_orders() { return orders::kinds; }

}  // namespace pardel::wrong_meshes
