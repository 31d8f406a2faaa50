#include "run_record.hpp"

#include <chrono>
#include <numeric>
#include <optional>
#include <utility>

#include "../../../core/support/shortest.hpp"
#include "../../../parallel/construction/delaunay.hpp"
#include "../../../parallel/construction/domain_triangulation.hpp"
#include "../../../parallel/conversion/export_mesh.hpp"
#include "../../../parallel/conversion/import_mesh.hpp"
#include "../../../parallel/diagnosis/find_gaps.hpp"
#include "../../../parallel/diagnosis/find_least_size.hpp"
#include "../../../parallel/diagnosis/narrowest_part.hpp"
#include "../../../parallel/domain/convex_hull.hpp"
#include "../../../parallel/domain/find_problems.hpp"
#include "../../../parallel/domain/repair_once.hpp"
#include "../../../parallel/domain/untangle.hpp"
#include "../../../parallel/filling/filling.hpp"
#include "../../../parallel/filling/hemmed_in.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../parallel/quality/criteria.hpp"
#include "../../../parallel/refinement/exemptions.hpp"
#include "../../../parallel/repair.hpp"
#include "../../../parallel/scheduling/refine_by_sweeps.hpp"
#include "../../../parallel/sizing/background.hpp"
#include "../../../parallel/sizing/feature_sources.hpp"
#include "../../../parallel/sizing/graded_size.hpp"
#include "../../../parallel/sizing/steep_edges.hpp"
#include "../../../parallel/warnings.hpp"

namespace pardel::engine {

static void add_to(testing::Fingerprint& to, EdgeRef e) { to.add_all(e.triangle(), e.side(), e.constrained()); }
static void add_to(testing::Fingerprint& to, const Slot& s) { to.add_all(s.v, s.n); }
static void add_to(testing::Fingerprint& to, const Triangulation& t) {
  to.add_all(t.points, t.slots, t.origin, t.region);
}

}  // namespace pardel::engine

namespace pardel::recorded {
namespace {

using testing::Fingerprint;
using testing::fingerprint;

using namespace engine;

std::string text(double value) { return shortest(value); }
std::string text(Point p) { return shortest(p); }
std::string text(const std::string& value) { return value; }
std::string text(const char* value) { return value; }
template <class T>
requires std::is_integral_v<T> std::string text(T value) { return std::to_string(value); }

template <class... Ts>
std::string words(const Ts&... values) {
  std::string all;
  ((all += " " + text(values)), ...);
  return all;
}

/// Counts the questions of the stages of a run on one thread, which are asked as often as possible, and what the
/// refinement says about its progress.
class Record {
 public:
  Record(std::string name, const Options& options) : name_(std::move(name)), options_(options) {
    options_.threads = 1;
    options_.progress = [this](const Progress& progress) {
      ++questions_;
      progress_.add_all(progress.triangles, progress.estimate);
      return true;
    };
  }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] ProgressMonitor& monitor() { return monitor_; }
  [[nodiscard]] Threads threads() { return monitor_.threads(); }

  template <class... Ts>
  void end_of_stage(const char* stage, const Ts&... values) {
    lines_.push_back(name_ + ", " + stage + ": " + std::to_string(std::exchange(questions_, 0)) + " questions," +
                     words(values...));
  }
  template <class... Ts>
  void add(const char* what, const Ts&... values) {
    lines_.push_back(name_ + ", " + what + ":" + words(values...));
  }
  void forget_questions() { questions_ = 0; }
  void add_progress() { add("progress", std::exchange(progress_, Fingerprint()).text()); }
  [[nodiscard]] std::vector<std::string> lines() && { return std::move(lines_); }

