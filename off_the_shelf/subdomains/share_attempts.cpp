#include "share_attempts.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include "../../core/support/collective.hpp"
#include "../../core/support/message.hpp"

namespace pardel::engine {
namespace {

/// The numbers of an attempt.
struct Numbers {
  Point breach_at;
  double extraction_seconds, mesher_seconds, verification_seconds;
  std::uint16_t has_answer, has_breach, breach_kind, at_limit;
};

Numbers numbers_of(const Attempt& attempt) {
  const Breach breach = attempt.breach.value_or(Breach{});
  const auto number = [](bool value) { return static_cast<std::uint16_t>(value); };
  return {breach.where,
          attempt.extraction_seconds,
          attempt.mesher_seconds,
          attempt.verification_seconds,
          number(attempt.answer.has_value()),
          number(attempt.breach.has_value()),
          static_cast<std::uint16_t>(breach.kind),
          number(attempt.at_limit)};
}

void write(const Attempt& attempt, Writer& writer) {
  writer.list_of<Numbers>(1, [&](std::size_t) { return numbers_of(attempt); });
  if (attempt.breach) writer.list(std::span<const char>(attempt.breach->what));
  if (!attempt.answer) return;
  const VerifiedSubdomain& answer = *attempt.answer;
  writer.list(answer.points);
  writer.list(answer.edge_of_new_point);
  writer.list(answer.triangles);
  writer.list(answer.across);
  writer.list(answer.on_edge);
}

void read(Reader& reader, Attempt& attempt) {
  const std::vector<Numbers> numbers = reader.list<Numbers>();
  if (numbers.size() != 1 || numbers[0].breach_kind >= breach_kinds) throw Reader::does_not_match();
  const Numbers& n = numbers[0];
  attempt.extraction_seconds = n.extraction_seconds;
  attempt.mesher_seconds = n.mesher_seconds;
  attempt.verification_seconds = n.verification_seconds;
  attempt.at_limit = n.at_limit != 0;
  if (n.has_breach != 0) {
    const std::vector<char> what = reader.list<char>();
    attempt.breach = Breach{static_cast<BreachKind>(n.breach_kind), n.breach_at, std::string(what.begin(), what.end())};
  }
  if (n.has_answer == 0) return;
  VerifiedSubdomain& answer = attempt.answer.emplace();
  answer.points = reader.list<Point>();
  answer.edge_of_new_point = reader.list<Index>();
  answer.triangles = reader.list<std::array<Index, 3>>();
  answer.across = reader.list<Index>();
  answer.on_edge = reader.list<Index>();
}

}  // namespace

void share_attempts(std::span<Attempt> attempts, Ranks& ranks) {
  const auto count = static_cast<std::size_t>(ranks.count());
  Writer writer;
  for (std::size_t i = 0; i < attempts.size(); ++i)
    if (does_task(i, ranks)) write(attempts[i], writer);
  const std::vector<Ranks::Bytes> messages = from_all(writer.take(), ranks);
  for (std::size_t rank = 0; rank < count; ++rank) {
    if (rank == static_cast<std::size_t>(ranks.rank())) continue;
    Reader reader(messages[rank]);
    for (std::size_t i = rank; i < attempts.size(); i += count) read(reader, attempts[i]);
    if (!reader.empty()) throw Reader::does_not_match();
  }
}

}  // namespace pardel::engine
