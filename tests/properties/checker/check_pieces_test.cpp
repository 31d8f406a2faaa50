// The certificate of a mesh in pieces is that of the joined mesh.
#include "../../../properties/checker/check_pieces.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "../../../core/support/shortest.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/checker/check.hpp"
#include "../../../properties/defects/defects.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/domains/generators/goals.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../../properties/theorems/framework/property.hpp"
#include "../../../properties/theorems/framework/rapidcheck_generators.hpp"
#include "../../../properties/theorems/framework/shares.hpp"
#include "cut_mesh.hpp"
#include "written_mesh.hpp"

namespace pardel {
namespace {

struct MeshedCase {
  Pslg pslg;
  Mesh mesh;
  Goal goal;
};

/// How a mesh is cut into pieces.
struct Cut {
  std::vector<std::size_t> owner;  ///< per triangle
  std::size_t count = 1;
};

/// Vertical slabs, blocks of consecutive triangles, or single triangles at random places. The pieces are in any order.
Cut some_cut(const Mesh& mesh) {
  Cut cut;
  cut.count = *rc::gen::inRange<std::size_t>(1, 8);
  const int way = *rc::gen::inRange(0, 3);
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  double left = INFINITY, right = -INFINITY;
  for (const Point& p : mesh.points) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double share = right > left ? (mesh.points[mesh.triangles[t].v[0]].x - left) / (right - left) : 0;
    const std::size_t last = cut.count - 1;
    // If a coordinate is no number, the share is none, too.
    const auto slab = share < 1 ? static_cast<std::size_t>(share * static_cast<double>(cut.count)) : last;
    cut.owner.push_back(way == 0   ? std::min(slab, last)
                        : way == 1 ? t * cut.count / mesh.triangles.size()
                                   : random.below(cut.count));
  }
  std::vector<std::size_t> place(cut.count);
  std::iota(place.begin(), place.end(), std::size_t{0});
  for (std::size_t i = cut.count; i > 1; --i) std::swap(place[i - 1], place[random.below(i)]);
  for (std::size_t& owner : cut.owner) owner = place[owner];
  return cut;
}

struct Checked {
  std::string fault;  ///< what the ranks do not agree on, or what is an error
  Certificate certificate;
  std::size_t readings = 0;  ///< of all pieces
};

/// Gives the pieces of one rank one after another, each as a new copy.
class PiecesInTurn {
 public:
  explicit PiecesInTurn(std::span<const NumberedMesh> pieces) : pieces_(pieces) {}
  [[nodiscard]] PiecesOfRank to_read() {
    return {pieces_.size(), [this](std::size_t i) -> Result<std::shared_ptr<const NumberedMesh>> {
              if (!last_.expired()) return Error{ErrorKind::internal, "a rank holds two pieces"};
              auto piece = std::make_shared<const NumberedMesh>(pieces_[i]);
              last_ = piece;
              ++readings_;
              return piece;
            }};
  }
  [[nodiscard]] std::size_t readings() const { return readings_; }

