#include "../../../distributed/subdomain/held_segments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace pardel::engine {
namespace {

/// Spokes of different lengths that meet at half a degree. So there are places beside their ends.
Pslg spokes() {
  Pslg pslg;
  pslg.has_segment_markers = true;
  pslg.points.push_back({0, 0});
  for (unsigned i = 0; i < 6; ++i) {
    const double angle = i * 0.5 * std::numbers::pi / 180, length = 1 + 0.3 * ((i * 2) % 5);
    pslg.points.push_back({length * std::cos(angle), length * std::sin(angle)});
    pslg.segments.push_back({0, i + 1, static_cast<int>(i) + 10});
  }
  return pslg;
}

/// A rank that knows all segments.
struct Home {
  DomainTriangulation domain = triangulate_domain(spokes(), true).value();
  [[nodiscard]] std::vector<VertexId> vertices() const {
    std::vector<VertexId> all(domain.triangulation.points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
};

/// What travels with all vertices. `common`: how many segments all ranks know.
Ranks::Bytes message_from(Home& home, Index common) {
  HeldSegments segments(home.domain, Name::rank(0), common);
  Writer message;
  segments.write(
      segments.leaving_with(home.vertices()), [](VertexId v) { return v; }, message);
  return message.take();
}

void expect_refused(const Ranks::Bytes& message, HeldSegments& segments, std::span<const VertexId> vertices) {
  Reader reader(message);
  try {
    segments.read(reader, vertices);
    ADD_FAILURE() << "the message was taken";
  } catch (const Stopped& stopped) {
    EXPECT_EQ(stopped.error.kind, ErrorKind::internal) << stopped.error.message;
  }
}

TEST(HeldSegments, travel_with_their_angles_and_with_the_places_beside_their_ends) {
  Home home;
  const std::size_t n = home.domain.triangulation.points.size();
  const Ranks::Bytes message = message_from(home, 0);
  // The other rank numbers its vertices in the opposite order.
  std::vector<VertexId> there = home.vertices();
  std::ranges::reverse(there);
  DomainTriangulation other;
  HeldSegments arrived(other, Name::rank(1), 0);
  for (int times = 0; times < 2; ++times) {
    Reader reader(message);
    arrived.read(reader, there);
    EXPECT_TRUE(reader.empty());
  }
  const DomainSegments& before = home.domain.segments;
  const DomainSegments& after = other.segments;
  ASSERT_EQ(after.size(), before.size()) << "a segment that arrives twice is the same segment";
  const auto renumbered = [&](VertexId v) { return v == no_index ? no_index : there[v]; };
  std::size_t places = 0, narrow = 0;
  std::vector<Index> here_of(before.size());
  for (Index s = 0; s < before.size(); ++s) {
    const Index segment = segment_of_origin(arrived.arrived_origin(Names::packed({Name::rank(0), s})));
    ASSERT_LT(segment, after.size());
    here_of[s] = segment;
    EXPECT_EQ(after[segment].a, renumbered(before[s].a));
    EXPECT_EQ(after[segment].b, renumbered(before[s].b));
    EXPECT_EQ(after[segment].cosine_at_a, before[s].cosine_at_a);
    EXPECT_EQ(after[segment].cosine_at_b, before[s].cosine_at_b);
    EXPECT_EQ(after[segment].narrow_apex, renumbered(before[s].narrow_apex));
    EXPECT_EQ(other.input_segment[segment], home.domain.input_segment[s]);
    EXPECT_EQ(other.segments[segment].marker, home.domain.segments[s].marker);
    const auto expected = before.places_beside_ends(s), found = after.places_beside_ends(segment);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].apex, renumbered(expected[i].apex));
      EXPECT_EQ(found[i].distance, expected[i].distance);
      EXPECT_EQ(found[i].gap, expected[i].gap);
    }
    places += found.size();
    narrow += before[s].narrow_apex != no_index ? 1 : 0;
  }
  EXPECT_GT(places, 0U);
  EXPECT_GT(narrow, 0U);
  for (VertexId v = 0; v < n; ++v) {
    std::vector<Index> expected;
    for (const Index s : before.segments_at(v)) expected.push_back(here_of[s]);
    const auto found = after.segments_at(renumbered(v));
    EXPECT_EQ(std::vector(found.begin(), found.end()), expected);
  }
}

TEST(HeldSegments, of_a_message_that_names_missing_vertices_are_refused) {
  Home home;
  const std::vector<VertexId> all = home.vertices();
  const std::span<const VertexId> too_few = std::span(all).first(1);
  DomainTriangulation empty;
  HeldSegments none(empty, Name::rank(1), 0);
  expect_refused(message_from(home, 0), none, too_few);
  // No segment travels, but the vertices at which the common ones end do.
  const auto common = static_cast<Index>(home.domain.segments.size());
  DomainTriangulation same = home.domain;
  HeldSegments known(same, Name::rank(1), common);
  expect_refused(message_from(home, common), known, too_few);
}

TEST(HeldSegments, of_a_message_that_names_unknown_segments_are_refused) {
  Home home;
  DomainTriangulation empty;
  HeldSegments none(empty, Name::rank(1), 0);
  expect_refused(message_from(home, static_cast<Index>(home.domain.segments.size())), none, home.vertices());
}

}  // namespace
}  // namespace pardel::engine
