// Delaunay decoupling: parts with separators that no part has to split.
#include "../../../ref/schemes/decoupling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "../../../core/support/smallest_angle.hpp"
#include "../../../ref/schemes/mesh/predicates.hpp"
#include "../../domains/domains.hpp"
#include "same_triangles.hpp"
#include "some_problem.hpp"

namespace pardel::properties {
namespace {

using schemes::DecouplingOptions;
using schemes::Encroaching;
using schemes::LinkedMesh;
using schemes::Outcome;
using schemes::Separators;

/// What a run showed.
struct Shown {
  LinkedMesh laid;
  std::vector<int> part;
  Index first = 0;
  std::size_t pieces = 0, gaps = 0;
  schemes::DecouplingEnd end;
};

Outcome decoupled(const SchemeCase& c, Shown& shown, DecouplingOptions options = {}) {
  options.on_laid = [&](const schemes::DecouplingRecord& r) {
    shown = {r.laid, r.part, r.first_separator, r.pieces, r.gaps, {}};
  };
  options.on_end = [&](const schemes::DecouplingEnd& end) { shown.end = end; };
  return required(schemes::decoupling(c.problem(), options));
}

DecouplingOptions some_decoupling() {
  DecouplingOptions options;
  options.separators = *rc::gen::element(Separators::lattice, Separators::bisection);
  options.encroaching = *rc::gen::element(Encroaching::handed_back, Encroaching::inserted);
  options.piece = *rc::gen::element(0.5, 1.0, 2.5);
  return options;
}

/// A rectangle with an area bound for which each part is several pieces wide, on 2 to 9 workers.
SchemeCase some_rectangle(Exhibit& exhibit) {
  const int width = *rc::gen::inRange(8, 24), height = *rc::gen::inRange(8, 24);
  SchemeCase c;
  const auto w = static_cast<double>(width), h = static_cast<double>(height);
  c.pslg.points = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 0, 0}};
  c.workers = *rc::gen::inRange(2, 10);
  c.goal.max_area = std::min(w, h) * std::min(w, h) / *rc::gen::inRange(150, 700);
  exhibit.show(c.pslg);
  return c;
}

double length(const LinkedMesh& mesh, const std::array<Index, 2>& e) {
  return std::hypot(mesh.points[e[0]].x - mesh.points[e[1]].x, mesh.points[e[0]].y - mesh.points[e[1]].y);
}

/// In degrees.
double least_angle_of(const LinkedMesh& mesh) {
  double least = 180;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t))
      least = std::min(least, smallest_angle({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}));
  return least;
}