 private:
  std::string name_;
  Options options_;
  std::size_t questions_ = 0;
  Fingerprint progress_;
  ProgressMonitor monitor_{options_, std::chrono::seconds(0)};
  std::vector<std::string> lines_;
};

std::string problems_text(const std::vector<Problem>& problems) {
  Fingerprint all;
  for (const Problem& p : problems) all.add_all(p.kind, p.ids, p.where, p.message(), p.message(1));
  return std::to_string(problems.size()) + " problems " + all.text();
}

void record_gaps(Record& record, const DomainTriangulation& domain) {
  const std::vector<Gap> gaps = engine::find_gaps(domain, record.threads());
  Fingerprint all;
  for (const Gap& g : gaps)
    all.add_all(g.kind, g.points, g.segment, g.distance, g.surroundings, g.where, g.message(), g.message(1));
  record.end_of_stage("gaps", gaps.size(), all.text(), closing_snap(gaps));
}

void record_least_size(Record& record, const DomainTriangulation& domain, const Goal& goal, const Options& options) {
  // Tangents of libraries differ in the last digits.
  const LeastSize least = find_least_size(domain, goal.min_angle_deg, options.min_edge, record.threads());
  record.end_of_stage("least size", std::llround(1e6 * least.triangles), least.where, least.width);
  record.add("narrowest part", narrowest_part(domain));
}

/// The values on a grid around the domain, at its points, and in the middle of its segments.
std::string at_grid(const std::function<Fingerprint(Point)>& value, const Pslg& pslg) {
  Box box = Box::around(pslg.points[0]);
  for (const Point p : pslg.points) box.cover(Box::around(p));
  const double width = box.max_x - box.min_x, height = box.max_y - box.min_y;
  std::vector<Point> places = pslg.points;
  constexpr int parts = 12;
  for (int i = -3; i <= parts + 3; ++i)
    for (int j = -3; j <= parts + 3; ++j)
      places.push_back({box.min_x + width * i / parts, box.min_y + height * j / parts});
  for (const Segment& s : pslg.segments) {
    const Point a = pslg.points[s.a], b = pslg.points[s.b];
    places.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
  }
  Fingerprint all;
  for (const Point p : places) all.add(value(p).text());
  return all.text();
}

void record_tiling(Record& record, const Tiling& tiling) {
  for (const Sweep& s : tiling.sweeps)
    record.add("sweep", s.columns, "x", s.rows, "tiles, inserted", s.inserted, "in a task", s.largest_task, "handed on",
               s.to_other_cells, s.beyond_box, s.out_of_numbers, s.against_promise);
  Fingerprint leaves;
  for (const TileLeaf& leaf : tiling.leaves) leaves.add_all(leaf.level, leaf.column, leaf.row, leaf.colour);
  record.add("tiles", tiling.columns, "x", tiling.rows, "of", tiling.cell_width, tiling.cell_height, leaves.text(),
             "over", tiling.low, tiling.high, fingerprint(tiling.thread_of_cell), "after", tiling.vertices_before);
  record.add("radii", tiling.largest_radius, tiling.radius_by_t3, tiling.radius_by_t3_sharp);
}

/// The tasks in the order in which they start.
class Tasks {
 public:
  [[nodiscard]] Schedule schedule() {
    return {.order = [this](std::vector<std::size_t>& order) { tasks_.add(order); },
            .before_task =
                [this](std::size_t task) {
                  ++count_;
                  tasks_.add(task);
                },
            .after_phase = [this] { ++phases_; }};
  }
  void end(Record& record) const { record.add("tasks", count_, "in", phases_, "phases", tasks_.text()); }

