// Messages between processes: what arrives is what was sent.
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <cmath>
#include <limits>
#include <thread>

#include "../../core/support/stop_signal.hpp"
#include "../../off_the_shelf/meshers/channel.hpp"
#include "../../off_the_shelf/meshers/messages.hpp"
#include "../../off_the_shelf/meshers/sampled_sizes.hpp"
#include "../../off_the_shelf/meshers/worker.hpp"
#include "scripted_mesher.hpp"

namespace pardel::engine {
namespace {

using Outcome = Channel::Outcome;
constexpr double infinity = std::numeric_limits<double>::infinity();

std::pair<Channel, Channel> two_channels() {
  auto ends = connected_sockets(SOCK_STREAM);
  return {Channel(std::move(ends->first)), Channel(std::move(ends->second))};
}
Channel::Clock::time_point soon() { return Channel::Clock::now() + std::chrono::milliseconds(20); }

/// The square from (0, 0) to (side, side) in two triangles.
Subdomain square_in_two(double side) {
  Subdomain subdomain;
  subdomain.points = {{0, 0}, {side, 0}, {side, side}, {0, side}};
  subdomain.triangles = {{0, 1, 2}, {0, 2, 3}};
  return subdomain;
}

TEST(ProcessMessages, a_subdomain_arrives_with_all_numbers) {
  Subdomain sent = one_triangle();
  sent.points[1] = {0x1.123456789abcdp+3, -0.0};
  sent.edges[2].inside = true;
  sent.max_areas = {0.125};
  sent.goal = {.min_angle_deg = 25.5, .max_area = 0.25, .max_edge = 2};
  sent.cell = SubdomainCell{{-infinity, 1}, {3, infinity}};
  sent.min_edge = 1e-9;
  sent.most_new_points = 123'456'789'012;
  const Subdomain got = subdomain_from(to_bytes(sent, 7.5));
  EXPECT_EQ(got.points, sent.points);
  EXPECT_TRUE(std::signbit(got.points[1].y));
  EXPECT_EQ(got.triangles, sent.triangles);
  ASSERT_EQ(got.edges.size(), sent.edges.size());
  for (std::size_t i = 0; i < got.edges.size(); ++i) {
    EXPECT_EQ(got.edges[i].a, sent.edges[i].a);
    EXPECT_EQ(got.edges[i].b, sent.edges[i].b);
    EXPECT_EQ(got.edges[i].inside, sent.edges[i].inside);
    EXPECT_EQ(got.edges[i].may_be_split, sent.edges[i].may_be_split);
  }
  EXPECT_EQ(got.max_areas, sent.max_areas);
  EXPECT_EQ(got.goal.min_angle_deg, 25.5);
  EXPECT_EQ(got.goal.max_area, 0.25);
  EXPECT_EQ(got.goal.max_edge, 2);
  EXPECT_FALSE(got.goal.size);
  ASSERT_TRUE(got.cell);
  EXPECT_EQ(got.cell->low, sent.cell->low);
  EXPECT_EQ(got.cell->high, sent.cell->high);
  EXPECT_EQ(got.min_edge, 1e-9);
  EXPECT_EQ(got.most_new_points, sent.most_new_points);
  EXPECT_EQ(got.seconds, 7.5);
  sent.cell.reset();
  EXPECT_FALSE(subdomain_from(to_bytes(sent, 7.5)).cell);
}

TEST(ProcessMessages, an_answer_arrives_with_everything) {
  RefinedSubdomain sent = unchanged(one_triangle(), "why not");
  sent.ending = RefinedSubdomain::Ending::limit;
  sent.points.push_back({0.5, 0.25});
  sent.edge_of_new_point = {no_index};
  const RefinedSubdomain got = answer_from(to_bytes(sent));
  EXPECT_EQ(got.ending, sent.ending);
  EXPECT_EQ(got.why, sent.why);
  EXPECT_EQ(got.points, sent.points);
  EXPECT_EQ(got.edge_of_new_point, sent.edge_of_new_point);
  EXPECT_EQ(got.triangles, sent.triangles);
}

TEST(ProcessMessages, no_part_of_a_message_is_a_message) {
  const Bytes answer = to_bytes(unchanged(one_triangle(), "why")), subdomain = to_bytes(one_triangle(), 1);
  for (std::size_t size = 0; size < answer.size(); ++size)
    EXPECT_THROW((void)answer_from(std::span(answer).first(size)), Stopped);
  for (std::size_t size = 0; size < subdomain.size(); ++size)
    EXPECT_THROW((void)subdomain_from(std::span(subdomain).first(size)), Stopped);
}

TEST(ProcessMessages, more_than_a_message_or_an_unknown_ending_is_no_answer) {
  Bytes answer = to_bytes(unchanged(one_triangle()));
  answer.push_back({});
  EXPECT_THROW((void)answer_from(answer), Stopped);
  answer.pop_back();
  answer[8] = std::byte{6};  // after the length of the list with the ending
  EXPECT_THROW((void)answer_from(answer), Stopped);
}

TEST(ProcessMessages, sizes_are_linear_between_the_places_where_they_are_known) {
  Subdomain sent = square_in_two(3);
  sent.goal.size = [](Point p) { return 1 + p.x / 3 + p.y / 6; };
  const auto size = subdomain_from(to_bytes(sent, 1)).goal.size;
  for (double x = 0; x <= 3; x += 0.125)
    for (double y = 0; y <= 3; y += 0.125) EXPECT_NEAR(size({x, y}), sent.goal.size({x, y}), 1e-12);
}

TEST(ProcessMessages, a_size_at_a_centroid_counts_around_it) {
  Subdomain sent = square_in_two(3);
  sent.goal.size = [](Point p) { return p == Point{2, 1} ? 0.5 : 2.0; };
  const auto size = subdomain_from(to_bytes(sent, 1)).goal.size;
  EXPECT_EQ(size({2, 1}), 0.5);
  EXPECT_EQ(size({3, 0}), 2);
  EXPECT_EQ(size({1, 2}), 2);
  EXPECT_NEAR(size({2.5, 0.5}), 1.25, 1e-12);  // halfway from the centroid to a corner
}

TEST(ProcessMessages, infinite_sizes_become_sizes_that_bound_no_edge) {
  Subdomain sent = square_in_two(3);
  sent.goal.size = [](Point p) { return p.x > 1 ? infinity : 1.0; };
  const std::vector<double> values = sample_sizes(sent);
  const double diagonal = std::hypot(3, 3);
  EXPECT_EQ(values, (std::vector<double>{1, diagonal, diagonal, 1, diagonal, 1}));
}

TEST(ProcessMessages, sizes_are_found_among_triangles_of_all_sizes) {
  // Fans around the points (2^-i, 0): triangles whose sizes differ by 2^40.
  Subdomain sent;
  for (int i = 0; i < 40; ++i) {
    const double x = std::ldexp(1, -i);
    const auto first = static_cast<Index>(sent.points.size());
    sent.points.insert(sent.points.end(), {{x, 0}, {1.5 * x, 0}, {1.5 * x, x}});
    sent.triangles.push_back({first, first + 1, first + 2});
  }
  sent.goal.size = [](Point p) { return p.x; };
  const SampledSizes sizes(sent.points, sent.triangles, sample_sizes(sent));
  for (int i = 0; i < 40; ++i) {
    const double x = std::ldexp(1.25, -i);
    EXPECT_NEAR(sizes.at({x, 0.1 * x}), std::min(x, 1.8), 1e-12 * x);
  }
  EXPECT_EQ(sizes.at({1e9, 1e9}), infinity);
  EXPECT_EQ(sizes.at({-1e300, 1e300}), infinity);
}

TEST(ProcessMessages, large_messages_arrive_in_order) {
  auto [here, there] = two_channels();
  std::vector<std::byte> body(5'000'000);
  for (std::size_t i = 0; i < body.size(); ++i) body[i] = static_cast<std::byte>(i * i >> 3U);
  std::thread sender([&, channel = &here] {
    EXPECT_EQ(channel->send(1, body), Outcome::done);
    EXPECT_EQ(channel->send(2, {}), Outcome::done);
  });
  Channel::Message message;
  EXPECT_EQ(there.receive(message), Outcome::done);
  EXPECT_EQ(message.number, 1U);
  EXPECT_EQ(message.body, body);
  EXPECT_EQ(there.receive(message), Outcome::done);
  EXPECT_EQ(message.number, 2U);
  EXPECT_TRUE(message.body.empty());
  sender.join();
}

TEST(ProcessMessages, late_ones_are_not_waited_for) {
  auto [here, there] = two_channels();
  Channel::Message message;
  EXPECT_EQ(here.receive(message, soon()), Outcome::late);
  EXPECT_EQ(here.send(1, std::vector<std::byte>(5'000'000), soon()), Outcome::late);  // nobody reads
}

TEST(ProcessMessages, a_closed_end_is_noticed_without_a_signal) {
  auto [here, there] = two_channels();
  { const Channel closed = std::move(there); }
  Channel::Message message;
  EXPECT_EQ(here.receive(message), Outcome::closed);
  EXPECT_EQ(here.send(1, std::vector<std::byte>(10)), Outcome::closed);
}

TEST(ProcessMessages, a_length_that_never_arrives_takes_no_memory) {
  auto ends = connected_sockets(SOCK_STREAM);
  auto probe = connected_sockets(SOCK_STREAM);
  // The header of a message, of which the last eight bytes are the length.
  Channel sender(std::move(probe->first));
  ASSERT_EQ(sender.send(1, {}), Outcome::done);
  std::array<std::byte, 24> header{};
  ASSERT_EQ(recv(probe->second.number(), header.data(), header.size(), 0), 24);
  header.back() = std::byte{0x7f};
  ASSERT_EQ(::send(ends->first.number(), header.data(), header.size(), 0), 24);
  Channel receiver(std::move(ends->second));
  Channel::Message message;
  EXPECT_EQ(receiver.receive(message, soon()), Outcome::late);
  EXPECT_LE(message.body.size(), 1U << 20U);
}

TEST(ProcessMessages, words_are_damaged_messages) {
  auto ends = connected_sockets(SOCK_STREAM);
  ASSERT_EQ(::send(ends->first.number(), "these words are no message", 26, 0), 26);
  Channel receiver(std::move(ends->second));
  Channel::Message message;
  EXPECT_EQ(receiver.receive(message), Outcome::damaged);
}

TEST(ProcessMessages, are_served_until_the_other_end_is_closed) {
  auto [here, there] = two_channels();
  ScriptedMesher mesher([](const Subdomain& subdomain) { return unchanged(subdomain, "served"); });
  std::thread server([&mesher, channel = &there] { serve(mesher, *channel); });
  {
    Channel client = std::move(here);
    Channel::Message message;
    ASSERT_EQ(client.send(5, to_bytes(one_triangle(), 1)), Outcome::done);
    ASSERT_EQ(client.receive(message), Outcome::done);
    EXPECT_EQ(message.number, 5U);
    EXPECT_EQ(answer_from(message.body).why, "served");
    ASSERT_EQ(client.send(6, std::vector<std::byte>(3)), Outcome::done);
    ASSERT_EQ(client.receive(message), Outcome::done);
    EXPECT_EQ(answer_from(message.body).ending, RefinedSubdomain::Ending::failed);
  }
  server.join();
}

}  // namespace
}  // namespace pardel::engine
