// Programs as meshers. Shell scripts play the programs; in whole runs it is `pardel triangle`.
#include "../../off_the_shelf/program_mesher.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "../../core/digest.hpp"
#include "../../off_the_shelf/mesh_with_mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "../is_gone.hpp"
#include "../temporary_folder.hpp"
#include "../with_variable.hpp"

namespace pardel {
namespace {

using Ending = RefinedSubdomain::Ending;
using namespace std::chrono_literals;

/// Two triangles. One edge inside is a segment.
Subdomain two_triangles() {
  Subdomain subdomain;
  subdomain.points = {{0.1, 0}, {3, 1e-300}, {1. / 3, 2}, {-1e17, 1}};
  subdomain.triangles = {{0, 1, 2}, {2, 3, 0}};
  subdomain.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {2, 0, true}};
  subdomain.goal = {.min_angle_deg = 20.5, .max_area = 2e-5};
  subdomain.most_new_points = 1'000'000;
  subdomain.seconds = 60;
  return subdomain;
}

/// A triangle with a triangular hole.
Subdomain ring() {
  Subdomain subdomain;
  subdomain.points = {{0, 0}, {9, 0}, {0, 9}, {2, 2}, {4, 2}, {2, 4}};
  subdomain.triangles = {{0, 1, 3}, {3, 1, 4}, {1, 2, 4}, {4, 2, 5}, {2, 0, 5}, {5, 0, 3}};
  subdomain.edges = {{0, 1}, {1, 2}, {2, 0}, {4, 3}, {5, 4}, {3, 5}};
  subdomain.seconds = 60;
  return subdomain;
}

/// Every test has a folder for temporary files, with blanks in its name, in which nothing may be left.
class ProgramMesher : public ::testing::Test {
 protected:
  ProgramMesher() { std::filesystem::create_directory(folder_ / "of all tasks"); }
  void TearDown() override { EXPECT_TRUE(std::filesystem::is_empty(folder_ / "of all tasks")); }

  /// A program that is a shell script: $1 is {mesh}, the rest is `arguments`.
  [[nodiscard]] MesherProgram script(const std::string& text, const std::string& arguments = "") const {
    folder_.write("its mesher.sh", text);
    return {.command = "sh '" + (folder_ / "its mesher.sh").string() + "' {mesh} " + arguments};
  }
  [[nodiscard]] RefinedSubdomain refine(const MesherProgram& program,
                                        const Subdomain& subdomain = two_triangles()) const {
    const auto mesher = program_mesher(program);
    if (mesher) return mesher.value()->refine(subdomain);
    ADD_FAILURE() << mesher.error().message;
    return {};
  }
  void ends(const MesherProgram& program, Ending ending, const std::string& why) const {
    const RefinedSubdomain answer = refine(program);
    EXPECT_EQ(static_cast<int>(answer.ending), static_cast<int>(ending));
    EXPECT_EQ(answer.why, why);
    EXPECT_TRUE(answer.triangles.empty());
  }

  const TemporaryFolder folder_;
  const WithVariable temporary_{"TMPDIR", folder_ / "of all tasks"};
};

constexpr const char* copies = "cp \"$1.node\" \"$1.1.node\"; cp \"$1.ele\" \"$1.1.ele\"\n";

/// Inserts the point (1, 0.5) into the first triangle, which has the corners 1, 2 and 3.
constexpr const char* splits = R"(
awk 'NR == 1 { $1 += 1 } { print } END { print "5 1 0.5" }' "$1.node" > "$1.1.node"
awk 'NR == 1 { $1 += 2 } NR == 2 { $0 = "1 1 2 5" } { print } END { print "3 2 3 5"; print "4 3 1 5" }' \
  "$1.ele" > "$1.1.ele"
)";

TEST_F(ProgramMesher, that_copies_its_files_returns_the_subdomain) {
  const Subdomain subdomain = two_triangles();
  const RefinedSubdomain answer = refine(script(copies), subdomain);
  EXPECT_EQ(answer.ending, Ending::finished) << answer.why;
  EXPECT_EQ(answer.points, subdomain.points);
  EXPECT_EQ(answer.triangles, subdomain.triangles);
  EXPECT_TRUE(answer.edge_of_new_point.empty());
}