 private:
  std::size_t count_ = 0, phases_ = 0;
  Fingerprint tasks_;
};

void record_refinement(Record& record, DomainTriangulation& domain, const Criteria& criteria) {
  const Options options = record.options();
  Tasks tasks;
  Fingerprint snapshots;
  const Watcher watcher = [&](Triangulation&& copy, const Sweep& sweep) -> Status {
    snapshots.add_all(copy, sweep.inserted);
    return Done{};
  };
  const Result<RefineCounts> counts = refine_by_sweeps(domain.triangulation, domain.segments, criteria, options,
                                                       record.monitor(), tasks.schedule(), watcher);
  record.add_progress();
  record.add("snapshots", snapshots.text());
  tasks.end(record);
  if (!counts) return record.end_of_stage("refinement", counts.error().message);
  record.end_of_stage("refinement", counts->inserted, counts->segment_splits, counts->refused, counts->budget_reached,
                      counts->left_alone, fingerprint(domain.triangulation));
  record_tiling(record, counts->tiling);

  Fingerprint all;
  std::array<std::size_t, exempt_reasons> of_reason{};
  // Arc cosines of libraries differ in the last digits.
  for (const Exemption& e :
       exemptions(domain.triangulation, domain.segments, criteria, options, counts->budget_reached, record.threads())) {
    all.add_all(e.triangle, e.reason, e.apex, std::llround(e.angle_deg * 1e6));
    ++of_reason[static_cast<std::size_t>(e.reason)];
  }
  record.end_of_stage("exemptions", of_reason[0], of_reason[1], of_reason[2], of_reason[3], of_reason[4], of_reason[5],
                      all.text());
}

std::vector<int> markers_of(const DomainSegments& segments) {
  std::vector<int> markers;
  for (Index s = 0; s < segments.size(); ++s) markers.push_back(segments[s].marker);
  return markers;
}

/// The mesh as the start of another run, in which the triangles have caps.
void record_refinement_of_mesh(Record& record, const Mesh& mesh) {
  const Result<DomainTriangulation> again = import_mesh(mesh, record.threads());
  if (!again) return record.end_of_stage("import", again.error().message);
  record.end_of_stage("import", fingerprint(again->triangulation, again->input_of_vertex, again->input_segment,
                                            markers_of(again->segments)));
  std::vector<double> caps;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& v = mesh.triangles[i].v;
    const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
    const double twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    caps.push_back(i % 5 == 0 ? twice_area / 8 : i % 5 == 1 ? twice_area : std::numeric_limits<double>::infinity());
  }
  const Options options{.threads = 1, .triangles_per_tile = 50, .max_vertices = mesh.points.size() + 3000};
  const Result<Meshed> finer = refine(mesh, caps, {.min_angle_deg = 15}, options);
  if (!finer) return record.add("refined mesh", finer.error().message);
  record.add("refined mesh", finer->report.inserted, finer->report.segment_splits, finer->report.refused,
             finer->report.exempt.size(), fingerprint(finer->mesh));
}

/// Fields on the triangles of the domain.
void record_background(Record& record, const Pslg& pslg, const std::vector<std::array<Index, 3>>& triangles) {
  const Background background(pslg.points, triangles, record.threads());
  std::vector<double> values;
  for (std::size_t i = 0; i < pslg.points.size(); ++i) values.push_back(1 + static_cast<double>(i % 5));
  const Steepness steepness = background.steepness(values);
  const auto located = [&](Point p) {
    const Located at = background.locate(p);
    return Fingerprint(at.triangle, at.v, at.weight, background.is_near(at, p), background.value_at(at, values));
  };
  record.end_of_stage("background", at_grid(located, pslg), steepness.slope, steepness.blur,
                      fingerprint(steep_edges(pslg.points, triangles, values, 0.5)));
}

void record_features(Record& record, const Pslg& pslg) {
  const Polylines lines = find_polylines(pslg, record.threads());
  Fingerprint all;
  for (const Polyline& line : lines.all) all.add_all(line.vertices, line.closed);
  for (std::size_t v = 0; v < pslg.points.size(); ++v) all.add(static_cast<bool>(lines.is_corner[v]));
  record.end_of_stage("polylines", lines.all.size(), all.text());
  all = Fingerprint();
  for (const GrowingSize& g : feature_sources(pslg, lines, 2, 0.5, record.threads())) all.add_all(g.source, g.slope);
  for (const GrowingSize& g : segment_sources(pslg, lines, 0.25)) all.add_all(g.source, g.slope);
  record.end_of_stage("features", all.text());
}

std::string domain_text(const DomainTriangulation& domain) {
  Fingerprint all;
  all.add_all(domain.triangulation, domain.input_of_vertex, domain.input_segment, markers_of(domain.segments));
  for (Index s = 0; s < domain.segments.size(); ++s) {
    const DomainSegment& segment = domain.segments[s];
    all.add_all(segment.a, segment.b, segment.cosine_at_a, segment.cosine_at_b, segment.narrow_apex);
  }
  return all.text();
}