PARDEL_PROPERTY(Decoupling, ends_with_a_certified_mesh,
                {.statement = "Decoupling ends with a mesh that the checker certifies, also where separators have gaps "
                              "or pieces that are too long.",
                 .source = "Linardakis, Chrisochoides 2006",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Shown shown;
  const Outcome o = decoupled(c, shown, some_decoupling());
  classify(shown.pieces > 0, "separators are laid", 20);
  classify(shown.gaps > 0, "a separator has a gap", 15);
  certify(o.mesh, c, exhibit);
}

PARDEL_PROPERTY(Decoupling, has_parts_that_split_no_separator,
                {.statement = "If pieces are shorter than twice the least distance of vertices and than sqrt 2 times "
                              "the least circumradius of a triangle that is too large, no part splits a separator, no "
                              "insertion is given up, and nothing is left to do after gluing.",
                 .source = "Linardakis, Chrisochoides 2006; ref/schemes/decoupling.hpp",
                 .families = "rectangles whose parts are several pieces wide, 2 to 9 workers"}) {
  const SchemeCase c = some_rectangle(exhibit);
  Shown shown;
  const Outcome o = decoupled(c, shown);
  double least = INFINITY, longest = 0;
  for (Index s = shown.first; s < shown.laid.segments.size(); ++s)
    longest = std::max(longest, length(shown.laid, shown.laid.segments[s]));
  for (Index t = 0; t < shown.laid.faces.size(); ++t)
    for (int i = 0; shown.laid.in_use(t) && i < 3; ++i)
      least = std::min(least, length(shown.laid, schemes::ends(shown.laid, {t, i})));
  const bool holds = shown.gaps == 0 && shown.pieces > 0 && longest < 2 * least &&
                     longest < std::numbers::sqrt2 * std::sqrt(4 * c.goal.max_area / (3 * std::numbers::sqrt3));
  classify(holds, "the condition holds", 60);
  if (!holds) return;
  RC_ASSERT(shown.end.separator_splits == 0U);
  RC_ASSERT(o.account.set_backs == 0U);
  RC_ASSERT(o.account.wasted == 0U);
  RC_ASSERT(shown.end.late == 0U);
  RC_ASSERT(o.account.sequential == o.account.before);
}

PARDEL_PROPERTY(Decoupling, needs_no_flip_after_gluing,
                {.statement = "If no part inserts a point that encroaches upon a separator, the glued mesh is "
                              "constrained Delaunay without a flip.",
                 .source = "Linardakis, Chrisochoides 2006",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  DecouplingOptions options = some_decoupling();
  options.encroaching = Encroaching::handed_back;
  Shown shown;
  static_cast<void>(decoupled(c, shown, options));
  classify(shown.end.separator_splits > 0, "a circumcentre encroaches upon a separator", 1);
  classify(shown.pieces > 0, "separators are laid", 20);
  RC_ASSERT(shown.end.flips == 0U);
}

PARDEL_PROPERTY(
    Decoupling, sends_no_message_after_the_start,
    {.statement =
         "Each worker but the first gets one message, with its parts, at most; there is one phase "
         "and one barrier. It holds these parts at the end. One worker has no separator and nothing to give up.",
     .source = "Linardakis, Chrisochoides 2006",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Shown shown;
  const Outcome o = decoupled(c, shown, some_decoupling());
  const auto workers = static_cast<std::uint64_t>(c.workers);
  std::vector<std::uint64_t> held(workers, 0);
  for (const int part : shown.part)
    if (part >= 0) ++held[static_cast<std::size_t>(part) % workers];
  const std::uint64_t of_others = std::accumulate(held.begin() + 1, held.end(), std::uint64_t{0});
  RC_ASSERT(o.account.bytes == of_others * schemes::bytes_of_triangle);
  RC_ASSERT(o.account.most_held >= *std::ranges::max_element(held));
  RC_ASSERT(o.account.messages <= static_cast<std::uint64_t>(c.workers - 1));
  RC_ASSERT(o.account.rounds == 1U);
  RC_ASSERT(o.account.barriers == 1U);
  RC_ASSERT(o.account.insertions == o.mesh.points.size() - c.pslg.points.size());
  RC_ASSERT((o.account.wasted > 0) == (o.account.set_backs > 0));
  if (c.workers == 1) RC_ASSERT(shown.pieces + shown.gaps + o.account.set_backs == 0U);
  classify(o.account.messages > 0, "a message is sent", 60);
}

PARDEL_PROPERTY(
    Decoupling, has_parts_that_do_not_know_of_each_other,
    {.statement = "The work of the parts and what they give up do not depend on the order in which they are "
                  "refined, also if separators have gaps. If nothing is given up, neither does the mesh.",
     .source = "Linardakis, Chrisochoides 2006",
     .families = scheme_families}) {
  SchemeCase c = some_scheme_case(exhibit);
  DecouplingOptions options = some_decoupling();
  // What is left is refined at the end, in the order in which parts have given it up.
  Shown first, second;
  const Outcome one = decoupled(c, first, options);
  c.seed += 1;
  const Outcome two = decoupled(c, second, options);
  RC_ASSERT(one.account.set_backs == two.account.set_backs);
  RC_ASSERT(one.account.wasted == two.account.wasted);
  RC_ASSERT(one.account.work == two.account.work);
  const bool is_decoupled = one.account.set_backs == 0 && first.end.flips == 0;
  if (is_decoupled && first.end.late == 0) RC_ASSERT(placed_triangles(one.mesh) == placed_triangles(two.mesh));
  classify(c.workers > 1 && one.account.set_backs > 0, "a part gives up", 10);
}

PARDEL_PROPERTY(
    Decoupling, keeps_separators_between_parts,
    {.statement = "In the mesh before the parts are refined, no corner encroaches upon a separator beside it, and "
                  "if there is no gap, every side between two parts is constrained. No separator is left "
                  "at the end.",
     .source = "Linardakis, Chrisochoides 2006",
     .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Shown shown;
  const Outcome o = decoupled(c, shown, some_decoupling());
  const LinkedMesh& mesh = shown.laid;
  std::size_t open = 0, separators = 0;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    for (int i = 0; mesh.in_use(t) && i < 3; ++i) {
      const schemes::Side side{t, i};
      const Index n = mesh.faces[t].n[i];
      if (n != no_index && shown.part[n] != shown.part[t] && !schemes::is_constrained(mesh, side)) ++open;
      if (!schemes::is_constrained(mesh, side) || mesh.faces[t].segment[i] < shown.first) continue;
      ++separators;
      const auto [a, b] = schemes::ends(mesh, side);
      RC_ASSERT(!schemes::encroaches(mesh.corner(t, i), mesh.points[a], mesh.points[b]));
    }
  RC_ASSERT(separators == 2 * shown.pieces);
  if (shown.gaps == 0) RC_ASSERT(open == 0U);
  RC_ASSERT(o.mesh.segments.size() == shown.first);
  for (const schemes::Face& face : o.mesh.faces)
    for (const Index s : face.segment) RC_ASSERT(s == schemes::no_segment || s < shown.first);
  classify(shown.pieces > 0, "separators are laid", 20);
}

PARDEL_PROPERTY(Decoupling, leaves_to_one_worker_what_comes_before_and_after,
                {.statement = "One worker lays separators before the parts are refined, and inserts the late points "
                              "after that. Both are on the critical path, together with the longest work of a worker. "
                              "Each split of a separator that a part would need is a set-back.",
                 .source = "ref/schemes/decoupling.hpp",
                 .families = scheme_families}) {
  const SchemeCase c = some_scheme_case(exhibit);
  Shown shown;
  const schemes::Account a = decoupled(c, shown, some_decoupling()).account;
  const schemes::Start start = some_start(c);
  const std::size_t laid = shown.laid.points.size() - start.mesh.points.size();
  classify(laid > 0, "a separator has a new vertex", 20);
  classify(shown.end.late > 0, "a point is inserted late", 10);
  RC_ASSERT(a.before >= start.account.sequential + laid);
  RC_ASSERT(a.sequential >= a.before + shown.end.late + shown.end.flips);
  RC_ASSERT(a.critical <= a.sequential + a.work);
  RC_ASSERT(a.critical >= a.sequential + a.work / static_cast<std::uint64_t>(c.workers));
  RC_ASSERT(a.set_backs >= shown.end.separator_splits);
}

PARDEL_FACT(Decoupling, splits_a_separator_whose_pieces_are_too_long,
            {.statement = "With pieces 2.5 times as long, parts have to split separators; if they insert the "
                          "circumcentres that encroach upon them instead, separators have to be flipped.",
             .source = "ref/schemes/decoupling.hpp",
             .families = "the unit square, areas up to 1e-3, 4 workers"}) {
  SchemeCase c{domains::square(), {}, 4};
  c.goal.max_area = 1e-3;
  Shown safe, split, flipped;
  static_cast<void>(decoupled(c, safe));
  EXPECT_EQ(safe.end.separator_splits, 0U);
  EXPECT_EQ(safe.end.late, 0U);
  DecouplingOptions options;
  options.piece = 2.5;
  static_cast<void>(decoupled(c, split, options));
  EXPECT_GT(split.end.separator_splits, 0U);
  EXPECT_GT(split.end.late, 0U);
  EXPECT_EQ(split.end.flips, 0U);
  options.encroaching = Encroaching::inserted;
  static_cast<void>(decoupled(c, flipped, options));
  EXPECT_GT(flipped.end.flips, 0U);
  facts.cases = 3;
  facts.notes.push_back(std::to_string(split.end.separator_splits) + " splits of separators, or " +
                        std::to_string(flipped.end.flips) + " flips.");
}

PARDEL_FACT(
    Decoupling, has_a_gap_where_a_separator_would_meet_the_outline_at_a_small_angle,
    {.statement = "A line that crosses a side at less than 60 degrees makes no vertex there: the separator has a "
                  "gap, and triangles beside it wait until the parts are put together. At 60 degrees or more "
                  "there is a vertex.",
     .source = "Linardakis, Chrisochoides 2006, angles of separators",
     .families = "two slanted domains, 2 workers"}) {
  for (const bool is_steep : {false, true}) {
    SchemeCase c;
    // Two workers have parts above each other: the line y = 1/2 crosses the slanted sides, at no binary fraction.
    const double slant = is_steep ? 0.35 : 1.4;
    c.pslg.points = {{0, 0}, {2, 0}, {2 + slant, 0.7}, {2 + slant, 1}, {slant, 1}, {slant, 0.7}};
    c.pslg.segments = {{0, 1, 0}, {1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}, {5, 0, 0}};
    c.workers = 2;
    c.goal.max_area = 1e-3;
    Shown shown;
    const Outcome o = decoupled(c, shown);
    ++facts.cases;
    int crossings = 0;
    for (std::size_t v = 0; v < shown.laid.points.size(); ++v)
      crossings += shown.laid.points[v].y == 0.5 && shown.laid.segment_of[v] != schemes::no_segment ? 1 : 0;
    EXPECT_EQ(crossings, is_steep ? 2 : 0);
    EXPECT_TRUE(is_steep || shown.gaps > 0);
    EXPECT_TRUE(is_steep || o.account.set_backs > 0);
    facts.notes.push_back(std::to_string(shown.gaps) + " gaps, " + std::to_string(shown.end.late) +
                          " insertions after gluing.");
  }
}

PARDEL_FACT(Decoupling, forces_good_angles_and_few_triangles_more,
            {.statement = "Beside separators, the finished mesh has no angle below the goal, and at most 5 % more "
                          "triangles than that of one worker.",
             .source = "Linardakis, Chrisochoides 2006, overhead of decoupling",
             .families = "the unit square, areas up to 1e-4, 1, 4, 16 and 64 workers"}) {
  SchemeCase c{domains::square(), {}, 1};
  c.goal.max_area = 1e-4;
  Shown shown;
  const std::size_t alone = decoupled(c, shown).mesh.faces.size();
  for (const int workers : {4, 16, 64}) {
    c.workers = workers;
    const Outcome o = decoupled(c, shown);
    ++facts.cases;
    EXPECT_GE(least_angle_of(o.mesh), 20.7);
    EXPECT_LE(static_cast<double>(o.mesh.faces.size()), 1.05 * static_cast<double>(alone));
    EXPECT_EQ(shown.gaps, 0U);
    facts.notes.push_back(std::to_string(workers) + " workers: " + std::to_string(shown.pieces) + " pieces, " +
                          std::to_string(o.mesh.faces.size()) + " triangles (" + std::to_string(alone) +
                          " with one worker); smallest angle of the mesh with separators alone " +
                          std::to_string(least_angle_of(shown.laid)) + " degrees.");
  }
}

/// A rectangle whose upright sides have a vertex just above their middles, where the line between two parts runs.
TEST(Decoupling, a_line_that_passes_close_to_a_vertex_has_a_gap) {
  Pslg pslg;
  const double middle = 0.5 + 0x1p-45;
  pslg.points = {{0, 0}, {2, 0}, {2, middle}, {2, 1}, {0, 1}, {0, middle}};
  for (Index v = 0; v < 6; ++v) pslg.segments.push_back({v, (v + 1) % 6, 0});
  std::size_t gaps = 0;
  DecouplingOptions options;
  options.on_laid = [&](const schemes::DecouplingRecord& r) { gaps = r.gaps; };
  const Goal goal;
  const auto outcome = schemes::decoupling({pslg, goal, 2, 1, 10'000}, options);
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_GT(gaps, 0U);
  EXPECT_LT(outcome->account.insertions, 20U);
  EXPECT_TRUE(check(pslg, schemes::to_mesh(outcome->mesh, pslg), goal).valid);
}

/// Four points around the middle of a huge square: the triangles there say nothing about the rest of the line, which
/// had a billion pieces.
TEST(Decoupling, a_line_is_not_laid_where_its_middle_is_much_finer_than_the_rest) {
  constexpr double huge = 0x1p30;
  Pslg pslg;
  pslg.points = {{-huge, -huge}, {huge, -huge}, {huge, huge}, {-huge, huge}, {-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (Index v = 0; v < 4; ++v) pslg.segments.push_back({v, (v + 1) % 4, 0});
  const Goal goal;
  for (const Separators separators : {Separators::lattice, Separators::bisection}) {
    const auto outcome = schemes::decoupling({pslg, goal, 2, 1, 10'000}, {.separators = separators});
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_TRUE(check(pslg, schemes::to_mesh(outcome->mesh, pslg), goal).valid);
  }
}

TEST(Decoupling, a_part_without_triangles_gets_no_message) {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {0, 3}};
  const Goal goal;
  const auto outcome = schemes::decoupling({pslg, goal, 64});
  ASSERT_TRUE(outcome) << outcome.error().message;
  EXPECT_LT(outcome->account.messages, 63U);
  EXPECT_GE(outcome->account.bytes, schemes::bytes_of_triangle * outcome->account.messages);
}

}  // namespace
}  // namespace pardel::properties
