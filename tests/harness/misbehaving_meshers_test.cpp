// Shell scripts call pardel and add known faults. The harness must report each fault by its name.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "harness_fixture.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

class Mesher : public HarnessFixture {
 protected:
  Mesher() {
    const std::filesystem::path pardel = PARDEL_PROGRAM;
    write("pardel.sh", "mesh() { " + pardel.string() + " mesh \"$1\" -o \"$2\" --min-angle 20 --quiet; }\n");
  }

  /// Runs the harness with a shell script as the mesher. $1 is the input, $2 the output; `mesh IN OUT` calls pardel.
  Ran try_script(const std::string& script, const std::vector<std::string>& more) const {
    write("mesher.sh", ". ./pardel.sh\n" + script + "\n");
    std::vector<std::string> arguments = {"--mesher", "sh mesher.sh {poly} {out}", "--json", "card.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return harness(arguments);
  }
  [[nodiscard]] json card() const { return json::parse(read("card.json")); }

  /// The verdict of the harness on three cases, with the kinds of failure, for example "wrong: overlap area_mismatch".
  [[nodiscard]] std::string verdict(const std::string& script, const std::vector<std::string>& more = {},
                                    const std::string& families = "general_position") const {
    std::vector<std::string> arguments = {"--cases", "3", "--families", families};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ran ran = try_script(script, arguments);
    const json report = card();
    std::string text;
    for (const auto& [name, cases] : report["counts"].items()) {
      if (cases != 0) text += name + (cases == 3 ? ":" : " sometimes:");
    }
    for (const json& kind : report["kinds"]) text += ' ' + kind["kind"].get<std::string>();
    EXPECT_EQ(ran.exit_code, text == "valid:" ? 0 : 1) << ran;
    return text;
  }
};

TEST_F(Mesher, that_writes_a_correct_mesh_is_valid) { EXPECT_EQ(verdict("mesh $1 $2"), "valid:"); }

TEST_F(Mesher, that_is_ended_by_a_signal_has_crashed) { EXPECT_EQ(verdict("kill -SEGV $$"), "crashed: SIGSEGV"); }

TEST_F(Mesher, whose_shell_reports_a_signal_has_crashed) {
  EXPECT_EQ(verdict("sh -c 'kill -ABRT $$'; exit $?"), "crashed: SIGABRT");
}

TEST_F(Mesher, that_does_not_end_hangs) {
  EXPECT_EQ(verdict("sleep 600", {"--time-limit", "0.2"}), "hung: time limit");
}

TEST_F(Mesher, that_writes_a_mesh_but_does_not_end_hangs) {
  EXPECT_EQ(verdict("mesh $1 $2; sleep 600", {"--time-limit", "2"}), "hung: time limit");
}

TEST_F(Mesher, that_exits_with_an_error_refuses) {
  EXPECT_EQ(verdict("mesh $1 $2; echo 'Error: too hard' >&2; exit 3"), "refused: exit code 3");
  EXPECT_EQ(card()["failures"][0]["findings"][0]["message"], "Error: too hard");
}

TEST_F(Mesher, that_writes_no_file_refuses) {
  EXPECT_EQ(verdict("echo done"), "refused: no output");
  EXPECT_EQ(card()["failures"][0]["findings"][0]["message"], "it did not write domain.1.ele, but: done");
}

TEST_F(Mesher, that_writes_random_bytes_is_wrong) {
  EXPECT_EQ(verdict("mesh $1 $2; head -c 1000 /dev/urandom > $2"), "wrong: unreadable");
  EXPECT_EQ(verdict(": > $2; : > ${2%.ele}.node"), "wrong: unreadable");
}

TEST_F(Mesher, that_loses_a_triangle_is_wrong) {
  const std::string verdict_ =
      verdict("mesh $1 $2; awk 'NR == 1 { $1 -= 1 } NR != 2 { if (NR > 1) $1 -= 1; print }' $2 > t && mv t $2");
  EXPECT_TRUE(holds(verdict_, {"wrong:", "uncovered_domain"}));
}

TEST_F(Mesher, that_meshes_the_holes_is_wrong) {
  // The first line has the number of points; the line after the points has the number of segments; the line after the
  // segments has the number of holes. awk sets that to 0 and drops the holes.
  const std::string fill =
      "awk 'NF && !/^#/ { ++n; if (n == 1) p = $1; if (n == p + 2) s = $1; "
      "if (n == p + s + 3) { h = $1; $0 = 0 } else if (n > p + s + 3 && n <= p + s + 3 + h) next } { print }' $1 > "
      "f.poly";
  const std::string verdict_ = verdict(fill + "; mesh f.poly $2", {}, "touching_holes");
  EXPECT_TRUE(holds(verdict_, {"wrong:", "covered_exterior"}));
}

TEST_F(Mesher, that_misses_only_a_bound_has_the_verdict_missed) {
  EXPECT_EQ(verdict("mesh $1 $2", {"--max-area-fraction", "1e-4"}), "missed: large_area");
}

TEST_F(Mesher, receives_the_bounds_as_arguments) {
  const Ran ran = harness({"--mesher",
                           std::string(PARDEL_PROGRAM) + " mesh {poly} -o {out} --min-angle {min-angle} --max-area "
                                                         "{max-area} --quiet",
                           "--min-angle", "25", "--max-area-fraction", "0.01", "--cases", "22"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
}

TEST_F(Mesher, may_write_any_format) {
  for (const char* format : {"vtu", "msh", "off"}) EXPECT_EQ(verdict("mesh $1 $2", {"--format", format}), "valid:");
}

TEST_F(Mesher, may_write_the_file_that_triangle_writes) {
  write("mesher.sh", ". ./pardel.sh; mesh $1 ${1%.poly}.1.ele");
  const Ran ran = harness({"--mesher", "sh mesher.sh {poly}", "--cases", "3"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
}

/// A mesher that meshes correctly but crashes on inputs with a hole.
constexpr const char* afraid =
    "case $(awk 'NF && !/^#/ { if (++n == 1) p = $1; if (n == p + 2) s = $1; if (n == p + s + 3) print $1 }' $1) in\n"
    "0) mesh $1 $2 ;;\n*) kill -SEGV $$ ;;\nesac";

TEST_F(Mesher, gets_the_same_report_with_any_number_of_jobs) {
  const std::vector<std::string> options = {"--cases",    "44",       "--seed",        "5",
                                            "--failures", "failures", "--shrink-runs", "40"};
  std::vector<std::string> more = options;
  more.insert(more.end(), {"--jobs", "1"});
  const Ran one = try_script(afraid, more);
  const std::string json_of_one = read("card.json"), poly_of_one = read("failures/SIGSEGV.poly");
  more.back() = "3";
  const Ran three = try_script(afraid, more);
  EXPECT_EQ(one.exit_code, 1) << one;
  EXPECT_EQ(one.out, three.out);
  EXPECT_EQ(json_of_one, read("card.json"));
  EXPECT_EQ(poly_of_one, read("failures/SIGSEGV.poly"));
  EXPECT_NE(poly_of_one, "");
}

TEST_F(Mesher, that_crashes_on_holes_gets_a_smallest_domain_with_one_hole) {
  const Ran ran =
      try_script(afraid, {"--cases", "22", "--families", "touching_holes,nested_holes", "--failures", "small"});
  EXPECT_EQ(ran.exit_code, 1) << ran;
  EXPECT_TRUE(exists("small/SIGSEGV.svg"));
  const json smallest = card()["kinds"][0]["smallest"];
  EXPECT_EQ(smallest["holes"], 1);
  EXPECT_EQ(smallest["shrunk_fully"], true) << smallest;
  EXPECT_LE(smallest["points"], 8) << smallest;
}

TEST_F(Mesher, fails_again_when_a_failing_case_is_replayed) {
  try_script(afraid, {"--cases", "44"});
  const std::string id = card()["failures"][0]["case"], kind = card()["failures"][0]["findings"][0]["kind"];
  const Ran again = try_script(afraid, {"--replay", id, "--keep", "kept"});
  EXPECT_EQ(again.exit_code, 1) << again;
  EXPECT_EQ(card()["cases"], 1);
  EXPECT_EQ(card()["failures"][0]["case"], id);
  EXPECT_EQ(card()["failures"][0]["findings"][0]["kind"], kind);
  std::string folder = id;
  std::replace(folder.begin(), folder.end(), ':', '-');
  EXPECT_TRUE(exists("kept/" + folder + "/domain.poly"));
}

}  // namespace
}  // namespace pardel::testing
