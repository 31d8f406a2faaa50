// Questions to other ranks, each of which has the same number of values as its answer.
#pragma once

#include <utility>
#include <vector>

#include "exchange_lists.hpp"
#include "message.hpp"

namespace pardel {

/// Collective. Asks rank whom(i) questions[i]. Returns the answers in the order of the questions, one after the other.
/// On the rank that is asked, answer(questions) returns `per_question` values for each question of one rank.
template <class Value, class Question, class Whom, class Answer>
[[nodiscard]] std::vector<Value> answers_of_ranks(const std::vector<Question>& questions, std::size_t per_question,
                                                  Ranks& ranks, const Whom& whom, const Answer& answer) {
  std::vector<std::vector<Question>> asked(static_cast<std::size_t>(ranks.count()));
  for (std::size_t i = 0; i < questions.size(); ++i) asked[whom(i)].push_back(questions[i]);
  asked = exchange_lists(std::move(asked), ranks);
  std::vector<std::vector<Value>> answers(asked.size());
  for (std::size_t rank = 0; rank < asked.size(); ++rank) answers[rank] = answer(std::exchange(asked[rank], {}));
  answers = exchange_lists(std::move(answers), ranks);
  std::vector<Value> all;
  all.reserve(per_question * questions.size());
  std::vector<std::size_t> used(answers.size(), 0);
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto rank = static_cast<std::size_t>(whom(i));
    const auto next = answers[rank].begin() + static_cast<std::ptrdiff_t>(used[rank]);
    used[rank] += per_question;
    if (used[rank] > answers[rank].size()) throw Reader::does_not_match();
    all.insert(all.end(), next, next + static_cast<std::ptrdiff_t>(per_question));
  }
  for (std::size_t rank = 0; rank < answers.size(); ++rank)
    if (used[rank] != answers[rank].size()) throw Reader::does_not_match();
  return all;
}

}  // namespace pardel