TEST_F(ProgramMesher, may_add_points_inside_faces) {
  const RefinedSubdomain answer = refine(script(splits));
  EXPECT_EQ(answer.ending, Ending::finished) << answer.why;
  ASSERT_EQ(answer.points.size(), 5U);
  EXPECT_EQ(answer.points[4], (Point{1, 0.5}));
  EXPECT_EQ(answer.edge_of_new_point, std::vector<Index>{no_index});
  EXPECT_EQ(answer.triangles, (std::vector<std::array<Index, 3>>{{0, 1, 4}, {2, 3, 0}, {1, 2, 4}, {2, 0, 4}}));
}

TEST_F(ProgramMesher, that_adds_all_points_allowed_has_come_to_the_limit) {
  Subdomain subdomain = two_triangles();
  subdomain.most_new_points = 1;
  EXPECT_EQ(refine(script(splits), subdomain).ending, Ending::limit);
}

TEST_F(ProgramMesher, gets_segments_and_caps_in_files) {
  const std::string here = folder_.path().string();
  Subdomain subdomain = two_triangles();
  subdomain.goal.max_area = INFINITY;
  subdomain.max_areas = {0.5, INFINITY};
  static_cast<void>(
      refine(script(copies + ("cp \"$1.poly\" '" + here + "/poly'; cp \"$1.area\" '" + here + "/area'")), subdomain));
  EXPECT_EQ(folder_.read("poly"), "0 2 0 0\n5 1\n1 1 2 1\n2 2 3 1\n3 3 4 1\n4 4 1 1\n5 3 1 0\n0\n");
  EXPECT_EQ(folder_.read("area"), "2\n1 0.49999999999954525\n2 -1\n");
}

TEST_F(ProgramMesher, gets_numbers_without_exponents) {
  const auto numbers = [&](const Subdomain& subdomain) {
    const std::string says = "shift; printf '%s ' \"$@\" > '" + (folder_ / "said").string() + "'\n";
    static_cast<void>(refine(script(copies + says, "q{min-angle}a{max-area} {max-points}"), subdomain));
    return folder_.read("said");
  };
  Subdomain subdomain = two_triangles();
  EXPECT_EQ(numbers(subdomain), "q20.5a0.00001999999999998181 1000000 ");
  subdomain.goal = {.min_angle_deg = 0};
  EXPECT_EQ(numbers(subdomain), "q0a200000000000000000 1000000 ") << "the area of the box";
}

TEST_F(ProgramMesher, gets_the_paths_of_its_files) {
  const std::string says = "echo \"$1|$2|$3\" > '" + (folder_ / "said").string() + "'";
  static_cast<void>(refine(script(says, "{poly} {out}"), ring()));
  std::string said = folder_.read("said");
  const std::string task = said.substr(0, said.find("/part|"));
  EXPECT_TRUE(task.starts_with((folder_ / "of all tasks/pardel-task-").string()));
  EXPECT_EQ(said, task + "/part|" + task + "/part.poly|" + task + "/part.1.ele\n");
}

TEST_F(ProgramMesher, gets_the_points_of_holes_if_it_reads_only_the_poly) {
  const std::string copies_poly = "cp \"$1.poly\" '" + (folder_ / "poly").string() + "'\n";
  static_cast<void>(refine(script(copies_poly, "{poly}"), ring()));
  EXPECT_TRUE(folder_.read("poly").ends_with("\n1\n1 2.6666666666666665 2.6666666666666665\n")) << folder_.read("poly");
}

TEST_F(ProgramMesher, has_one_thread) {
  static_cast<void>(refine(script("echo $OMP_NUM_THREADS > '" + (folder_ / "said").string() + "'")));
  EXPECT_EQ(folder_.read("said"), "1\n");
}

