// Meshers that break the contract, each in its own way.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "../../off_the_shelf/breach.hpp"
#include "../../off_the_shelf/own_mesher.hpp"

namespace pardel {

/// pardel's own refiner, with a mistake in every `every`-th answer.
class BadMesher final : public SubdomainMesher {
 public:
  explicit BadMesher(BreachKind mistake, unsigned every = 1) : mistake_(mistake), every_(every) {}

  [[nodiscard]] MesherAbilities abilities() const override { return own_->abilities(); }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    const unsigned number = calls_++;
    RefinedSubdomain answer = own_->refine(subdomain);
    // By the subdomain, so that the mesh does not depend on the order of the calls.
    if (subdomain.triangles.size() % every_ == 0) {
      const RefinedSubdomain right = answer;
      spoil(subdomain, number, answer);
      if (answer.ending != right.ending || answer.triangles != right.triangles ||
          answer.points.size() != right.points.size() || answer.points.front().x != right.points.front().x)
        is_harmless_ = false;
    }
    return answer;
  }
  /// True if no answer was spoiled, because none of them gave an occasion.
  [[nodiscard]] bool is_harmless() const { return is_harmless_; }

 private:
  static void split_triangle(RefinedSubdomain& answer, Point p) {
    const auto point = static_cast<Index>(answer.points.size());
    answer.points.push_back(p);
    answer.edge_of_new_point.push_back(no_index);
    const auto v = answer.triangles.front();
    answer.triangles.front() = {v[0], v[1], point};
    answer.triangles.push_back({v[1], v[2], point});
    answer.triangles.push_back({v[2], v[0], point});
  }
  static Point inside(const RefinedSubdomain& answer, double part) {
    const auto& v = answer.triangles.front();
    const Point a = answer.points[v[0]], b = answer.points[v[1]], c = answer.points[v[2]];
    return {a.x + part * (b.x + c.x - 2 * a.x) / 2, a.y + part * (b.y + c.y - 2 * a.y) / 2};
  }

  void spoil(const Subdomain& subdomain, unsigned number, RefinedSubdomain& answer) const {
    using Ending = RefinedSubdomain::Ending;
    switch (mistake_) {
      case BreachKind::failed:
        answer.ending = Ending::failed;
        return;
      case BreachKind::crashed:
        answer.ending = Ending::crashed;
        return;
      case BreachKind::timed_out:
        answer.ending = Ending::timed_out;
        return;
      case BreachKind::unreadable:
        answer.ending = Ending::unreadable;
        return;
      case BreachKind::moved_point:
        answer.points.front().x += 1;
        return;
      case BreachKind::unusable_point:
        split_triangle(answer, {NAN, NAN});
        return;
      case BreachKind::too_many_points:
        answer.points.resize(subdomain.points.size() + subdomain.most_new_points + 1);
        return;
      case BreachKind::wrong_index:
        answer.triangles.front()[0] = no_index;
        return;
      case BreachKind::unused_point:
        answer.points.push_back(inside(answer, 0.5));
        answer.edge_of_new_point.push_back(no_index);
        return;
      case BreachKind::wrong_orientation:
        std::swap(answer.triangles.front()[0], answer.triangles.front()[1]);
        return;
      case BreachKind::overlap:
        answer.triangles.push_back(answer.triangles.front());
        return;
      case BreachKind::lost_edge:
      case BreachKind::open_edge:
        remove_triangle(mistake_, subdomain, answer);
        return;
      case BreachKind::split_frozen_edge:
      case BreachKind::off_segment:
        split_triangle_on_edge(mistake_, subdomain, answer);
        return;
      case BreachKind::outside_cell:
        split_triangle(answer, {1e6, 1e6});
        return;
      case BreachKind::too_short_edge:
        split_triangle(answer, inside(answer, 1e-14));
        return;
      case BreachKind::too_near_edge:
        split_triangle_near_edge(subdomain, answer);
        return;
      case BreachKind::other_answer:
        if (number % 2 == 1) answer.points.push_back({});
        return;
    }
  }

  /// Inserts a point just beside an edge of the subdomain, far from its ends.
  static void split_triangle_near_edge(const Subdomain& subdomain, RefinedSubdomain& answer) {
    for (auto& v : answer.triangles)
      for (const SubdomainEdge& e : subdomain.edges) {
        if (!has_edge(v, e)) continue;
        while (v[0] != e.a) std::rotate(v.begin(), v.begin() + 1, v.end());
        std::swap(v, answer.triangles.front());
        const auto& [a, b, c] = answer.triangles.front();
        const Point p = answer.points[a], q = answer.points[b], apex = answer.points[c];
        const Point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
        split_triangle(answer, {middle.x + 1e-13 * (apex.x - middle.x), middle.y + 1e-13 * (apex.y - middle.y)});
        return;
      }
  }

  /// Removes a triangle at the border, so that an edge is lost, or one inside, so that edges are open.
  static void remove_triangle(BreachKind mistake, const Subdomain& subdomain, RefinedSubdomain& answer) {
    const auto old = static_cast<Index>(subdomain.points.size());
    for (std::size_t i = 0; i < answer.triangles.size(); ++i) {
      int old_corners = 0;
      for (const Index v : answer.triangles[i]) old_corners += v < old ? 1 : 0;
      if ((mistake == BreachKind::open_edge) != (old_corners == 0)) continue;
      if (mistake == BreachKind::lost_edge && !has_edge(answer.triangles[i], subdomain.edges.front())) continue;
      answer.triangles.erase(answer.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
  }
  static bool has_edge(const std::array<Index, 3>& v, const SubdomainEdge& e) {
    for (std::size_t i = 0; i < 3; ++i)
      if (v[i] == e.a && v[(i + 1) % 3] == e.b) return true;
    return false;
  }
  static void split_triangle_on_edge(BreachKind mistake, const Subdomain& subdomain, RefinedSubdomain& answer) {
    for (Index i = 0; i < subdomain.edges.size(); ++i) {
      if (subdomain.edges[i].may_be_split != (mistake == BreachKind::off_segment)) continue;
      split_triangle(answer, inside(answer, 0.5));
      answer.edge_of_new_point.back() = i;
      return;
    }
  }

  BreachKind mistake_;
  unsigned every_;
  std::atomic<unsigned> calls_{0};
  std::atomic<bool> is_harmless_{true};
  std::unique_ptr<SubdomainMesher> own_ = own_mesher();
};

/// A mesher that does nothing.
class LazyMesher final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override { return {true, true, true, true, true}; }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override {
    RefinedSubdomain answer;
    answer.points = subdomain.points;
    answer.triangles = subdomain.triangles;
    return answer;
  }
};

}  // namespace pardel