 private:
  std::span<const NumberedMesh> pieces_;
  std::weak_ptr<const NumberedMesh> last_;
  std::size_t readings_ = 0;
};

/// first[r]: the first piece of rank r. Pieces of a rank follow each other; a rank may have none.
Checked check_on_ranks(const Pslg& pslg, std::span<const NumberedMesh> pieces, const std::vector<std::size_t>& first,
                       const Goal& goal, const CheckOptions& options) {
  std::vector<Certificate> certificates(first.size());
  std::vector<std::string> errors(first.size());
  std::vector<std::size_t> readings(first.size());
  properties::on_ranks(static_cast<int>(first.size()), [&](Ranks& ranks) {
    const auto rank = static_cast<std::size_t>(ranks.rank());
    const std::size_t end = rank + 1 < first.size() ? first[rank + 1] : pieces.size();
    PiecesInTurn mine(pieces.subspan(first[rank], end - first[rank]));
    Result<Certificate> result = check(pslg, mine.to_read(), goal, options, ranks);
    if (result)
      certificates[rank] = std::move(*result);
    else
      errors[rank] = result.error().message;
    readings[rank] = mine.readings();
  });
  Checked checked{errors.front(), certificates.front(),
                  std::accumulate(readings.begin(), readings.end(), std::size_t{0})};
  for (std::size_t rank = 1; rank < first.size() && checked.fault.empty(); ++rank)
    if (errors[rank] != errors.front() || to_json(certificates[rank]) != to_json(certificates.front()))
      checked.fault = "rank " + std::to_string(rank) + " has another certificate";
  return checked;
}

/// One to five ranks. There can be more ranks than pieces.
std::vector<std::size_t> some_division(std::size_t pieces) {
  std::vector<std::size_t> first{0};
  for (int rank = *rc::gen::inRange(1, 6); rank > 1; --rank)
    first.push_back(*rc::gen::inRange<std::size_t>(0, pieces + 1));
  std::ranges::sort(first);
  return first;
}

struct Compared {
  Certificate whole;
  Checked pieces;
};

/// Cuts the mesh, checks the joined pieces, and the pieces on ranks. Nothing if the pieces cannot be joined.
std::optional<Compared> cut_and_checked(const MeshedCase& made, const CheckOptions& options) {
  const Cut cut = some_cut(made.mesh);
  std::function<bool()> again;
  generators::Random random(*rc::gen::arbitrary<std::uint32_t>());
  if (*rc::gen::element(false, false, true)) again = [&random] { return random.below(4) == 0; };
  properties::classify(again != nullptr, "vertices listed several times in a piece", 20);
  const std::vector<NumberedMesh> pieces = testing::cut_mesh(made.mesh, cut.owner, cut.count, again);
  const Result<Mesh> joined = join_pieces(pieces);
  if (!joined) return std::nullopt;
  const std::vector<std::size_t> division = some_division(pieces.size());
  properties::classify(division.size() > 1 && division.size() < pieces.size(), "ranks with several pieces", 10);
  return Compared{check(made.pslg, *joined, made.goal, options),
                  check_on_ranks(made.pslg, pieces, division, made.goal, options)};
}

MeshedCase lattice_mesh(properties::Exhibit& exhibit) {
  const auto simpler = [](const generators::Case& c) { return generators::shrinks(c); };
  const generators::Case c = *generators::generator(generators::any_case, simpler);
  MeshedCase made{to_pslg(c.domain), {}, to_goal(c.goal, c.domain)};
  exhibit.show(made.pslg);
  Result<Meshed> meshed = mesh(made.pslg, made.goal);
  RC_ASSERT(meshed.ok());
  made.mesh = std::move(meshed->mesh);
  return made;
}

PARDEL_PROPERTY(
    Pieces, have_the_certificate_of_the_whole_mesh,
    {.statement = "However a mesh is cut into pieces, and on however many ranks they lie, in any order, the ranks that "
                  "check them, one piece at a time, give the certificate of the joined mesh, character by character; "
                  "if bounds are missed, with the same numbers of violations.",
     .source = "properties/checker/check_pieces.hpp",
     .families = "lattice domains of every family; slabs, blocks of triangles, and triangles at random places, some "
                 "with vertices that a piece lists several times; one to five ranks"}) {
  MeshedCase made = lattice_mesh(exhibit);
  const CheckOptions options{.foreign = *rc::gen::arbitrary<bool>()};
  if (options.foreign && *rc::gen::arbitrary<bool>()) {
    made.mesh.origin.clear();
    made.mesh.point_markers.clear();
  }
  const std::optional<Compared> compared = cut_and_checked(made, options);
  RC_ASSERT(compared.has_value());
  const auto& [whole, checked] = *compared;
  properties::classify(whole.valid, "valid", 50);
  properties::classify(!made.pslg.regions.empty(), "with regions", 10);
  properties::classify(!whole.justified.empty(), "with justified triangles", 5);
  RC_ASSERT(checked.fault == "");
  RC_ASSERT(testing::verdict(checked.certificate) == testing::verdict(whole));
  if (whole.valid) RC_ASSERT(to_json(checked.certificate) == to_json(whole));
}

/// True if cut_mesh() can cut the mesh, and if join_pieces() can put the pieces together.
bool can_be_cut(const Mesh& mesh) {
  const std::size_t n = mesh.points.size();
  const auto fits = [](std::size_t size, std::size_t expected) { return size == 0 || size == expected; };
  return fits(mesh.origin.size(), n) && fits(mesh.point_markers.size(), n) &&
         fits(mesh.region.size(), mesh.triangles.size()) &&
         mesh.point_attributes.size() == n * mesh.attributes_per_point && !mesh.triangles.empty() &&
         std::ranges::all_of(
             mesh.triangles,
             [&](const Triangle& t) { return std::ranges::all_of(t.v, [&](Index v) { return v < n; }); }) &&
         std::ranges::all_of(mesh.constrained_edges, [&](const ConstrainedEdge& e) { return std::max(e.a, e.b) < n; });
}

PARDEL_PROPERTY(
    Pieces, with_a_defect_are_refused,
    {.statement =
         "However a mesh with a defect is cut into pieces, and on however many ranks they lie, the ranks refuse "
         "it if the checker of the joined mesh does.",
     .source = "properties/checker/check_pieces.hpp",
     .families = "lattice domains of every family, every defect of properties/defects; pieces as above; one to five "
                 "ranks"}) {
  MeshedCase made = lattice_mesh(exhibit);
  RC_PRE(check(made.pslg, made.mesh, made.goal).valid);
  const defects::Defect& defect =
      *rc::gen::elementOf(std::vector<defects::Defect>(defects::all().begin(), defects::all().end()));
  RC_PRE(defect.inject(made.pslg, made.mesh, made.goal, *rc::gen::arbitrary<std::uint32_t>()));
  RC_PRE(can_be_cut(made.mesh));
  const std::optional<Compared> compared = cut_and_checked(made, {.foreign = *rc::gen::arbitrary<bool>()});
  RC_PRE(compared.has_value());  // not if a coordinate is not a number
  const auto& [whole, checked] = *compared;
  properties::classify(!whole.valid, "refused", 50);
  RC_LOG() << defect.name << "\nwhole: " << testing::verdict(whole)
           << "\npieces: " << testing::verdict(checked.certificate) << '\n';
  RC_ASSERT(checked.fault == "");
  RC_ASSERT(checked.certificate.valid == whole.valid);
  RC_ASSERT(checked.certificate.vertices == whole.vertices);
  RC_ASSERT(checked.certificate.triangles == whole.triangles);
  RC_ASSERT(checked.certificate.constrained_edges == whole.constrained_edges);
}

/// A square with a crack, and with points in it and around it, with a marker and an attribute of each point. The points
/// with even numbers have no marker.
MeshedCase square_among_points() {
  MeshedCase made{domains::square(), {}, {.min_angle_deg = 20}};
  const Pslg scattered = domains::random_points(300, 21);
  for (const Point p : scattered.points) made.pslg.points.push_back({2 * p.x - 0.5, 2 * p.y - 0.5});
  const auto crack = static_cast<Index>(made.pslg.points.size());
  made.pslg.points.insert(made.pslg.points.end(), {{0.48, 0.5}, {0.53, 0.51}});
  made.pslg.segments.push_back({crack, crack + 1, 0});
  made.pslg.attributes_per_point = 1;
  for (Index i = 0; i < made.pslg.points.size(); ++i) {
    made.pslg.point_attributes.push_back(0.5 * i);
    made.pslg.point_markers.push_back(i % 2 == 0 ? 0 : static_cast<int>(i));
  }
  made.mesh = std::move(mesh(made.pslg, made.goal)).value().mesh;
  return made;
}

PARDEL_FACT(
    Pieces, with_points_on_no_segment_have_the_certificate_of_the_whole_mesh,
    {.statement = "what is wrong with a point on no segment, its place, its data or its number, is reported "
                  "as for the joined mesh",
     .source = "properties/checker/check_pieces.hpp",
     .families = "a square with a crack, with points in and around it, in three slabs; twelve kinds of damage"}) {
  const MeshedCase right = square_among_points();
  const Index inputs = static_cast<Index>(right.pslg.points.size()), last = inputs - 1;
  const auto is_used = [&](Index v) {
    return std::ranges::any_of(right.mesh.triangles, [&](const Triangle& t) { return std::ranges::count(t.v, v) > 0; });
  };
  Index inside = 4, outside = 4;
  while (!is_used(inside)) ++inside;
  while (is_used(outside) || right.pslg.point_markers[outside] == 0) ++outside;
  ASSERT_LT(std::max(inside, outside), last);
  const auto expect_same = [&](const std::string& damage, const auto& change, bool valid) {
    MeshedCase made = right;
    change(made);
    std::vector<std::size_t> owner;
    for (const Triangle& t : made.mesh.triangles)
      owner.push_back(static_cast<std::size_t>(std::clamp(3 * made.mesh.points[t.v[0]].x, 0.0, 2.0)));
    const std::vector<NumberedMesh> pieces = testing::cut_mesh(made.mesh, owner, 3);
    for (const bool foreign : {false, true}) {
      if (!foreign && made.mesh.origin.empty()) continue;  // only another mesher may leave them out
      ++facts.cases;
      const CheckOptions options{.foreign = foreign};
      const Certificate whole = check(made.pslg, join_pieces(pieces).value(), made.goal, options);
      const Checked checked = check_on_ranks(made.pslg, pieces, {0, 1, 2}, made.goal, options);
      EXPECT_EQ(checked.fault, "") << damage;
      EXPECT_EQ(whole.valid, valid) << damage;
      EXPECT_EQ(to_json(checked.certificate), to_json(whole)) << damage;
    }
  };
  expect_same(
      "none", [](MeshedCase&) {}, true);
  for (const Index v : {inside, outside})
    for (const int change : {0, 1}) {
      std::vector<NumberedMesh> pieces =
          testing::cut_mesh(right.mesh, std::vector<std::size_t>(right.mesh.triangles.size()), 2);
      NumberedMesh& other = pieces[1];
      other.mesh.points.push_back(right.mesh.points[v]);
      other.mesh.attributes_per_point = 1;
      other.mesh.point_attributes.push_back(right.mesh.point_attributes[v]);
      other.mesh.point_markers.push_back(right.mesh.point_markers[v]);
      other.mesh.origin.push_back(right.mesh.origin[v]);
      other.number.push_back(v);
      if (change == 1) {  // of the data, in both pieces
        other.mesh.point_markers[0] += 1;
        const auto at = std::ranges::find(pieces[0].number, v);
        pieces[0].mesh.point_markers[static_cast<std::size_t>(at - pieces[0].number.begin())] += 1;
      }
      ++facts.cases;
      const Certificate whole = check(right.pslg, join_pieces(pieces).value(), right.goal, {});
      const Checked checked = check_on_ranks(right.pslg, pieces, {0, 1}, right.goal, {});
      EXPECT_EQ(checked.fault, "");
      EXPECT_EQ(whole.valid, change == 0);
      EXPECT_EQ(to_json(checked.certificate), to_json(whole)) << (v == inside) << change;
    }
  expect_same(
      "no data", [](MeshedCase& made) { made.mesh.origin = {}, made.mesh.point_markers = {}; }, true);
  for (const Index v : {inside, outside}) {
    const Index next = v + 1;
    expect_same(
        "marker", [&](MeshedCase& made) { made.mesh.point_markers[v] += 1; }, false);
    expect_same(
        "attribute", [&](MeshedCase& made) { made.mesh.point_attributes[v] = NAN; }, false);
    expect_same(
        "origin", [&](MeshedCase& made) { made.mesh.origin[v] = interior_vertex; }, false);
    expect_same(
        "another place", [&](MeshedCase& made) { made.pslg.points[v].x += 1e-9; }, false);
    expect_same(
        "another number", [&](MeshedCase& made) { std::swap(made.pslg.points[v], made.pslg.points[next]); }, false);
  }
  expect_same(
      "the crack is not listed",
      [](MeshedCase& made) {
        std::erase_if(made.mesh.constrained_edges, [](const ConstrainedEdge& e) { return e.segment == 4; });
      },
      false);
  expect_same(
      "a listed edge ends there",
      [&](MeshedCase& made) {
        const auto at = std::ranges::find_if(made.mesh.triangles,
                                             [&](const Triangle& t) { return std::ranges::count(t.v, inside) > 0; });
        const auto& v = at->v;
        made.mesh.constrained_edges.push_back({inside, v[0] == inside ? v[1] : v[0], 0, 0});
      },
      false);
  // Points outside belong to the domain if it is the convex hull.
  expect_same(
      "outside", [](MeshedCase& made) { made.goal.convex_hull = true; }, false);
}

/// The square [0, 1] x [0, 1] in eight triangles around nine points. Each piece has four; with
/// second = 0, the first piece has all.
std::vector<NumberedMesh> two_halves(Index second = 1) {
  Mesh mesh;
  for (const double y : {0.0, 0.5, 1.0})
    for (const double x : {0.0, 0.5, 1.0}) mesh.points.push_back({x, y});
  std::vector<std::size_t> owner;
  for (const Index row : {0u, 1u})
    for (const Index column : {0u, 1u}) {
      const Index a = 3 * row + column;
      mesh.triangles.push_back({{a, a + 1, a + 4}});
      mesh.triangles.push_back({{a, a + 4, a + 3}});
      owner.insert(owner.end(), 2, row * second);
    }
  return testing::cut_mesh(mesh, owner, 2);
}

/// A square with an attribute, and its mesh.
MeshedCase square_with_attribute() {
  MeshedCase made{domains::square(), {}, {.max_area = 0.002}};
  made.pslg.attributes_per_point = 1;
  for (const Point p : made.pslg.points) made.pslg.point_attributes.push_back(p.x);
  made.mesh = std::move(mesh(made.pslg, made.goal)).value().mesh;
  return made;
}

/// A vertex of both pieces, such that no corner of a triangle around it lies on the boundary.
Index vertex_between(const Mesh& whole, const std::vector<std::size_t>& owner) {
  std::vector<std::set<std::size_t>> pieces(whole.points.size());
  std::vector<char> is_inside(whole.points.size(), 1);
  for (Index t = 0; t < whole.triangles.size(); ++t) {
    const auto& v = whole.triangles[t].v;
    for (const Index corner : v) pieces[corner].insert(owner[t]);
    if (std::ranges::any_of(v, [&](Index corner) { return whole.origin[corner] != interior_vertex; }))
      for (const Index corner : v) is_inside[corner] = 0;
  }
  for (Index v = 0; v < whole.points.size(); ++v)
    if (is_inside[v] != 0 && pieces[v].size() == 2) return v;
  return no_index;
}

/// What the check of two pieces says about their numbers; empty if it is no error. It has to be the same on one rank
/// that has both pieces, on two, and on more ranks than pieces; the ranks that report it are not named.
std::string error_of(const std::vector<NumberedMesh>& pieces) {
  std::set<std::string> errors;
  for (const std::vector<std::size_t>& division : {std::vector<std::size_t>{0}, {0, 1}, {0, 0, 1, 2}}) {
    std::string error = check_on_ranks(domains::square(), pieces, division, Goal{}, {.foreign = true}).fault;
    for (const char rank : {'0', '1', '2'})
      if (error.starts_with(std::string("rank ") + rank + ": ")) error.erase(0, 8);
    errors.insert(error);
  }
  return errors.size() == 1 ? *errors.begin()
                            : "the ranks do not agree on: " + *errors.begin() + ", " + *errors.rbegin();
}

PARDEL_FACT(Pieces, with_wrong_numbers_are_an_error,
            {.statement =
                 "pieces with a number that is missing, or belongs to points that differ in place or data, are no mesh",
             .source = "properties/checker/check_pieces.hpp",
             .families = "a square in two pieces; a square with points in one piece"}) {
  EXPECT_EQ(error_of(two_halves()), "");
  const auto number = [](NumberedMesh& piece, double x, double y) -> std::uint64_t& {
    const auto at = std::ranges::find(piece.mesh.points, Point{x, y});
    return piece.number[static_cast<std::size_t>(at - piece.mesh.points.begin())];
  };
  {  // in the interior of the only piece
    const MeshedCase made = square_among_points();
    NumberedMesh piece = testing::cut_mesh(made.mesh, std::vector<std::size_t>(made.mesh.triangles.size()), 1).front();
    const auto verdict = [&] {
      std::string text;
      properties::on_ranks(1, [&](Ranks& ranks) {
        const Result<Certificate> checked = check(made.pslg, piece, made.goal, {}, ranks);
        text = !checked ? checked.error().message : checked->valid ? "valid" : "not valid";
      });
      return text;
    };
    EXPECT_EQ(verdict(), "valid");
    const auto first = std::ranges::find(piece.mesh.origin, interior_vertex);
    const auto next = std::find(first + 1, piece.mesh.origin.end(), interior_vertex);
    const std::uint64_t twice = piece.number[static_cast<std::size_t>(first - piece.mesh.origin.begin())];
    piece.number[static_cast<std::size_t>(next - piece.mesh.origin.begin())] = twice;
    const auto place = [&](auto v) {
      return piece.mesh.points[static_cast<std::size_t>(v - piece.mesh.origin.begin())];
    };
    const auto [low, high] =
        std::ranges::minmax(std::array{place(first), place(next)}, {}, [](Point p) { return std::pair(p.x, p.y); });
    EXPECT_EQ(verdict(), "different points have the number " + std::to_string(twice) + ", at " + shortest(low) +
                             " and " + shortest(high));
    facts.cases += 2;
  }
  {
    std::vector<NumberedMesh> pieces = two_halves();
    number(pieces[0], 0, 0) = 100;
    EXPECT_EQ(error_of(pieces), "a point has the number 100, but the pieces have only 12 points");
  }
  {
    std::vector<NumberedMesh> pieces = two_halves();
    number(pieces[0], 0, 0) = 9;
    EXPECT_EQ(error_of(pieces), "no piece has the point with the number 0");
  }
  {
    std::vector<NumberedMesh> pieces = two_halves();
    std::swap(number(pieces[1], 0, 0.5), number(pieces[1], 0.5, 0.5));
    EXPECT_EQ(error_of(pieces), "different points have the number 3, at (0, 0.5) and (0.5, 0.5)");
  }
  for (const bool is_attribute : {false, true}) {
    std::vector<NumberedMesh> pieces = two_halves();
    for (NumberedMesh& piece : pieces) {
      piece.mesh.point_markers.resize(piece.mesh.points.size());
      piece.mesh.attributes_per_point = 1;
      piece.mesh.point_attributes.resize(piece.mesh.points.size());
    }
    const auto at = std::ranges::find(pieces[1].mesh.points, Point{0, 0.5}) - pieces[1].mesh.points.begin();
    if (is_attribute)
      pieces[1].mesh.point_attributes[static_cast<std::size_t>(at)] = 2;
    else
      pieces[1].mesh.point_markers[static_cast<std::size_t>(at)] = 2;
    EXPECT_EQ(error_of(pieces), "there are different data of the point with the number 3");
  }
  for (const bool is_right : {true, false}) {
    const MeshedCase made = square_with_attribute();
    std::vector<std::size_t> owner;
    for (const Triangle& t : made.mesh.triangles) owner.push_back(made.mesh.points[t.v[0]].x < 0.5 ? 0 : 1);
    std::vector<NumberedMesh> pieces = testing::cut_mesh(made.mesh, owner, 2);
    const Index between = vertex_between(made.mesh, owner);
    const auto at = std::ranges::find(pieces[1].number, std::uint64_t{between}) - pieces[1].number.begin();
    ASSERT_LT(at, static_cast<std::ptrdiff_t>(pieces[1].number.size()));
    if (!is_right) pieces[1].mesh.point_attributes[static_cast<std::size_t>(at)] = 99;
    const std::string expected =
        "there are different data of the point with the number " + std::to_string(static_cast<std::uint64_t>(between));
    for (const std::vector<std::size_t>& division : {std::vector<std::size_t>{0}, {0, 1}}) {
      const Checked checked = check_on_ranks(made.pslg, pieces, division, made.goal, {});
      EXPECT_EQ(checked.certificate.valid, is_right) << testing::verdict(checked.certificate);
      EXPECT_EQ(checked.fault.ends_with(expected), !is_right) << checked.fault;
    }
  }
  {
    std::vector<NumberedMesh> pieces = two_halves();
    pieces[0].number.pop_back();
    EXPECT_EQ(error_of(pieces), "a piece has points without numbers");
  }
  {
    // The vertex in the middle is in the interior of the first piece.
    std::vector<NumberedMesh> pieces = two_halves(0);
    pieces[1].mesh.points.push_back({0.5, 0.5});
    pieces[1].number.push_back(4);
    EXPECT_EQ(error_of(pieces), "");
    pieces[1].mesh.points[0] = {0.5, 0.25};
    EXPECT_EQ(error_of(pieces), "different points have the number 4, at (0.5, 0.25) and (0.5, 0.5)");
  }
  {
    // The vertex in the middle is in the interior of both pieces.
    std::vector<NumberedMesh> pieces = two_halves(0);
    pieces[1] = pieces[0];
    EXPECT_EQ(error_of(pieces), "");
    *std::ranges::find(pieces[1].mesh.points, Point{0.5, 0.5}) = {0.5, 0.25};
    EXPECT_EQ(error_of(pieces), "different points have the number 4, at (0.5, 0.25) and (0.5, 0.5)");
    pieces[1].number[4] = no_index;
    EXPECT_EQ(error_of(pieces), "a point has the number 4294967295, but the pieces have only 18 points");
  }
  {
    std::vector<NumberedMesh> pieces = two_halves();
    pieces[1].mesh.origin.resize(pieces[1].mesh.points.size(), interior_vertex);
    EXPECT_EQ(error_of(pieces), "the pieces do not have the same kinds of data");
  }
  facts.cases += 15;
}

PARDEL_FACT(
    Pieces, that_cannot_be_read_are_an_error_on_all_ranks,
    {.statement = "if a piece cannot be read, for the first or for the second time, or is another one when it is "
                  "read again, all ranks get the error",
     .source = "properties/checker/check_pieces.hpp",
     .families = "a square with a triangle below the angle bound, in two pieces"}) {
  std::vector<NumberedMesh> pieces = two_halves();
  Goal goal;
  goal.min_angle_deg = 50;  // each piece is read again, to describe the angles of 45 degrees
  const NumberedMesh other = two_halves(0).front();
  for (const bool on_one_rank : {false, true})
    for (const int last : {0, 2, 3, 4}) {  // the reading that fails; 0: none; a rank with one piece reads it once
      for (const bool changes : {false, true}) {
        if (on_one_rank ? last == 2 : last > 2) continue;
        std::vector<std::string> errors(2);
        properties::on_ranks(2, [&](Ranks& ranks) {
          const auto rank = static_cast<std::size_t>(ranks.rank());
          int readings = on_one_rank ? 0 : 1;
          PiecesOfRank mine{on_one_rank ? 2 - 2 * rank : 1, {}};
          mine.read = [&, rank](std::size_t i) -> Result<std::shared_ptr<const NumberedMesh>> {
            if (++readings == last && (on_one_rank || rank == 1)) {
              if (!changes || last <= 2) return Error{ErrorKind::io, "piece 1: gone"};
              return std::make_shared<const NumberedMesh>(other);
            }
            return std::make_shared<const NumberedMesh>(pieces[on_one_rank ? i : rank]);
          };
          const Result<Certificate> result = check(domains::square(), mine, goal, {.foreign = true}, ranks);
          errors[rank] = result ? "" : result.error().message;
        });
        const std::string expected = last == 0             ? ""
                                     : changes && last > 2 ? "a piece has changed since it was read for the first time"
                                                           : "piece 1: gone";
        const std::string who = expected.empty() ? "" : on_one_rank ? "rank 0: " : "rank 1: ";
        EXPECT_EQ(errors, std::vector<std::string>(2, who + expected)) << on_one_rank << last << changes;
        ++facts.cases;
      }
    }
}

PARDEL_FACT(
    Pieces, have_lists_of_regions_of_their_own,
    {.statement = "a piece read from a file lists only the attributes of its own triangles; pieces with different "
                  "lists are right on any number of ranks, and a piece that lists no regions at all is not",
     .source = "properties/checker/check_pieces.hpp",
     .families = "three squares, each a region and a piece"}) {
  Result<Meshed> meshed = mesh(domains::regions(), Goal{.max_area = 0.01});
  ASSERT_TRUE(meshed);
  const Mesh& whole = meshed->mesh;
  std::vector<std::size_t> owner(whole.region.begin(), whole.region.end());
  std::vector<NumberedMesh> pieces = testing::cut_mesh(whole, owner, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    pieces[i].mesh.region_attributes = {whole.region_attributes[i]};
    for (Index& region : pieces[i].mesh.region) region = 0;
  }
  const CheckOptions options{.foreign = true};
  const Certificate expected = check(domains::regions(), whole, Goal{.max_area = 0.01}, options);
  for (const std::vector<std::size_t>& division : {std::vector<std::size_t>{0}, {0, 1}, {0, 1, 2}, {0, 1, 2, 3}}) {
    const Checked checked = check_on_ranks(domains::regions(), pieces, division, Goal{.max_area = 0.01}, options);
    EXPECT_EQ(checked.fault, "");
    EXPECT_EQ(testing::verdict(checked.certificate), testing::verdict(expected)) << division.size();
    ++facts.cases;
  }
  const std::size_t lost = pieces[1].mesh.region.size();
  pieces[1].mesh.region = {};
  for (const std::vector<std::size_t>& division : {std::vector<std::size_t>{0}, {0, 1, 2}}) {
    const Checked checked = check_on_ranks(domains::regions(), pieces, division, Goal{.max_area = 0.01}, options);
    EXPECT_EQ(testing::verdict(checked.certificate), "not valid: wrong_region " + std::to_string(lost));
    ++facts.cases;
  }
}

PARDEL_FACT(
    Pieces, may_list_a_vertex_in_the_interior_of_another_piece,
    {.statement = "a vertex without triangles of one piece that lies in the interior of another piece is a vertex "
                  "with triangles, as in the joined mesh",
     .source = "properties/checker/check_pieces.hpp",
     .families = "a square in one piece, and a vertex"}) {
  const Goal goal{.max_area = 0.002};
  const Result<Meshed> meshed = mesh(domains::square(), goal);
  ASSERT_TRUE(meshed);
  const Mesh& mesh = meshed->mesh;
  std::vector<NumberedMesh> pieces = testing::cut_mesh(mesh, std::vector<std::size_t>(mesh.triangles.size(), 0), 2);
  const auto from_the_middle = [](Point p) { return std::hypot(p.x - 0.5, p.y - 0.5); };
  const Point* const inner = std::ranges::min_element(mesh.points, {}, from_the_middle);
  testing::PieceOf other(mesh);
  other.vertex(static_cast<Index>(inner - mesh.points.begin()));
  pieces[1] = other.take();
  const CheckOptions options{.foreign = true};
  const Certificate whole = check(domains::square(), *join_pieces(pieces), goal, options);
  EXPECT_TRUE(whole.valid);
  for (const std::vector<std::size_t>& division : {std::vector<std::size_t>{0}, {0, 1}, {0, 1, 2}}) {
    const Checked checked = check_on_ranks(domains::square(), pieces, division, goal, options);
    EXPECT_EQ(checked.fault, "");
    EXPECT_EQ(to_json(checked.certificate), to_json(whole));
    ++facts.cases;
  }
}

/// Checks the mesh in eight blocks of triangles on one rank, and returns the readings.
std::size_t readings_of_eight_pieces(const Pslg& pslg, const Mesh& whole, const Goal& goal) {
  std::vector<std::size_t> owner;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) owner.push_back(8 * t / whole.triangles.size());
  const Checked checked = check_on_ranks(pslg, testing::cut_mesh(whole, owner, 8), {0}, goal, {});
  EXPECT_EQ(checked.fault, "");
  EXPECT_TRUE(checked.certificate.valid);
  return checked.readings;
}

PARDEL_FACT(Pieces, are_read_again_only_if_they_depend_on_others,
            {.statement = "a piece of a right mesh is read once; twice if it has triangles that a small input angle "
                          "justifies; three times if the input has regions",
             .source = "properties/checker/check_pieces.hpp",
             .families = "a square; a wedge; squares that are regions; each in eight pieces on one rank"}) {
  const Goal goal{.max_area = 0.005};
  const auto readings = [&](const Pslg& pslg) {
    const Result<Meshed> meshed = mesh(pslg, goal);
    return meshed ? readings_of_eight_pieces(pslg, meshed->mesh, goal) : 0;
  };
  EXPECT_EQ(readings(domains::square()), 8U);
  EXPECT_EQ(readings(domains::regions()), 24U);
  const std::size_t of_a_wedge = readings(domains::wedge(4, 8));
  EXPECT_GT(of_a_wedge, 8U);
  EXPECT_LE(of_a_wedge, 16U);
  facts.cases += 3;
}

}  // namespace
}  // namespace pardel