TEST_F(ProgramMesher, may_write_other_formats) {
  MesherProgram program = script(
      "printf 'OFF\\n4 2 0\\n0.1 0 0\\n3 1e-300 0\\n0.3333333333333333 2 0\\n-1e17 1 0\\n3 0 1 2\\n3 2 3 0\\n' > "
      "\"$2\"",
      "{out}");
  program.suffix = "off";
  const RefinedSubdomain answer = refine(program);
  EXPECT_EQ(answer.ending, Ending::finished) << answer.why;
  EXPECT_EQ(answer.points, two_triangles().points);
  EXPECT_EQ(answer.triangles, two_triangles().triangles);
}

TEST_F(ProgramMesher, that_a_signal_ends_has_crashed) {
  ends(script(copies + std::string("echo one; echo two; kill -SEGV $$")), Ending::crashed, "SIGSEGV: two");
}

TEST_F(ProgramMesher, that_exits_with_an_error_has_crashed) {
  ends(script(copies + std::string("exit 3")), Ending::crashed, "exit code 3");
  ends(script("echo \"Error: $1.node is too hard\" >&2; echo end; exit 1"), Ending::crashed,
       "exit code 1: Error: part.node is too hard");
}

TEST_F(ProgramMesher, has_the_exit_codes_of_success_that_it_is_said_to_have) {
  MesherProgram program = script(copies + std::string("exit 4"));
  program.success_codes = {0, 4};
  EXPECT_EQ(refine(program).ending, Ending::finished);
}

TEST_F(ProgramMesher, that_does_not_answer_in_time_is_killed_with_its_children) {
  Subdomain subdomain = two_triangles();
  subdomain.seconds = 0.5;
  const auto start = std::chrono::steady_clock::now();
  const RefinedSubdomain answer =
      refine(script(copies + ("sleep 600 & echo $! > '" + (folder_ / "child").string() + "'; wait")), subdomain);
  EXPECT_EQ(answer.ending, Ending::timed_out);
  EXPECT_EQ(answer.why, "no answer within 0.5 s");
  EXPECT_LT(std::chrono::steady_clock::now() - start, 60s);
  EXPECT_TRUE(is_gone(folder_.read("child")));
}

TEST_F(ProgramMesher, that_writes_no_file_is_unreadable) {
  ends(script("echo done"), Ending::unreadable, "it did not write part.1.ele: done");
  ends(script("cp \"$1.ele\" \"$1.1.ele\""), Ending::unreadable,
       "part.1.node: cannot be opened: No such file or directory");
}

TEST_F(ProgramMesher, that_writes_rubbish_is_unreadable) {
  ends(script(copies + std::string("printf '1 2 0 0\n1 0 zero\n' > \"$1.1.node\"")), Ending::unreadable,
       "part.1.node:2: expected a y coordinate, found \"zero\"");
  const RefinedSubdomain answer = refine(script(copies + std::string("head -c 999 /dev/urandom > \"$1.1.ele\"")));
  EXPECT_EQ(answer.ending, Ending::unreadable);
}

TEST_F(ProgramMesher, fails_without_a_folder_for_temporary_files) {
  const WithVariable missing("TMPDIR", folder_ / "missing");
  const RefinedSubdomain answer = refine(script(copies));
  EXPECT_EQ(answer.ending, Ending::failed);
  EXPECT_TRUE(answer.why.starts_with("no folder for temporary files (TMPDIR): ")) << answer.why;
}

TEST_F(ProgramMesher, is_refused_if_its_command_reads_no_file) {
  const auto refused = [&](const std::string& command) {
    const auto mesher = program_mesher({.command = command});
    EXPECT_FALSE(mesher.ok());
    return mesher.ok() ? "" : (mesher.error().kind == ErrorKind::usage ? "usage: " : "") + mesher.error().message;
  };
  const std::string needs = "' is no command with the argument {mesh} or {poly}, which stands for the files to read";
  EXPECT_EQ(refused("sh mesher"), "usage: 'sh mesher" + needs);
  EXPECT_EQ(refused("{mesh}"), "usage: '{mesh}" + needs);
  EXPECT_EQ(refused(""), "usage: '" + needs);
  EXPECT_EQ(refused("sh 'mesher {mesh}"), "usage: an open ' in the command");
}

