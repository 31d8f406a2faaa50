// Tools that are separate programs: Gmsh and Triangle. The times are those that the programs print; they do not include
// start-up or file access. Separate processes write, read and check the files.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "../core/formats.hpp"
#include "../core/support/programs.hpp"
#include "run_in_child.hpp"
#include "tool.hpp"

namespace pardel::bench {
namespace {

namespace fs = std::filesystem;

fs::path triangle_program() {
  const char* given = std::getenv("PARDEL_TRIANGLE");
  return given != nullptr && *given != '\0' ? fs::path(given) : on_path("triangle");
}

/// The sum of the first groups of all matches, because a program may print one time per phase.
double sum_of_matches(const std::string& text, const std::regex& pattern) {
  double sum = 0;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    sum += std::stod((*match)[1].str());
  return sum;
}

/// Reads and checks the mesh of the program in a child process.
Run read_and_judge(const Task& task, const fs::path& file, Run run) {
  const double seconds = run.seconds;
  const std::uint64_t peak = run.peak_rss_bytes;
  run = run_in_child<Run>([&] {
          Run judged;
          const Result<Mesh> mesh = read_mesh(file);
          if (!mesh) {
            judged.set_verdict(mesh.error().message);
            return judged;
          }
          judge(task, *mesh, true, judged);
          return judged;
        }).value_or(Run{});
  run.seconds = seconds;
  run.peak_rss_bytes = peak;
  return run;
}

Run failed(const ProgramRun& program) {
  Run run;
  run.set_verdict(fmt::format("exit code {}", program.exit_code));
  return run;
}

/// Writes the points that are no corners of the square, which lie inside it, and the wanted edge lengths. Gmsh takes
/// these as a mean, not as a bound. With the factor, it makes about as many triangles as the other tools.
void write_field(const Pslg& pslg, const Grading& size, std::ostream& out) {
  constexpr double factor = 0.757;
  for (std::size_t i = pslg.segments.size(); i < pslg.points.size(); ++i)
    out << fmt::format("Point{{{}}} In Surface{{1}};\n", i + 1);
  out << fmt::format("Field[1] = MathEval;\nField[1].F = \"{} * sqrt(x * x + y * y)\";\n", factor * size.ratio);
  out << fmt::format("Field[2] = MathEval;\nField[2].F = \"{}\";\n", factor * size.ratio * size.inner);
  out << "Field[3] = Max;\nField[3].FieldsList = {1, 2};\nBackground Field = 3;\n";
  for (const char* other : {"ExtendFromBoundary", "FromPoints", "FromCurvature"})
    out << fmt::format("Mesh.MeshSize{} = 0;\n", other);
}

/// Writes the Pslg as a Gmsh geometry: closed chains of lines become loops of one plane surface.
bool write_geo(const Task& task, const fs::path& file, double edge) {
  const Pslg pslg = make_domain(task);
  std::ofstream out(file);
  for (std::size_t i = 0; i < pslg.points.size(); ++i)
    out << fmt::format("Point({}) = {{{}, {}, 0}};\n", i + 1, pslg.points[i].x, pslg.points[i].y);
  std::string loop, loops;
  std::size_t count = 0;
  for (std::size_t i = 0; i < pslg.segments.size(); ++i) {
    const Segment s = pslg.segments[i];
    out << fmt::format("Line({}) = {{{}, {}}};\n", i + 1, s.a + 1, s.b + 1);
    loop += (loop.empty() ? "" : ", ") + std::to_string(i + 1);
    const bool ends = i + 1 == pslg.segments.size() || pslg.segments[i + 1].a != s.b;
    if (!ends) continue;
    out << fmt::format("Curve Loop({}) = {{{}}};\n", ++count, loop);
    loops += (loops.empty() ? "" : ", ") + std::to_string(count);
    loop.clear();
  }
  out << fmt::format("Plane Surface(1) = {{{}}};\n", loops);
  if (is_graded(task))
    write_field(pslg, grading(task), out);
  else
    out << fmt::format("Mesh.MeshSizeMin = {0};\nMesh.MeshSizeMax = {0};\n", edge);
  return static_cast<bool>(out.flush());
}

Run run_gmsh(const Task& task, const fs::path& scratch) {
  const fs::path geo = scratch / "domain.geo", msh = scratch / "gmsh.msh";
  // Gmsh has bounds on edges, not on areas and angles. The bound is the edge of an equilateral triangle with the wanted
  // mean area, plus a correction: on a square, Gmsh's triangles are 15 % smaller.
  const double mean_area = domain_area(task) / static_cast<double>(task.triangles);
  const double edge = std::sqrt(1.15 * mean_area * 4 / std::sqrt(3.0));
  if (!run_in_child<int>([&] { return write_geo(task, geo, edge) ? 1 : 0; }).value_or(0)) return {};
  const ProgramRun program =
      run_program({"gmsh", "-2", "-algo", "del2d", "-format", "msh41", "-bin", "-o", msh, "-nt", "1", geo});
  if (program.exit_code != 0) return failed(program);
  Run run;
  run.seconds = sum_of_matches(program.output, std::regex(R"(Done meshing [12]D \(Wall ([0-9.eE+-]+)s)"));
  run.peak_rss_bytes = program.peak_rss_bytes;
  return read_and_judge(task, msh, run);
}

Run run_triangle(const Task& task, const fs::path& scratch) {
  const fs::path poly = scratch / "domain.poly";
  if (!run_in_child<int>([&] { return write_poly(make_domain(task), poly) ? 1 : 0; }).value_or(0)) return {};
  // A domain without segments is the convex hull of its points. Triangle needs the switch c for it, or it removes all
  // triangles.
  std::string switches = is_point_set(task) ? "-pc" : "-p";
  if (!task.delaunay_only) {
    switches += fmt::format("q{}", task.goal.min_angle_deg);
    if (std::isfinite(task.goal.max_area)) switches += fmt::format("a{:.17f}", task.goal.max_area);
  }
  const ProgramRun program = run_program({triangle_program(), switches, poly});
  if (program.exit_code != 0) return failed(program);
  Run run;
  run.seconds =
      sum_of_matches(program.output, std::regex(R"((?:Delaunay|Segment|Hole|Quality) milliseconds: *([0-9]+))")) / 1000;
  run.peak_rss_bytes = program.peak_rss_bytes;
  return read_and_judge(task, scratch / "domain.1.ele", run);
}

}  // namespace

Tool gmsh_tool() {
  return {"gmsh",
          [](const Task& task) {
            return !task.delaunay_only && task.triangles > 0 && !is_point_set(task) && !on_path("gmsh").empty();
          },
          run_gmsh};
}

Tool triangle_tool() {
  // Triangle takes no sizes that depend on the place.
  return {"triangle", [](const Task& task) { return !is_graded(task) && !triangle_program().empty(); }, run_triangle};
}

}  // namespace pardel::bench
