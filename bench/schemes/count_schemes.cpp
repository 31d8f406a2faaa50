// count_schemes: runs one scheme of the literature on one input with simulated workers, and prints what it costs as
// JSON, one line per number of workers. Nothing is timed. bench/strategies runs it on all inputs. See --help.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "../../ref/schemes/all_schemes.hpp"
#include "quality.hpp"

namespace pardel::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  std::string scheme, input = "square";
  double triangles = 1e4;
  std::vector<int> workers = {1};
  std::uint64_t seed = 1;
  bool list = false;
};

Json quality(const schemes::LinkedMesh& mesh, const SchemeInput& input, bool refines) {
  const SchemeQuality q = scheme_quality(mesh, input, refines);
  return {{"triangles", q.triangles}, {"smallest_angle", q.smallest_angle}, {"certified", q.certified}};
}

Json costs(const schemes::Account& a) {
  return {{"insertions", a.insertions},
          {"sequential", a.sequential},
          {"work", a.work},
          {"wasted", a.wasted},
          {"critical", a.critical},
          {"before", a.before},
          {"parallelism", schemes::parallelism(a)},
          {"rounds", a.rounds},
          {"barriers", a.barriers},
          {"set_backs", a.set_backs},
          {"messages", a.messages},
          {"bytes", a.bytes},
          {"most_held", a.most_held}};
}

void print_list() {
  Json names = Json::array();
  for (const schemes::Scheme& each : schemes::all_schemes())
    names.push_back({{"name", each.name}, {"title", each.title}, {"refines", each.refines}});
  std::printf("%s\n", Json{{"schemes", names}, {"inputs", scheme_inputs()}}.dump().c_str());
}

int run(const Settings& settings) {
  if (settings.list) {
    print_list();
    return 0;
  }
  const auto fail = [](const std::string& message) {
    std::fprintf(stderr, "count_schemes: %s\n", message.c_str());
    return 2;
  };
  const auto& all = schemes::all_schemes();
  const auto scheme = std::ranges::find(all, settings.scheme, &schemes::Scheme::name);
  if (scheme == all.end()) return fail("there is no scheme \"" + settings.scheme + "\"");
  const Result<SchemeInput> input = scheme_input(settings.input, settings.triangles, scheme->refines);
  if (!input) return fail(input.error().message);
  const auto outcomes = scheme->run({input->pslg, input->goal, 1, settings.seed}, settings.workers);
  Json mesh;
  for (std::size_t k = 0; k < settings.workers.size(); ++k) {
    Json line{{"scheme", settings.scheme},
              {"refines", scheme->refines},
              {"input", settings.input},
              {"size", settings.triangles},
              {"workers", settings.workers[k]}};
    if (!outcomes) {
      line["error"] = outcomes.error().message;
    } else {
      const schemes::Outcome& outcome = (*outcomes)[k];
      if (!outcome.mesh.faces.empty()) mesh = quality(outcome.mesh, *input, scheme->refines);
      line.update(mesh);
      line.update(costs(outcome.account));
    }
    std::printf("%s\n", line.dump().c_str());
  }
  return 0;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  CLI::App app("Counts what a parallel scheme costs on simulated workers.");
  pardel::bench::Settings settings;
  app.add_option("--scheme", settings.scheme, "the name of the scheme, as --list prints it");
  app.add_option("--input", settings.input, "the name of the input");
  app.add_option("--triangles", settings.triangles, "about how many triangles the mesh has")
      ->check(CLI::Range(1e2, 1e8))
      ->check([](const std::string& text) { return text.find("nan") == std::string::npos ? "" : "not a number"; });
  app.add_option("--workers", settings.workers, "one or more numbers of workers")->check(CLI::Range(1, 1 << 20));
  app.add_option("--seed", settings.seed, "of what a scheme draws at random");
  app.add_flag("--list", settings.list, "prints the names of schemes and inputs");
  CLI11_PARSE(app, argc, argv);
  return pardel::bench::run(settings);
}
