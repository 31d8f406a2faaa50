#include "../../../distributed/subdomain/subdomain.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../properties/domains/domains.hpp"

namespace pardel::engine {
namespace {

/// A rank that holds the whole triangulation, and has nothing in common with others.
struct Holder {
  Holder(const Triangulation& whole, int rank)
      : t(whole),
        vertices(static_cast<Index>(t.points.size()), max_engine_triangles),
        triangles(static_cast<Index>(t.slots.size()), max_engine_triangles),
        part(t, vertices, triangles, Name::rank(rank), {0, 0}) {}
  Triangulation t;
  IndexAllocator vertices, triangles;
  Subdomain part;
};

/// A third rank may send a triangle that this rank has named, and that it has sent to nobody itself.
TEST(Subdomain, knows_that_others_know_a_triangle_that_comes_from_them) {
  const Result<DomainTriangulation> domain = triangulate_domain(domains::square(), false);
  ASSERT_TRUE(domain) << domain.error().message;
  const Triangulation& whole = domain->triangulation;
  Holder home(whole, 0), away(whole, 1);
  for (VertexId v = 0; v < whole.points.size(); ++v) away.part.name_vertex(v, {Name::rank(0), v});
  for (TriangleId id = 0; id < whole.slots.size(); ++id) away.part.name_triangle(id, {Name::rank(0), id});
  EXPECT_FALSE(home.part.is_known_elsewhere(0));
  Writer message;
  away.part.write(std::vector<TriangleId>{0}, {}, message);
  const std::vector<Ranks::Bytes> arrived{message.take()};
  home.part.read(arrived);
  EXPECT_TRUE(home.part.is_known_elsewhere(0));
  EXPECT_FALSE(home.part.is_known_elsewhere(1));
}

}  // namespace
}  // namespace pardel::engine
