#include "problems.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../../core/digest.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/domains/generators/goals.hpp"

namespace pardel::determinism {
namespace {

double area_of_bounding_box(const Pslg& pslg) {
  const auto [left, right] = std::ranges::minmax(pslg.points, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(pslg.points, {}, &Point::y);
  return (right.x - left.x) * (high.y - low.y);
}

double largest_magnitude(const Pslg& pslg) {
  double largest = 0;
  for (const Point p : pslg.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return largest;
}

}  // namespace

Problem problem(generators::Family family, std::uint64_t number) {
  generators::Random random(number * generators::all_families().size() + static_cast<std::uint64_t>(family));
  const generators::LatticeDomain domain = generators::generate(family, random, static_cast<int>(3 * number));
  Problem p;
  p.what.pslg = to_pslg(domain);
  Goal& goal = p.what.goal = to_goal(generators::any_goal(domain, random), domain);
  // glibc rounds the cosine of this angle differently on processors with and without fused multiply-add.
  if (random.chance(4)) goal.min_angle_deg = 25.395;
  std::ostringstream name;
  name << generators::name(family) << ' ' << number << ", angles >= " << goal.min_angle_deg;
  if (!random.chance(8)) {  // otherwise the bound of the goal, which gives few triangles
    const int parts = random.between(2000, 10'000);
    goal.max_area = area_of_bounding_box(p.what.pslg) / parts;
    name << ", areas <= box / " << parts;
  }
  if (goal.region_caps && !p.what.pslg.regions.empty()) name << ", caps";
  if (goal.conforming) name << ", conforming";

  Options& options = p.options;
  options.min_edge = largest_magnitude(p.what.pslg) * 0x1p-40;
  options.triangles_per_tile = static_cast<std::uint32_t>(random.between(60, 240));
  name << ", tiles of " << options.triangles_per_tile;
  if (random.chance(2)) {
    options.decomposition = Decomposition::paper;
    name << ", the paper's";
  }
  if (random.chance(3)) {
    options.placement = Placement::circumcentre;
    name << ", circumcentres";
  }
  p.what.name = name.str();
  return p;
}

Problem graded_problem(std::uint64_t number) {
  const std::vector<generators::Family> families = generators::all_families();
  Problem p = problem(families[number % families.size()], number % problems_per_family);
  generators::Random random(number);
  const auto points = p.what.pslg.points;
  const Point centre = points[random.below(points.size())];
  const double extent = std::sqrt(area_of_bounding_box(p.what.pslg));
  const double least = extent * std::ldexp(1.0, -random.between(6, 12)), slope = 0.0625 * random.between(2, 4);
  p.what.goal.size = [=](Point q) {
    return least + slope * std::sqrt((q.x - centre.x) * (q.x - centre.x) + (q.y - centre.y) * (q.y - centre.y));
  };
  p.options.decomposition = number % 4 == 3 ? Decomposition::paper_quadtree : Decomposition::quadtree;
  const std::string paper = ", the paper's";
  if (const auto at = p.what.name.find(paper); at != std::string::npos) p.what.name.erase(at, paper.size());
  p.what.name =
      "graded " + std::to_string(number) + (number % 4 == 3 ? ", paper's leaves," : "") + " of " + p.what.name;
  return p;
}

Problem filled_problem(std::uint64_t number) {
  const std::vector<generators::Family> families = generators::all_families();
  Problem p = problem(families[number % families.size()], number % problems_per_family);
  p.options.interior = Interior::fill;
  p.what.name = "filled " + std::to_string(number) + " of " + p.what.name;
  return p;
}

std::string line(const Problem& problem, int threads) {
  Options options = problem.options;
  options.threads = threads;
  const Result<Meshed> meshed = mesh(problem.what.pslg, problem.what.goal, options);
  return problem.what.name + ": " + (meshed ? to_string(digest(meshed->mesh)) : meshed.error().message);
}

}  // namespace pardel::determinism
