// To be started by mpirun: the ranks of the job make the meshes that one process makes, with 1 to 3 threads per rank.
//   same_mesh small     50 domains: lattice domains of all families, named domains, uniform and graded
//   same_mesh large     the pipe and the square with 1 million triangles
//   same_mesh huge      the same with 10 million triangles; not part of the suite
// The digests are equal, and no piece has a marker, an attribute or an origin that the whole mesh has not.
// If the ranks can begin with parts of the domain, as pardel-mpi does, they make the mesh in this way, too.
// Exit status 0 if there are no differences, and most meshes lie on several ranks. The first rank names those that
// differ.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "../../core/digest.hpp"
#include "../../core/support/collective.hpp"
#include "../../distributed/distributed.hpp"
#include "../../mpi/mpi_ranks.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/comparison/all_arrays.hpp"
#include "../../properties/domains/dealt_domain.hpp"
#include "../../properties/domains/domains.hpp"
#include "../../properties/domains/generators/goals.hpp"

namespace pardel {
namespace {

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
  Options options;
};

/// Sizes that grow with the distance from the first point.
std::function<double(Point)> growing_sizes(const Pslg& pslg, double least) {
  const Point centre = pslg.points.front();
  return [=](Point p) { return least + 0.1 * std::hypot(p.x - centre.x, p.y - centre.y); };
}

std::vector<Case> small_cases() {
  std::vector<Case> cases;
  constexpr std::size_t random_domains = 38;
  constexpr int largest_size = 40;
  const std::vector<generators::Family>& families = generators::all_families();
  for (std::size_t seed = 0; seed < random_domains; ++seed) {
    generators::Random random(seed);
    generators::LatticeDomain domain = generators::generate(families[seed % families.size()], random, largest_size);
    const generators::LatticeGoal goal = generators::any_goal(domain, random);
    domain.decorations = generators::any_switches<generators::Decorations>(random);
    Case made{"domain " + std::to_string(seed), to_pslg(domain), to_goal(goal, domain), {}};
    made.options.triangles_per_tile = 5;
    if (seed % 3 == 0) made.goal.size = growing_sizes(made.pslg, std::sqrt(std::min(made.goal.max_area, 1.0)));
    if (seed % 4 == 0) made.options.decomposition = Decomposition::quadtree;
    cases.push_back(std::move(made));
  }
  const std::vector<std::pair<std::string, Pslg>> named = {
      {"square", domains::square()}, {"pipe", domains::pipe()},        {"key", domains::key()},
      {"cracks", domains::cracks()}, {"wedge", domains::wedge(20, 7)}, {"points", domains::random_points(2000, 1)}};
  for (const auto& [name, pslg] : named) {
    cases.push_back({name, pslg, {.min_angle_deg = 28, .max_area = 0.0005}, {.triangles_per_tile = 200}});
    cases.push_back({name + ", graded", pslg, {.size = growing_sizes(pslg, 0.01)}, {.triangles_per_tile = 200}});
  }
  return cases;
}

/// `scale`: how many times as many triangles as one million.
std::vector<Case> large_cases(double scale) {
  return {{"pipe", domains::pipe(), {.max_area = 3.4e-6 / scale}, {}},
          {"square", domains::square(), {.max_area = 1.37e-6 / scale}, {}}};
}

struct Count {
  int runs = 0;
  int divided = 0;  ///< begun with parts of the domain
  int shared = 0;   ///< several ranks have triangles
  int differences = 0;
};

/// Compares the meshes of the ranks with that of one process.
void compare(const Case& c, Ranks& ranks, Count& count) {
  const ValidPslg domain = std::move(validate(c.pslg)).value();
  Options options = c.options;
  options.threads = 1;
  const Result<Meshed> whole = mesh(domain, c.goal, options);
  if (!whole) MPI_Abort(MPI_COMM_WORLD, 2);
  const Digest expected = digest(whole->mesh);
  const auto look_at = [&](const Result<MeshPiece>& piece, const char* begun) {
    if (!piece) {
      std::printf("%s, %s: %s\n", c.name.c_str(), begun, piece.error().message.c_str());
      MPI_Abort(MPI_COMM_WORLD, 2);
    }
    ++count.runs;
    if (sum_of(piece->mesh.triangles.empty() ? 0 : 1, ranks) > 1) ++count.shared;
    const bool is_same_digest = digest(*piece, ranks) == expected;
    const bool is_small = whole->mesh.triangles.size() < 100'000;  // the comparison of all arrays takes long
    const std::string excess = is_small ? properties::excess(piece->mesh, whole->mesh) : "";
    if (is_same_digest && excess.empty()) return;
    ++count.differences;
    std::printf("%s, begun with %s, %d threads: another mesh; %s\n", c.name.c_str(), begun, options.threads,
                excess.c_str());
  };
  for (options.threads = 1; options.threads <= 3; ++options.threads) {
    look_at(mesh(domain, c.goal, options, ranks), "the whole domain");
    if (!can_divide_points(c.goal, options)) continue;
    look_at(mesh(domains::equal_part(c.pslg, ranks), c.goal, options, ranks), "a part of the domain");
    ++count.divided;
  }
}

int run(std::string_view which) {
  const bool is_small = which == "small";
  constexpr std::size_t short_parts = 1000;  // so messages travel in several parts
  constexpr std::size_t usual_parts = std::size_t{1} << 30U;
  mpi::MpiRanks ranks(is_small ? short_parts : usual_parts);
  const std::vector<Case> cases = is_small ? small_cases() : large_cases(which == "huge" ? 10 : 1);
  Count count;
  for (const Case& c : cases) compare(c, ranks, count);
  if (ranks.rank() == 0)
    std::printf(
        "%zu domains on %d ranks with 1 to 3 threads: %d meshes, %d of them of a divided domain, %d with triangles "
        "on several ranks, %d differences\n",
        cases.size(), ranks.count(), count.runs, count.divided, count.shared, count.differences);
  const bool are_shared = ranks.count() == 1 || 4 * count.shared > 3 * count.runs;
  return count.differences == 0 && count.divided > 0 && are_shared ? 0 : 1;
}

}  // namespace
}  // namespace pardel

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  const int code = pardel::run(argc > 1 ? argv[1] : "small");
  MPI_Finalize();
  return code;
}