TEST_F(ProgramMesher, is_refused_if_it_does_not_exist) {
  const auto missing = program_mesher({.command = "no-such-mesher {mesh}", .obtained = "write it"});
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::io);
  EXPECT_EQ(missing.error().message, "there is no program 'no-such-mesher' on the PATH; write it");
  EXPECT_EQ(message_of(program_mesher({.command = "./no-such-mesher {mesh}"}), folder_),
            "./no-such-mesher is no program");
}

TEST_F(ProgramMesher, keeps_edges_and_splits_no_segment) {
  const auto mesher = program_mesher(script(copies));
  ASSERT_TRUE(mesher.ok());
  const MesherAbilities able = mesher.value()->abilities();
  EXPECT_TRUE(able.keeps_frozen_edges && able.is_thread_safe);
  EXPECT_FALSE(able.obeys_cell || able.splits_segments || able.exempts_small_angles);
}

TEST_F(ProgramMesher, that_writes_a_pipe_or_a_link_to_a_device_is_unreadable) {
  const std::string node = "cp \"$1.node\" \"$1.1.node\"; ", ele = "cp \"$1.ele\" \"$1.1.ele\"; ";
  ends(script(node + "mkfifo \"$1.1.ele\""), Ending::unreadable, "part.1.ele is not a regular file");
  ends(script(ele + "mkfifo \"$1.1.node\""), Ending::unreadable, "part.1.node is not a regular file");
  ends(script(node + "ln -s /dev/zero \"$1.1.ele\""), Ending::unreadable, "part.1.ele is not a regular file");
}

TEST_F(ProgramMesher, whose_log_is_a_pipe_or_very_long_is_named_all_the_same) {
  ends(script("rm \"$(dirname \"$1\")/log\"; mkfifo \"$(dirname \"$1\")/log\"; exit 3"), Ending::crashed,
       "exit code 3");
  ends(script("head -c 400000 /dev/zero | tr '\\0' x; exit 3"), Ending::crashed,
       "exit code 3: " + std::string(300, 'x') + "...");
}

TEST_F(ProgramMesher, that_locks_its_folder_leaves_nothing) {
  ends(script("mkdir \"$1.cache\"; touch \"$1.cache/file\"; chmod 500 \"$1.cache\"; exit 3"), Ending::crashed,
       "exit code 3");
  ends(script("chmod 000 \"$(dirname \"$1\")\"; exit 3"), Ending::crashed, "exit code 3");
}

TEST_F(ProgramMesher, has_a_name_if_it_is_known) {
  EXPECT_EQ(named_programs(), (std::vector<std::string>{"triangle", "pardel-triangle"}));
  for (const std::string& name : named_programs()) EXPECT_TRUE(named_program(name).has_value()) << name;
  EXPECT_FALSE(named_program("no-such-mesher").has_value());
}

TEST_F(ProgramMesher, is_found_on_the_path_by_its_name) {
  // A program with Triangle's name that writes its arguments and copies its files.
  folder_.write("bin/triangle",
                "#!/bin/sh\necho \"$1\" > '" + (folder_ / "said").string() + "'\nset -- \"$2\"\n" + copies);
  std::filesystem::permissions(folder_ / "bin/triangle", std::filesystem::perms::owner_all);
  const WithVariable path("PATH", (folder_ / "bin").string() + ":/usr/bin:/bin");
  EXPECT_EQ(refine(*named_program("triangle")).ending, Ending::finished);
  EXPECT_EQ(folder_.read("said"), "-rpBPQYYq20.5aS1000000\n");
}

// Whole runs.

const MesherOptions small_tasks{.triangles_per_task = 600, .seconds_per_task = 100};

