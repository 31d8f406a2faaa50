#include "record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

namespace pardel::fuzz {
namespace {

constexpr std::array verdicts{"right", "wrong", "crash", "time_out"};
/// The end of a line, so that a line that was not written completely is noticed.
constexpr std::string_view end_mark = " .";

struct Summary {
  explicit Summary(const std::vector<Record>& records, std::size_t slowest_count) {
    for (const Record& record : records) {
      ++of_verdict[static_cast<std::size_t>(record.verdict)];
      seconds += record.seconds;
      triangles += record.triangles;
      listed += record.listed;
      std::istringstream kinds(record.kinds);
      for (std::string kind; std::getline(kinds, kind, ',');) ++of_kind[kind];
      if (record.verdict != Record::Verdict::right) faults.push_back(&record);
      slowest.push_back(&record);
    }
    std::ranges::sort(faults, {}, &Record::number);
    const auto kept = std::min(slowest_count, slowest.size());
    std::ranges::partial_sort(slowest, slowest.begin() + static_cast<std::ptrdiff_t>(kept),
                              [](const Record* a, const Record* b) {
                                return a->seconds > b->seconds || (a->seconds == b->seconds && a->number < b->number);
                              });
    slowest.resize(kept);
  }

  std::array<std::uint64_t, verdicts.size()> of_verdict{};
  double seconds = 0;
  std::uint64_t triangles = 0, listed = 0;
  std::map<std::string, std::uint64_t> of_kind;
  std::vector<const Record*> faults, slowest;
};

std::string replay_of(const Record& record, const std::string& replay) {
  return fmt::format("{} --first {} --cases 1", replay, record.number);
}

}  // namespace

const char* name(Record::Verdict verdict) { return verdicts[static_cast<std::size_t>(verdict)]; }

std::string to_line(const Record& record) {
  std::string fault = record.fault;
  std::ranges::replace(fault, '\n', ' ');
  return fmt::format("{} {} {:.6f} {} {} {} {}{}", record.number, name(record.verdict), record.seconds,
                     record.triangles, record.listed, record.kinds, fault, end_mark);
}

std::optional<Record> to_record(std::string_view line) {
  if (!line.ends_with(end_mark)) return std::nullopt;
  std::istringstream in{std::string(line.substr(0, line.size() - end_mark.size()))};
  Record record;
  std::string verdict;
  if (!(in >> record.number >> verdict >> record.seconds >> record.triangles >> record.listed >> record.kinds))
    return std::nullopt;
  const auto found = std::ranges::find(verdicts, verdict);
  if (found == verdicts.end()) return std::nullopt;
  record.verdict = static_cast<Record::Verdict>(found - verdicts.begin());
  std::getline(in >> std::ws, record.fault);
  return record;
}

std::string summary_text(const std::vector<Record>& records, std::size_t slowest, const std::string& replay) {
  const Summary summary(records, slowest);
  std::string text =
      fmt::format("{} cases, {} triangles in {:.1f} s of processor time; {} of them miss a bound, as the reports say\n",
                  records.size(), summary.triangles, summary.seconds, summary.listed);
  text += fmt::format("violations {}, crashes {}, time-outs {}\n", summary.of_verdict[1], summary.of_verdict[2],
                      summary.of_verdict[3]);
  text += "how many cases have a property (a case has several):\n";
  for (const auto& [kind, count] : summary.of_kind) text += fmt::format("  {:<20}{:>10}\n", kind, count);
  text += "slowest:\n";
  for (const Record* each : summary.slowest)
    text += fmt::format("  case {}: {:.3f} s, {} triangles, {}\n", each->number, each->seconds, each->triangles,
                        each->kinds);
  for (const Record* each : summary.faults)
    text += fmt::format("{} in case {} ({}): {}\n  {}\n", name(each->verdict), each->number, each->kinds, each->fault,
                        replay_of(*each, replay));
  return text;
}

std::string summary_json(const std::vector<Record>& records, std::size_t slowest, const std::string& replay) {
  const Summary summary(records, slowest);
  const auto describe = [&](const std::vector<const Record*>& chosen) {
    nlohmann::json list = nlohmann::json::array();
    for (const Record* each : chosen)
      list.push_back({{"case", each->number},
                      {"verdict", name(each->verdict)},
                      {"seconds", each->seconds},
                      {"triangles", each->triangles},
                      {"kinds", each->kinds},
                      {"fault", each->fault},
                      {"replay", replay_of(*each, replay)}});
    return list;
  };
  const nlohmann::json json{{"cases", records.size()},
                            {"violations", summary.of_verdict[1]},
                            {"crashes", summary.of_verdict[2]},
                            {"time_outs", summary.of_verdict[3]},
                            {"seconds", summary.seconds},
                            {"triangles", summary.triangles},
                            {"listed", summary.listed},
                            {"kinds", summary.of_kind},
                            {"slowest", describe(summary.slowest)},
                            {"faults", describe(summary.faults)}};
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

}  // namespace pardel::fuzz
