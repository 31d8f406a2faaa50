// A command of which one call of the system fails, or all calls from one on, ends with a message and exit code 5, or
// does what it does without the failure. Its outputs are then complete, old or new, and no other file remains. Files
// that get their names together are all old or all new.
// Without PARDEL_FAULT_CASES some of the calls fail in turn; with a large value every call does (fuzz/faults).
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../cli/program.hpp"
#include "selection.hpp"

namespace pardel::testing {
namespace fs = std::filesystem;
namespace {

constexpr const char* old_text = "an earlier file\n";

struct Command {
  std::string name;
  std::vector<std::string> arguments;
  std::vector<Files> outputs;  ///< those that get their names together, and then others
  /// False if it uses libraries that may wait for ever when there is no memory.
  bool survives_without_memory = true;
};

const std::vector<Command>& commands() {
  static const std::vector<Command> all = {
      {"mesh",
       {"mesh", "key.poly", "-o", "out.vtu", "--threads", "2", "--json", "out.json"},
       {{"out.vtu"}, {"out.json"}}},
      {"mesh_and_check",
       {"mesh", "key.poly", "-o", "out.node", "--max-area", "0.0001", "--threads", "2", "--check"},
       {{"out.node", "out.ele", "out.poly"}}},
      {"refine", {"mesh", "--refine", "key.off", "-o", "out.vtu", "--max-area", "0.005"}, {{"out.vtu"}}},
      {"triangle", {"triangle", "-pqa0.01", "key.poly"}, {{"key.1.node", "key.1.ele", "key.1.poly"}}},
      {"check", {"check", "key.poly", "key.off", "--json", "out.json"}, {{"out.json"}}},
      {"convert", {"convert", "key.off", "out.msh"}, {{"out.msh"}}},
      {"draw", {"draw", "key.off", "-o", "out.svg"}, {{"out.svg"}}, false},  // fontconfig
      {"refuse", {"mesh", "bow.poly", "-o", "out.vtu", "--json", "out.json"}, {{"out.vtu"}, {"out.json"}}},
      {"doctor", {"doctor", "bow.poly", "--repair", "out.poly"}, {{"out.poly"}}}};
  return all;
}

struct Fault {
  std::string kind;
  std::uint64_t number;  ///< of the call that fails; 0: none
  bool and_later;

  [[nodiscard]] std::string text() const { return kind + ":" + std::to_string(number) + (and_later ? "+" : ""); }
};

class FailingCalls : public Workshop, public ::testing::WithParamInterface<std::string> {
 protected:
  FailingCalls() {
    pardel({"generate", "key", "-o", "key.poly"});
    pardel({"mesh", "key.poly", "-o", "key.off", "--max-area", "0.01"});
    write("bow.poly", "4 2 0 0\n0 0 0\n1 1 1\n2 0 1\n3 1 0\n2 0\n0 0 1\n1 2 3\n0\n");
    inputs_ = files();
  }

  struct End {
    Ran ran;
    std::map<std::string, std::string> outputs;
  };

  End run_with(const Command& command, const Fault& fault) const {
    for (const std::string& file : files())
      if (!inputs_.contains(file)) fs::remove(folder_ / "work" / file);
    for (const Files& together : command.outputs)
      for (const std::string& file : together) write(file, old_text);
    // A run takes 10 ms; one that waits forever is killed, which is exit code 137.
    std::vector<std::string> arguments = {"--signal=KILL",
                                          "30",
                                          "env",
                                          "LD_PRELOAD=" PARDEL_FAILING_CALLS,
                                          "PARDEL_FAULT=" + fault.text(),
                                          "PARDEL_CALLS=" + (folder_ / "calls").string(),
                                          PARDEL_PROGRAM};
    arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
    End end{run("timeout", arguments), {}};
    for (const std::string& file : files())
      if (!inputs_.contains(file)) end.outputs[file] = read(file);
    return end;
  }

  [[nodiscard]] std::uint64_t number_of_calls() const {
    std::uint64_t number = 0;
    std::ifstream(folder_ / "calls") >> number;
    return number;
  }

  static bool is_complete(const std::string& file, const std::string& text, const std::string& expected) {
    if (text == old_text) return true;
    return file.ends_with(".json") ? nlohmann::json::accept(text) : text == expected;  // reports have times
  }

  static void expect_clean_end(const Command& command, End end, const End& normal) {
    if (end.ran.exit_code == 5) {
      EXPECT_TRUE(holds(end.ran.err, {"pardel: "}));
    } else {
      EXPECT_EQ(end.ran.exit_code, normal.ran.exit_code) << end.ran;
    }
    for (const auto& [file, text] : end.outputs) {
      ASSERT_TRUE(normal.outputs.contains(file)) << file << " remains\n" << end.ran;
      EXPECT_TRUE(is_complete(file, text, normal.outputs.at(file))) << file << '\n' << end.ran;
      if (end.ran.exit_code == 5) continue;
      EXPECT_EQ(text == old_text, normal.outputs.at(file) == old_text) << file << '\n' << end.ran;
    }
    EXPECT_EQ(end.outputs.size(), normal.outputs.size()) << end.ran;
    for (const Files& together : command.outputs) {
      std::size_t old = 0;
      for (const std::string& file : together) old += end.outputs[file] == old_text ? 1 : 0;
      EXPECT_TRUE(old == 0 || old == together.size()) << *together.begin() << " and others are mixed\n" << end.ran;
    }
  }

  Files inputs_;
};

TEST_P(FailingCalls, end_the_command_or_change_nothing) {
  if (sanitized) GTEST_SKIP() << "a sanitizer replaces the same functions";
  constexpr std::uint64_t usual = 20;
  std::uint64_t all_calls = 0, runs = 0;
  for (const Command& command : commands()) {
    if (GetParam() == "memory" && !command.survives_without_memory) continue;
    const End normal = run_with(command, {GetParam(), 0, false});
    ASSERT_TRUE(normal.ran.exit_code == 0 || normal.ran.exit_code == 3) << normal.ran;
    const std::uint64_t calls = number_of_calls();
    all_calls += calls;
    std::vector<std::uint64_t> numbers = selection(calls, usual);
    // While files get their names, there are few calls, and their number depends on the folder.
    constexpr std::uint64_t at_the_end = 64;
    if (GetParam() == "memory" && command.name == "convert")
      for (std::uint64_t last = std::min(calls, at_the_end); last > 0; --last) numbers.push_back(calls - last + 1);
    for (const std::uint64_t number : numbers)
      for (const bool and_later : {false, true}) {
        const Fault fault{GetParam(), number, and_later};
        SCOPED_TRACE(command.name + ", PARDEL_FAULT=" + fault.text());
        expect_clean_end(command, run_with(command, fault), normal);
        ++runs;
        if (HasFailure()) return;
      }
  }
  EXPECT_GT(all_calls, 0U);
  std::cout << GetParam() << ": " << all_calls << " calls; " << runs
            << " runs in which one call failed, or all from one on\n";
}

INSTANTIATE_TEST_SUITE_P(Of, FailingCalls,
                         ::testing::Values("memory", "map", "open", "unnamed", "read", "write", "short", "sync",
                                           "close", "rename", "link", "thread"),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace pardel::testing
