#include "property.hpp"

#include <rapidcheck/detail/TestListenerAdapter.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "../../../core/formats.hpp"
#include "shares.hpp"

namespace pardel::properties {
namespace {
namespace fs = std::filesystem;

constexpr int usual_cases = 2'000;
constexpr std::uint64_t usual_seed = 20040626;

std::string environment(const char* name, std::string otherwise = {}) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::move(otherwise) : std::string(value);
}

/// SUITE.NAME of the running test.
std::string test_name() {
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::string(test->test_suite_name()) + "." + test->name();
}

/// The settings in RC_PARAMS. Settings that are not in RC_PARAMS get fixed values instead of RapidCheck's own defaults
/// (100 cases and a new seed in each run).
rc::detail::Configuration configuration() {
  rc::detail::Configuration usual;
  usual.testParams.maxSuccess = usual_cases;
  usual.testParams.seed = usual_seed;
  return rc::detail::configFromString(environment("RC_PARAMS"), usual);
}

/// A command line that runs this test with these settings of RapidCheck.
std::string command_line(const std::string& settings) {
  std::error_code unknown;
  return "RC_PARAMS=\"" + settings + "\" " + fs::read_symlink("/proc/self/exe", unknown).string() +
         " --gtest_filter=" + test_name();
}

std::string replay_of_all(const rc::detail::TestParams& params) {
  return command_line("seed=" + std::to_string(params.seed) + " max_success=" + std::to_string(params.maxSuccess));
}

/// The line runs the smallest case that fails, and no other.
std::string replay_of_one(const rc::detail::Reproduce& failure) {
  rc::detail::Configuration settings;
  settings.reproduce[test_name()] = failure;
  return command_line(rc::detail::configToMinimalString(settings));
}

/// Did RapidCheck repeat a case that failed before, and fails no longer? It calls this an error.
bool has_been_mended(const rc::detail::TestResult& result) {
  return result.is<rc::detail::Error>() &&
         result.get<rc::detail::Error>().description == "Reproduced result is not a failure";
}

void record(const Statement& statement, std::uint64_t cases, const std::map<std::string, std::uint64_t>& shares,
            const std::vector<std::string>& notes) {
  const std::string folder = environment("PARDEL_RECORDS");
  if (folder.empty()) return;
  fs::create_directories(folder);
  const nlohmann::json row{{"property", test_name()},
                           {"statement", statement.statement},
                           {"source", statement.source},
                           {"families", statement.families},
                           {"cases", cases},
                           {"shares", shares},
                           {"notes", notes}};
  std::ofstream(fs::path(folder) / (test_name() + ".json")) << row.dump(1) << '\n';
}

}  // namespace

std::string Exhibit::write(const std::string& stem) const {
  const fs::path poly = stem + ".poly", svg = stem + ".svg";
  std::vector<Status> written;
  if (const auto* scene = std::get_if<Scene>(&shown_)) {
    written = {write_poly(to_pslg(*scene), poly), draw(*scene, svg)};
  } else if (const auto* pslg = std::get_if<Pslg>(&shown_)) {
    written = {write_poly(*pslg, poly), write_svg(*pslg, svg)};
  } else if (const auto* both = std::get_if<std::pair<Pslg, Mesh>>(&shown_)) {
    written = {write_poly(both->first, poly), write_svg(both->second, svg)};
  } else {
    return "The case has nothing to draw.";
  }
  std::string report = "Shrunk case: " + poly.string() + ", " + svg.string();
  for (const Status& status : written)
    if (!status) report += "\n  " + status.error().message;
  return report;
}

void check_property(const Statement& statement, void (*body)(Exhibit&)) {
  rc::detail::TestMetadata metadata;
  metadata.id = test_name();
  metadata.description = testing::UnitTest::GetInstance()->current_test_info()->name();

  // Shrinking continues from every case that fails, so the last case that fails is the smallest.
  Exhibit smallest;
  const auto one_case = [&] {
    Exhibit exhibit;
    try {
      body(exhibit);
    } catch (const rc::detail::CaseResult& result) {
      if (result.type == rc::detail::CaseResult::Type::Failure) smallest = exhibit;
      throw;
    } catch (const rc::GenerationFailure&) {
      throw;
    } catch (...) {
      smallest = exhibit;
      throw;
    }
  };
  const rc::detail::Configuration wanted = configuration();
  rc::detail::TestListenerAdapter silent;
  const rc::detail::TestResult result =
      rc::detail::checkTestable(one_case, metadata, wanted.testParams, silent, wanted.reproduce);

  if (result.is<rc::detail::SuccessResult>()) {
    const auto& success = result.get<rc::detail::SuccessResult>();
    const auto cases = static_cast<std::uint64_t>(success.numSuccess);
    const Shares shares = shares_of(success.distribution);
    for (const std::string& broken : broken_promises(shares, cases)) ADD_FAILURE() << broken;
    if (!testing::Test::HasFailure()) record(statement, cases, shares.cases, {});
    return;
  }
  if (has_been_mended(result)) return;
  std::ostringstream story;
  rc::detail::printResultMessage(result, story);
  story << "\nReplay: " << replay_of_all(wanted.testParams);
  if (result.is<rc::detail::FailureResult>()) {
    story << "\nReplay of this case: " << replay_of_one(result.get<rc::detail::FailureResult>().reproduce);
    const fs::path folder = environment("PARDEL_FAILURES", "property-failures");
    std::error_code reported_by_write;
    fs::create_directories(folder, reported_by_write);
    story << '\n' << smallest.write((folder / test_name()).string());
  }
  FAIL() << statement.statement << "\n  (" << statement.source << ")\n\n" << story.str() << '\n';
}

void check_fact(const Statement& statement, void (*body)(Facts&)) {
  Facts facts;
  body(facts);
  for (const std::string& note : facts.notes) std::cout << "  " << note << '\n';
  if (!testing::Test::HasFailure()) record(statement, facts.cases, {}, facts.notes);
}

}  // namespace pardel::properties