/// The edges of patches that keep the goal of a run.
std::vector<double> edges_of_patches(const Run& run) {
  std::vector<double> edges;
  for (const Region& region : run.pslg.regions)
    edges.push_back(edge_of_patch(std::min(region.max_area, run.goal.max_area), run.goal.max_edge));
  edges.push_back(edge_of_patch(run.goal.max_area, run.goal.max_edge));
  return edges;
}

/// Cuts patches out of the domain, and replaces the points to which it refers, if there is a patch.
std::optional<Filling> record_filling(Record& record, const Run& run, DomainTriangulation& domain,
                                      std::vector<Point>& points) {
  const std::vector<double> edges = edges_of_patches(run);
  std::vector<Clearing> clearings;
  if (edges.back() < INFINITY) clearings.push_back({run.pslg.points.front(), 3 * edges.back()});
  Result<std::optional<Filling>> filled =
      Filling::make(run.pslg, run.goal.convex_hull, domain, edges, clearings, record.options(), record.threads());
  if (!filled || !*filled) {
    record.end_of_stage("filling", filled ? "nothing fits" : filled.error().message);
    return {};
  }
  domain = (*filled)->take_domain();
  points = (*filled)->points();
  record.end_of_stage("filling", fingerprint(edges), (*filled)->triangles(), points.size(), domain_text(domain));
  return std::move(*filled);
}

void record_hemmed_in(Record& record, DomainTriangulation& domain, const Criteria& criteria) {
  const std::vector<TriangleId> stuck =
      hemmed_in(domain.triangulation, domain.segments, criteria, record.options(), record.threads());
  record.end_of_stage("hemmed in", stuck.size(), fingerprint(stuck));
}

void record_laying(Record& record, const Filling& filling, Mesh& mesh) {
  const Status laid = filling.lay(mesh, record.threads());
  record.end_of_stage("laying", laid ? fingerprint(mesh) : laid.error().message);
}

/// The run as one function of the interface.
void record_whole(Record& record, const Run& run) {
  Options options = run.options;
  options.threads = 1;
  const Result<Meshed> meshed = mesh(run.pslg, run.goal, options);
  if (!meshed) return record.add("whole", meshed.error().message);
  const Report& report = meshed->report;
  record.add("whole", report.inserted, report.segment_splits, report.refused, report.laid, report.exempt.size(),
             report.gaps.size(), report.tiling.sweeps.size(), fingerprint(meshed->mesh));
}

}  // namespace

std::vector<std::string> record(const Run& run) {
  Record record(run.name, run.options);
  const bool convex_hull = run.goal.convex_hull;
  const auto problems = engine::find_problems(run.pslg, {.convex_hull = convex_hull}, record.threads());
  record.end_of_stage("validation", problems_text(problems));
  for (const Warning& w : find_warnings(*validate(run.pslg, {.convex_hull = convex_hull})))
    record.add("warning", fingerprint(w.segments, w.where, w.points, w.extent_without, w.message(), w.message(1)));

  Result<DomainTriangulation> domain = triangulate_domain(run.pslg, convex_hull, record.threads());
  if (!domain) {
    record.end_of_stage("triangulation", domain.error().message);
    return std::move(record).lines();
  }
  record.end_of_stage("triangulation", domain_text(*domain));
  const auto background = input_corners(*domain, record.threads());
  record.end_of_stage("corners", fingerprint(background));
  record_background(record, run.pslg, background);
  record_gaps(record, *domain);
  record_least_size(record, *domain, run.goal, run.options);

  std::vector<Point> points = run.pslg.points;
  std::optional<Filling> filling;
  if (run.options.interior == Interior::fill) filling = record_filling(record, run, *domain, points);
  Goal goal = run.goal;
  if (is_graded(goal)) {
    record_features(record, run.pslg);
    goal.size = graded_size(goal, run.pslg, record.threads());
    record.end_of_stage("sizes", at_grid([&](Point p) { return Fingerprint(goal.size(p)); }, run.pslg));
  }
  std::vector<double> caps, attributes;
  for (const Region& region : run.pslg.regions) {
    attributes.push_back(region.attribute);
    caps.push_back(region.max_area);
  }
  Criteria criteria(goal, run.options.placement, caps);
  if (filling) criteria = criteria.with_patches(edges_of_patches(run));
  record_refinement(record, *domain, criteria);
  if (filling) record_hemmed_in(record, *domain, criteria);
  const PointData data{points, run.pslg.attributes_per_point, run.pslg.point_attributes, run.pslg.point_markers};
  Mesh mesh = export_triangulation(*domain, attributes, points, record.threads());
  if (filling) record_laying(record, *filling, mesh);
  add_point_data(mesh, *domain, data, background, record.threads());
  record.end_of_stage("mesh", mesh.points.size(), mesh.triangles.size(), fingerprint(mesh));
  record_refinement_of_mesh(record, mesh);
  record_whole(record, run);
  return std::move(record).lines();
}

