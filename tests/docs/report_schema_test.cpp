// docs/report.schema.json describes exactly the reports that the program writes: every key of a report is in the
// schema, and every key of the schema is in a report.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "../../off_the_shelf/breach.hpp"
#include "../../parallel/report.hpp"
#include "../../parallel/validate.hpp"
#include "../../properties/checker/check.hpp"
#include "../cli/program.hpp"
#include "json_schema.hpp"

namespace pardel::testing {
namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;

Json schema() { return Json::parse(std::ifstream(PARDEL_SOURCE "/docs/report.schema.json")); }

class ReportSchema : public Workshop {
 protected:
  /// The report of `pardel mesh square.poly -o mesh.vtu OPTIONS... --json -`.
  Json report(std::vector<std::string> options, const std::string& domain = "square.poly") const {
    write("square.poly", square_poly);
    std::vector<std::string> arguments = {"mesh", domain, "-o", "mesh.vtu", "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return Json::parse(pardel(arguments).out);
  }
};

/// Calls act(object, key) for every key of every object inside `value`. act may change the object, and must restore it.
template <class Act>
void for_every_key(Json& value, const Act& act) {
  if (value.is_object()) {
    const Json keys = value;
    for (const auto& [key, ignored] : keys.items()) act(value, key);
  }
  if (value.is_structured()) {
    for (Json& member : value) for_every_key(member, act);
  }
}

TEST_F(ReportSchema, describes_the_report_of_a_plain_run) {
  EXPECT_EQ(schema_violations(schema(), report({})), Strings());
}

TEST_F(ReportSchema, describes_the_report_of_a_run_with_every_option) {
  write("square.sizes", "4\n1 0.1\n2 0.2\n3 0.3\n4 0.2\n");
  const Json with_check = report({"--check", "--paranoid", "--sizes", "square.sizes", "--max-area", "0.001",
                                  "--max-edge", "0.2", "--conforming", "--regions", "--decomposition", "paper",
                                  "--placement", "circumcentre", "--threads", "2"});
  EXPECT_EQ(schema_violations(schema(), with_check), Strings());
}

TEST_F(ReportSchema, describes_exemptions_of_both_sorts) {
  pardel({"generate", "wedge", "-o", "wedge.poly"});
  const Json small_angles = report({"--min-angle", "30", "--check"}, "wedge.poly");
  EXPECT_FALSE(small_angles.at("refine").at("exemptions").empty());
  EXPECT_FALSE(small_angles.at("certificate").at("justified").empty());
  EXPECT_EQ(schema_violations(schema(), small_angles), Strings());

  const Json budget = report({"--max-area", "0.001", "--max-vertices", "50", "--check"});
  EXPECT_FALSE(budget.at("goal_met").get<bool>());
  EXPECT_FALSE(budget.at("certificate").at("violations").empty());
  EXPECT_EQ(schema_violations(schema(), budget), Strings());
}

TEST_F(ReportSchema, describes_what_a_sequential_mesher_has_done) {
  const Json breaches = report({"--max-area", "0.0001", "--mesher", "false {mesh}"});
  EXPECT_EQ(schema_violations(schema(), breaches), Strings());
  EXPECT_EQ(breaches.at("mesher").at("breaches").at(0).at("kind"), "crashed");
  const Json none = report({"--max-area", "0.001", "--mesher", "own", "--scheme", "cells"});
  EXPECT_EQ(schema_violations(schema(), none), Strings());
  EXPECT_TRUE(none.at("mesher").at("breaches").empty());
}

TEST_F(ReportSchema, lists_every_kind_of_breach) {
  Json kinds = Json::array();
  for (int i = 0; i < breach_kinds; ++i) kinds.push_back(name(static_cast<BreachKind>(i)));
  const Json mesher = schema().at("properties").at("mesher").at("properties");
  EXPECT_EQ(mesher.at("breaches").at("items").at("properties").at("kind").at("enum"), kinds);
}

TEST_F(ReportSchema, describes_the_certificate_that_pardel_check_writes) {
  report({});
  Json of_certificate = schema();
  of_certificate = {{"$ref", "#/$defs/certificate"}, {"$defs", of_certificate.at("$defs")}};
  const Ran ran = pardel({"check", "square.poly", "mesh.vtu", "--max-area", "0.01", "--json", "-"});
  EXPECT_EQ(ran.exit_code, 1);
  EXPECT_EQ(schema_violations(of_certificate, Json::parse(ran.out)), Strings());
}

/// The unit square and, beside it, two segments with open ends.
constexpr const char* open_beside_closed =
    "7 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 2 0\n6 3 0\n7 3 1\n6 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n0\n";

TEST_F(ReportSchema, describes_the_warnings_about_a_domain) {
  write("beside.poly", open_beside_closed);
  const Json with_warning = report({}, "beside.poly");
  EXPECT_EQ(schema_violations(schema(), with_warning), Strings());
  EXPECT_EQ(with_warning.at("warnings").at(0).at("segments"), (Json{4, 5})) << "numbered from 0";
  EXPECT_TRUE(report({}).at("warnings").empty());
}

TEST_F(ReportSchema, describes_the_findings_of_doctor) {
  Json of_findings = schema();
  of_findings = {{"$ref", "#/$defs/findings"}, {"$defs", of_findings.at("$defs")}};
  const auto findings = [&](const std::string& file, const Strings& options) {
    Strings arguments = {"doctor", file, "--json", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json json = Json::parse(pardel(arguments).out);
    EXPECT_EQ(schema_violations(of_findings, json), Strings()) << json;
    return json;
  };
  write("beside.poly", open_beside_closed);
  write("crossing.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n2 0\n1 1 2\n2 3 4\n0\n");
  write("twice.poly", "5 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n5 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 5 1\n0\n");
  EXPECT_EQ(findings("beside.poly", {}).at("warnings").at(0).at("segments"), (Json{5, 6})) << "as in the file";
  EXPECT_FALSE(findings("crossing.poly", {}).at("problems").empty());
  EXPECT_FALSE(findings("twice.poly", {"--repair", "once.poly"}).at("repaired").is_null());
}

TEST_F(ReportSchema, describes_what_is_written_for_invalid_input) {
  Json of_error = schema();
  of_error = {{"$ref", "#/$defs/error"}, {"$defs", of_error.at("$defs")}};
  write("crossing.poly", "4 2 0 0\n1 0 0\n2 1 1\n3 1 0\n4 0 1\n2 0\n1 1 2\n2 3 4\n0\n");
  write("cut.poly", "4 2 0 0\n1 0 0\n");
  for (const char* file : {"crossing.poly", "cut.poly"}) {
    for (const char* command : {"mesh", "check"}) {
      Strings arguments = {command, file, "--json", "e.json"};
      if (arguments[0] == "mesh") arguments.insert(arguments.end(), {"-o", "m.vtu"});
      if (arguments[0] == "check") arguments.insert(arguments.begin() + 2, "none.vtu");
      EXPECT_EQ(pardel(arguments).exit_code, 3);
      const Json error = Json::parse(read("e.json"));
      EXPECT_EQ(schema_violations(of_error, error), Strings()) << error;
      EXPECT_EQ(error.at("problems").empty(), file == std::string("cut.poly"));
    }
  }
  Json wrong = Json::parse(read("e.json"));
  wrong.erase("problems");
  EXPECT_FALSE(schema_violations(of_error, wrong).empty());
}

TEST_F(ReportSchema, lists_every_kind_of_problem) {
  Json kinds = Json::array();
  for (int i = 0; i <= static_cast<int>(ProblemKind::bad_region_cap); ++i)
    kinds.push_back(name(static_cast<ProblemKind>(i)));
  EXPECT_EQ(schema().at("$defs").at("problem_kind").at("enum"), kinds);
}

TEST_F(ReportSchema, rejects_a_report_that_lacks_a_key) {
  const Json all = schema();
  Json right = report({"--check"});
  const auto reject = [&](Json& object, const std::string& key) {
    const Json kept = object.at(key);
    if (key == "certificate") return;  // only with --check
    object.erase(key);
    EXPECT_FALSE(schema_violations(all, right).empty()) << "without " << key;
    object[key] = kept;
  };
  for_every_key(right, reject);
}

TEST_F(ReportSchema, rejects_a_report_with_an_unknown_key) {
  const Json all = schema();
  Json right = report({"--check"});
  const auto reject = [&](Json& object, const std::string& key) {
    object["unknown"] = 1;
    EXPECT_FALSE(schema_violations(all, right).empty()) << "next to " << key;
    object.erase("unknown");
  };
  for_every_key(right, reject);
}

TEST_F(ReportSchema, lists_every_reason_and_every_kind_of_violation) {
  const Json definitions = schema().at("$defs");
  Json reasons = Json::array();
  for (int i = 0; i < exempt_reasons; ++i) reasons.push_back(name(static_cast<ExemptReason>(i)));
  EXPECT_EQ(definitions.at("exempt_reason").at("enum"), reasons);

  Json kinds = Json::array();
  const std::size_t kind_count = check({}, {}, {}).violation_counts.size();
  for (std::size_t i = 0; i < kind_count; ++i) kinds.push_back(name(static_cast<ViolationKind>(i)));
  EXPECT_EQ(definitions.at("violation_kind").at("enum"), kinds);
}

TEST(JsonSchema, finds_each_kind_of_violation) {
  const Json schema = Json::parse(R"({"type": "object", "properties": {
    "n": {"type": "integer", "minimum": 1}, "s": {"type": "string", "pattern": "^a+$"}, "e": {"enum": [1, null]},
    "p": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}, "c": {"const": true}}})");
  const Json right = Json::parse(R"({"n": 1, "s": "aa", "e": null, "p": [1, 2.5], "c": true})");
  EXPECT_EQ(schema_violations(schema, right), Strings());
  const char* const wrong[] = {R"({"n": 0})",   R"({"n": 1.5})",     R"({"s": "ab"})", R"({"e": 2})",      R"([])",
                               R"({"p": [1]})", R"({"p": [1,2,3]})", R"({"c": 1})",    R"({"p": ["a",1]})"};
  for (const char* value : wrong) EXPECT_EQ(schema_violations(schema, Json::parse(value)).size(), 1u) << value;
  EXPECT_FALSE(schema_violations(Json::parse(R"({"oneOf": []})"), 1).empty());
}

}  // namespace
}  // namespace pardel::testing