MeshedWithMesher run(const Pslg& pslg, const Goal& goal, const MesherProgram& program, int threads) {
  const auto mesher = program_mesher(program);
  const auto valid = validate(pslg);
  if (mesher && valid) {
    const auto made = mesh_with_mesher(*valid, goal, *mesher.value(), small_tasks, {.threads = threads});
    if (made) return *made;
    ADD_FAILURE() << made.error().message;
  } else {
    ADD_FAILURE() << (mesher ? "invalid domain" : mesher.error().message);
  }
  return {};
}

void expect_no_breach(const MesherReport& report) {
  for (std::size_t kind = 0; kind < breach_kinds; ++kind)
    EXPECT_EQ(report.breaches.count[kind], 0U) << report.breaches.first[kind].what;
}

void expect_certified(const Pslg& pslg, const Goal& goal, const MeshedWithMesher& made) {
  const Certificate certificate = check(pslg, made.mesh, goal);
  EXPECT_TRUE(certificate.valid) << to_text(certificate);
  EXPECT_TRUE(made.report.goal_met());
}

class ProgramRuns : public ProgramMesher {
 protected:
  const WithVariable path_{"PATH",
                           std::filesystem::path(PARDEL_PROGRAM).parent_path().string() + ":" + std::getenv("PATH")};
};

struct Case {
  const char* name;
  Pslg pslg;
  Goal goal;
};
class ProgramRunsOn : public ProgramRuns, public ::testing::WithParamInterface<Case> {};

TEST_P(ProgramRunsOn, make_certified_meshes_that_do_not_depend_on_threads) {
  const auto& [name, pslg, goal] = GetParam();
  const MesherProgram program = *named_program("pardel-triangle");
  const MeshedWithMesher one = run(pslg, goal, program, 1), three = run(pslg, goal, program, 3);
  EXPECT_EQ(digest(one.mesh), digest(three.mesh));
  EXPECT_GT(one.mesher.tasks, 2U);
  EXPECT_GT(one.mesher.inserted, 0U);
  expect_no_breach(one.mesher);
  expect_certified(pslg, goal, one);
}
INSTANTIATE_TEST_SUITE_P(
    of_several_domains, ProgramRunsOn,
    ::testing::Values(
        Case{"pipe", domains::pipe(), {.min_angle_deg = 25, .max_area = 3e-3}},
        Case{"key", domains::key(), {.min_angle_deg = 28, .max_area = 2e-3}},
        Case{"touching_holes", domains::touching_holes(), {.min_angle_deg = 20, .max_area = 2e-2}},
        Case{"cracks", domains::cracks(), {.min_angle_deg = 30, .max_area = 2e-2}},
        Case{"regions", domains::regions(), {.min_angle_deg = 25, .region_caps = true}},
        Case{"longest_edge", domains::square(), {.min_angle_deg = 20, .max_edge = 0.06}},
        Case{"sizes", domains::square(), {.min_angle_deg = 25, .size = [](Point p) { return 0.02 + 0.08 * p.x; }}}),
    [](const auto& each) { return std::string(each.param.name); });

TEST_F(ProgramRuns, may_mesh_the_poly_alone) {
  const Goal goal{.min_angle_deg = 25, .max_area = 3e-3};
  const MeshedWithMesher made = run(
      domains::pipe(), goal,
      {.command = "pardel triangle -pBPQYYq{min-angle}a{max-area}S{max-points} {poly}", .success_codes = {0, 4}}, 2);
  EXPECT_GT(made.mesher.inserted, 0U);
  expect_no_breach(made.mesher);
  expect_certified(domains::pipe(), goal, made);
}

TEST_F(ProgramRuns, end_certified_although_every_program_crashes) {
  const Goal goal{.min_angle_deg = 25, .max_area = 3e-3};
  const MeshedWithMesher made = run(domains::pipe(), goal, script("echo Error: no; exit 7"), 2);
  EXPECT_EQ(made.mesher.breaches.of(BreachKind::crashed), made.mesher.tasks);
  EXPECT_EQ(made.mesher.breaches.first[static_cast<std::size_t>(BreachKind::crashed)].what, "exit code 7: Error: no");
  expect_certified(domains::pipe(), goal, made);
}

}  // namespace
}  // namespace pardel
