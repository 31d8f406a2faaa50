// pardel doctor: the list of problems and the repair.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.hpp"

namespace pardel::testing {
namespace {

using nlohmann::json;

/// The square with both diagonals, which cross, and a duplicate point.
constexpr const char* ill =
    "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 5 1\n5 1 3\n6 2 4\n0\n";

using DoctorCommand = Workshop;

TEST_F(DoctorCommand, a_valid_domain_has_no_problem) {
  write("square.poly", square_poly);
  const Ran ran = pardel({"doctor", "square.poly"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"square.poly", "4 points", "no problem"}));
}

TEST_F(DoctorCommand, one_hole_is_not_called_1_holes) {
  write("hole.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n1\n1 7 8\n");
  EXPECT_TRUE(holds(pardel({"doctor", "hole.poly"}).out, {"4 points, 4 segments, 1 hole, 0 regions: 1 problem\n"}));
}

TEST_F(DoctorCommand, and_mesh_name_a_hole_outside_the_outline) {
  write("hole.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n1\n1 7 8\n");
  const std::string problem = "Hole 1 at (7, 8) lies outside every closed outline.";
  const Ran doctor = pardel({"doctor", "hole.poly"}), mesh = pardel({"mesh", "hole.poly", "-o", "m.vtu"});
  EXPECT_EQ(doctor.exit_code, 3) << doctor;
  EXPECT_EQ(mesh.exit_code, 3) << mesh;
  EXPECT_TRUE(holds(doctor.out, {problem}));
  EXPECT_TRUE(holds(mesh.err, {problem}));
}

TEST_F(DoctorCommand, and_mesh_name_a_loop_that_is_given_twice) {
  const std::string square = "1 0 0\n2 1 0\n3 1 1\n4 0 1\n", sides = "1 1 2\n2 2 3\n3 3 4\n4 4 1\n";
  const auto says = [&](const std::string& text, const std::string& sentence) {
    write("twice.poly", text);
    EXPECT_TRUE(holds(pardel({"doctor", "twice.poly"}).out, {sentence}));
    EXPECT_TRUE(holds(pardel({"mesh", "twice.poly", "-o", "m.vtu"}).err, {sentence}));
  };
  // Its points and its segments are repeated, in another order and direction.
  says("8 2 0 0\n" + square + "5 1 1\n6 0 1\n7 0 0\n8 1 0\n8 0\n" + sides + "5 6 5\n6 7 6\n7 8 7\n8 5 8\n0\n",
       "The loop of points 1 to 4 is given twice.");
  says("4 2 0 0\n" + square + "12 0\n" + sides + sides + sides + "0\n", "The loop of points 1 to 4 is given 3 times.");
  says("5 2 0 0\n" + square + "5 2 0\n8 0\n" + sides + "5 2 5\n6 5 3\n7 3 2\n8 5 2\n0\n", "Segments 5 and 8");
  EXPECT_EQ(pardel({"doctor", "twice.poly"}).out.find("The loop"), std::string::npos) << "two sides are no loop";
}

TEST_F(DoctorCommand, problems_are_listed_with_kind_numbers_and_place) {
  write("ill.poly", ill);
  const Ran ran = pardel({"doctor", "ill.poly"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.out, {"crossing_segments", "0.5, 0.5", "duplicate_points"}));
}

TEST_F(DoctorCommand, a_repaired_domain_can_be_meshed) {
  write("ill.poly", ill);
  const Ran ran = pardel({"doctor", "ill.poly", "--repair", "well.poly"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.out, {"repaired: ", "wrote   well.poly\n"}));
  EXPECT_EQ(pardel({"doctor", "well.poly"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "well.poly", "-o", "m.vtu", "--check"}).exit_code, 0);
}

TEST_F(DoctorCommand, the_repaired_domain_is_numbered_like_the_invalid_one) {
  write("ill.poly", "5 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 4 0\n0\n");
  ASSERT_EQ(pardel({"doctor", "ill.poly", "--repair", "well.poly"}).exit_code, 0);
  EXPECT_EQ(table("well.poly")[1][0], 0);
}

TEST_F(DoctorCommand, the_repair_log_and_the_problems_are_numbered_like_the_file) {
  for (const int base : {0, 1}) {
    std::string text = base == 0 ? "4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n"
                                 : "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n";
    write("holes.poly", text + "2\n0 0.5 0\n1 7 7\n");  // one on the first segment, one outside
    const Ran ran = pardel({"doctor", "holes.poly", "--repair", "well.poly"});
    EXPECT_EQ(ran.exit_code, 0) << ran;
    const std::string first = std::to_string(base), second = std::to_string(base + 1);
    const std::string on = "Hole " + first + " at (0.5, 0) lies on segment " + first;
    const std::string outside = "Hole " + second + " at (7, 7)";
    EXPECT_TRUE(holds(ran.out,
                      {"hole_on_segment: " + on, "hole_outside: " + outside, "Dropped: " + on, "Dropped: " + outside}));
  }
}

TEST_F(DoctorCommand, points_closer_than_the_snap_are_merged) {
  write("near.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 1e-9 1\n4 0\n1 1 2\n2 2 3\n3 3 5\n4 4 1\n0\n");
  EXPECT_EQ(pardel({"doctor", "near.poly", "--repair", "well.poly", "--snap", "1e-6"}).exit_code, 0);
  EXPECT_EQ(table("well.poly")[0][0], 4);
  EXPECT_EQ(pardel({"mesh", "well.poly", "-o", "m.vtu"}).exit_code, 0);
}

constexpr const char* gap =
    "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-15\n6 0.5 0.5\n5 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n0\n";

TEST_F(DoctorCommand, a_gap_of_one_rounding_is_closed_unless_the_snap_is_zero) {
  write("gap.poly", gap);
  const Ran by_default = pardel({"doctor", "gap.poly", "--repair", "closed.poly"});
  EXPECT_EQ(by_default.exit_code, 0) << by_default;
  EXPECT_TRUE(
      holds(by_default.out, {"repaired: Segments bent to points near them: 1", "segment 1 from (0, 0)", "1e-15"}));
  EXPECT_EQ(table("closed.poly")[7][0], 6);
  EXPECT_EQ(pardel({"doctor", "gap.poly", "--repair", "open.poly", "--snap", "0"}).exit_code, 0);
  EXPECT_EQ(table("open.poly")[7][0], 5);
  EXPECT_EQ(pardel({"doctor", "gap.poly", "--repair", "open.poly", "--snap", "-1"}).exit_code, 2);
}

TEST_F(DoctorCommand, an_open_outline_is_repaired_for_its_convex_hull) {
  write("open.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n");
  EXPECT_EQ(pardel({"doctor", "open.poly", "--repair", "well.poly", "--convex-hull"}).exit_code, 0);
  EXPECT_EQ(pardel({"mesh", "well.poly", "--convex-hull", "-o", "m.vtu"}).exit_code, 0);
}

TEST_F(DoctorCommand, and_mesh_warn_of_an_outline_that_is_not_closed_beside_a_closed_one) {
  write("beside.poly",
        "7 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 2 0\n6 3 0\n7 3 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n0\n");
  const std::string warning = "beside.poly: warning: 2 segments, the first of them segment 5, are joined";
  const Ran doctor = pardel({"doctor", "beside.poly"}), mesh = pardel({"mesh", "beside.poly", "-o", "m.vtu"});
  EXPECT_EQ(doctor.exit_code, 0) << doctor;
  EXPECT_EQ(mesh.exit_code, 0) << mesh;
  EXPECT_TRUE(holds(doctor.err, {warning}));
  EXPECT_TRUE(holds(mesh.err, {warning}));
}

TEST_F(DoctorCommand, warns_of_an_outline_that_is_not_closed_after_the_repair_too) {
  write("ill.poly",
        "8 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 0\n6 2 0\n7 3 0\n8 3 1\n"
        "6 0\n1 5 2\n2 2 3\n3 3 4\n4 4 1\n5 6 7\n6 7 8\n0\n");
  const Ran ran = pardel({"doctor", "ill.poly", "--repair", "well.poly", "--json", "findings.json"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  const std::string message = "2 segments, the first of them segment 5, are joined";
  EXPECT_TRUE(holds(ran.err, {"well.poly: warning: " + message})) << ran;
  EXPECT_TRUE(holds(read("findings.json"), {message}));
  EXPECT_TRUE(holds(pardel({"doctor", "well.poly"}).err, {"well.poly: warning: " + message}));
}

/// The spike becomes a line outside the domain, and the channel one between its two ends.
TEST_F(DoctorCommand, and_mesh_say_what_a_snapping_distance_removes) {
  write("spike.poly",
        "7 2 0 0\n1 0 0\n2 1 0\n3 1 0.5\n4 2 0.5000005\n5 1 0.500001\n6 1 1\n7 0 1\n"
        "7 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 7\n7 7 1\n0\n");
  write("channel.poly",
        "12 2 0 0\n1 0 0\n2 100 0\n3 100 50\n4 200 50\n5 200 0\n6 300 0\n7 300 100\n8 200 100\n9 200 50.0001\n"
        "10 100 50.0001\n11 100 100\n12 0 100\n"
        "12 0\n1 1 2\n2 2 3\n3 3 4\n4 4 5\n5 5 6\n6 6 7\n7 7 8\n8 8 9\n9 9 10\n10 10 11\n11 11 12\n12 12 1\n0\n");
  write("strip.poly",
        "6 2 0 0\n1 0 0\n2 100 0\n3 100 100\n4 0 100\n5 0 0.00001\n6 100 0.00001\n"
        "7 0\n1 1 2\n2 2 6\n3 6 3\n4 3 4\n5 4 5\n6 5 1\n7 5 6\n0\n");
  for (const auto& [file, advice] :
       {std::pair{"spike.poly",
                  " closes the narrowest (1 point and 1 segment merge with others, the area changes by -5e-05 %); look "
                  "at the result\n"},
        {"channel.poly",
         " closes the narrowest (2 points and 1 segment merge with others, the area changes by -5e-05 %, 1 face "
         "becomes "
         "2); look at the result\n"},
        {"strip.poly",
         " closes the narrowest (2 points and 3 segments merge with others, 1 of 2 faces "
         "vanishes); look at the result\n"}}) {
    EXPECT_TRUE(holds(pardel({"doctor", file}).err, {"\n--repair with --snap ", advice})) << pardel({"doctor", file});
    const Ran mesh = pardel({"mesh", file, "-o", "m.vtu", "--max-vertices", "1000"});
    EXPECT_TRUE(holds(mesh.err, {"\n--repair with --snap ", advice})) << mesh;
  }
}

TEST_F(DoctorCommand, names_no_snapping_distance_without_saying_that_it_removes_the_domain) {
  write("plate.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1e-8\n4 0 1e-8\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran ran = pardel({"doctor", "plate.poly"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(
      holds(ran.err, {"--snap 2.2e-08 would close the narrowest, but also remove a part of the domain, a hole or a "
                      "region (the repair fails)\n"}));
  EXPECT_EQ(pardel({"doctor", "plate.poly", "--repair", "fixed.poly", "--snap", "2.2e-8"}).exit_code, 3);
}

TEST_F(DoctorCommand, warns_of_a_point_far_away_from_everything_else) {
  write("far.poly", "6 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 0.5\n6 -500 0\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const Ran ran = pardel({"doctor", "far.poly", "--json", "far.json"});
  EXPECT_EQ(ran.exit_code, 0) << ran;
  EXPECT_TRUE(holds(ran.err, {"far.poly: warning: Point 6 at (-500, 0) lies far away from everything else."}));
  EXPECT_TRUE(holds(read("far.json"), {R"("kind": "far_part")"}));
}

TEST_F(DoctorCommand, and_mesh_warn_of_gaps_and_name_a_snapping_distance_that_closes_them) {
  write("gap.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0.5 1e-8\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n");
  const std::string message = "The distance of point 5 at (0.5, 1e-08) from segment 1 is only 1e-08.";
  const std::string warning = "gap.poly: warning: 1 gap is much narrower";
  const Ran doctor = pardel({"doctor", "gap.poly", "--json", "-"}), mesh = pardel({"mesh", "gap.poly", "-o", "m.vtu"});
  EXPECT_EQ(doctor.exit_code, 0) << doctor;
  EXPECT_TRUE(holds(doctor.err, {warning, message, "--snap 2.2e-08 closes"})) << doctor;
  EXPECT_TRUE(holds(mesh.err, {warning, message, "--snap 2.2e-08 closes"})) << mesh;
  const json gaps = json::parse(doctor.out)["gaps"];
  ASSERT_EQ(gaps.size(), 1);
  EXPECT_EQ(gaps[0]["kind"], "point_near_segment");
  EXPECT_EQ(gaps[0]["points"], json({5}));
  EXPECT_EQ(gaps[0]["segment"], 1);
  EXPECT_EQ(gaps[0]["message"], message);

  const Ran repair = pardel({"doctor", "gap.poly", "--repair", "closed.poly", "--snap", "2.2e-8"});
  EXPECT_EQ(repair.err.find("warning"), std::string::npos) << repair;
  EXPECT_TRUE(holds(pardel({"doctor", "gap.poly", "--repair", "open.poly"}).err, {"open.poly: warning: 1 gap"}));
}

TEST_F(DoctorCommand, a_failed_repair_is_reported) {
  write("open.poly", "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n3 0\n1 1 2\n2 2 3\n3 3 4\n0\n");
  const Ran ran = pardel({"doctor", "open.poly", "--repair", "well.poly"});
  EXPECT_EQ(ran.exit_code, 3) << ran;
  EXPECT_TRUE(holds(ran.err, {"open.poly", "outline"}));
  EXPECT_FALSE(exists("well.poly"));
}

TEST_F(DoctorCommand, a_failed_repair_states_the_problem_that_appears_only_after_the_others_are_repaired) {
  write("open.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 1 1\n3 0\n1 1 2\n2 2 3\n3 5 4\n0\n");
  for (const Ran& ran : {pardel({"doctor", "open.poly", "--repair", "well.poly"}),
                         pardel({"mesh", "open.poly", "--repair", "-o", "m.vtu"})}) {
    EXPECT_EQ(ran.exit_code, 3) << ran;
    EXPECT_TRUE(holds(ran.err, {"Points 3 and 5 are both", "the repair ends here: No outline is closed"})) << ran;
  }
}

TEST_F(DoctorCommand, the_findings_are_written_as_json) {
  write("ill.poly", ill);
  for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{"--json"}, {"--json", "-"}}) {
    std::vector<std::string> arguments = {"doctor", "ill.poly"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Ran ran = pardel(arguments);
    const json findings = json::parse(ran.out, nullptr, false);
    ASSERT_TRUE(findings.is_object()) << ran;
    EXPECT_EQ(ran.exit_code, 3);
    EXPECT_EQ(findings["schema"], "pardel.doctor/1");
    EXPECT_FALSE(findings["valid"]);
    EXPECT_EQ(findings["input"]["points"], 5);
    ASSERT_FALSE(findings["problems"].empty());
    EXPECT_EQ(findings["problems"][0]["ids"], (json{4, 5}));  // numbered as in the file
    EXPECT_EQ(findings["problems"][0]["where"], (json{0.0, 1.0}));
    EXPECT_TRUE(findings["repaired"].is_null());
  }
}

}  // namespace
}  // namespace pardel::testing
