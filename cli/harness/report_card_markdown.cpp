// The report card as Markdown.
#include <fmt/format.h>

#include "../../core/support/shell_words.hpp"
#include "report_card.hpp"

namespace pardel::harness {
namespace {

constexpr std::size_t longest_cell = 140;

/// The message as a cell of a table: shortened, and without bars, which would end the cell. The JSON report has the
/// full text.
std::string cell(const FailureKind& kind) {
  std::string text = kind.message;
  if (text.starts_with(kind.kind + ": ")) text.erase(0, kind.kind.size() + 2);
  if (text.size() > longest_cell) text.replace(longest_cell, std::string::npos, "...");
  return replaced(text, "|", "\\|");
}

std::string row(const std::string& title, const Counts& counts) {
  std::uint64_t all = 0;
  std::string cells;
  for (const std::uint64_t n : counts) {
    all += n;
    cells += fmt::format(" {} |", n);
  }
  return fmt::format("| {} | {} |{}\n", title, all, cells);
}

std::string families_table(const ReportCard& card) {
  std::string head = "| family | cases |", rule = "|---|---:|";
  for (std::size_t v = 0; v < verdict_count; ++v) {
    head += fmt::format(" {} |", name(static_cast<Verdict>(v)));
    rule += "---:|";
  }
  std::string table = head + '\n' + rule + '\n';
  for (const FamilyRow& family : card.families) table += row(name(family.family), family.counts);
  return table + row("**all**", card.counts);
}

std::string smallest_text(const FailureKind& kind) {
  if (!kind.smallest) return {};
  const SmallestFailure& s = *kind.smallest;
  const std::string holes = s.holes == 0 ? "" : fmt::format(", {} hole{}", s.holes, s.holes == 1 ? "" : "s");
  return fmt::format("; at its smallest {} points, {} segments{}: `{}`", s.points, s.segments, holes, s.poly.string());
}

std::string kinds_table(const ReportCard& card) {
  std::string table = "| verdict | kind | cases | first | there |\n|---|---|---:|---|---|\n";
  for (const FailureKind& kind : card.kinds) {
    table += fmt::format("| {} | {} | {} | {} | {}{} |\n", name(kind.verdict), kind.kind, kind.cases,
                         to_string(card.cases[kind.first]), cell(kind), smallest_text(kind));
  }
  return table;
}

}  // namespace

std::string to_markdown(const ReportCard& card) {
  std::string text = fmt::format("### {} of {} valid\n\n`{}`\n\n{}. {}. Seed {}.\n\n{}",
                                 card.counts[static_cast<std::size_t>(Verdict::valid)], card.outcomes.size(),
                                 card.mesher, card.goal, card.limits, card.seed, families_table(card));
  if (all_valid(card)) return text;
  return text +
         fmt::format(
             "\nmissed: a correct mesh that misses a bound, although no small input angle makes this unavoidable; "
             "wrong: not a correct mesh of the domain.\n\n{}\nTo repeat a case: `{} --replay CASE --keep "
             "FOLDER`\n",
             kinds_table(card), card.replay);
}

}  // namespace pardel::harness