std::vector<std::string> record(const Mess& mess) {
  Record record(mess.name, {});
  StopSignal& stop = *record.threads().stop;
  record.end_of_stage("validation", problems_text(engine::find_problems(mess.pslg, {}, record.threads())));
  record.end_of_stage("values", problems_text(find_unusable_values(mess.pslg, stop)));
  for (const double snap : {0.0, 0x1p-20, 0.0625}) {
    const std::string with = " with " + shortest(snap);
    Work work{mess.pslg, std::vector<Index>(mess.pslg.points.size()), std::vector<Index>(mess.pslg.segments.size())};
    std::iota(work.point_map.begin(), work.point_map.end(), Index{0});
    std::iota(work.source.begin(), work.source.end(), Index{0});
    const bool ended = untangle(work, snap, stop);
    record.end_of_stage(("untangling" + with).c_str(), ended, fingerprint(work.pslg, work.point_map, work.source));
    for (const bool convex_hull : {false, true}) {
      const auto repaired = repair_once(mess.pslg, snap, convex_hull, stop);
      record.forget_questions();  // the validation in the repair asks after some time
      const std::string stage = "repair" + with + (convex_hull ? " of the hull" : "");
      if (!repaired || !*repaired) {
        record.add(stage.c_str(), repaired ? (*repaired).error().message : "no end");
        continue;
      }
      const Repaired& r = (*repaired)->repaired;
      record.add(stage.c_str(), r.domain.pslg().points.size(), r.domain.pslg().segments.size(),
                 fingerprint(r.domain.pslg(), r.point_map, r.segment_map, r.log), r.moved_points.count,
                 r.moved_points.farthest, r.moved_points.distance, r.bent_segments.count, r.bent_segments.farthest,
                 r.bent_segments.distance);
    }
  }
  const Result<Repaired> by_default = repair(mess.pslg);
  if (!by_default)
    record.add("repair", by_default.error().message);
  else
    record.add("repair", by_default->snap, fingerprint(by_default->domain.pslg(), by_default->log));
  return std::move(record).lines();
}

std::vector<std::string> record(const Cloud& cloud) {
  Record record(cloud.name, {});
  const bool collinear = all_collinear(cloud.points, record.threads());
  record.end_of_stage("line", collinear);
  const std::vector<Index> hull = collinear ? std::vector<Index>{} : convex_hull(cloud.points, record.threads());
  record.end_of_stage("hull", hull.size(), fingerprint(hull));
  for (const std::size_t per_tile : {4U, 30U, 300U}) {
    const Result<Delaunay> made = delaunay(cloud.points, record.threads(), per_tile);
    const std::string stage = "triangulation with tiles of " + std::to_string(per_tile);
    if (!made)
      record.end_of_stage(stage.c_str(), made.error().message);
    else
      record.end_of_stage(stage.c_str(), fingerprint(made->triangulation, made->input_of_vertex));
  }
  return std::move(record).lines();
}

}  // namespace pardel::recorded
