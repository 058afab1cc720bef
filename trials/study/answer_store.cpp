#include "trials/study/answer_store.hpp"

namespace palpate::trials {

void AnswerStore::add(std::int64_t entry, const AnswerRow& answer) {
  Query(database_,
        "INSERT INTO answer (entry, session, trial, draw, response, correct, response_time_s, onset_utc, "
        "committed_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
        entry, answer.session, answer.trial, answer.draw, answer.response, answer.correct,
        answer.response_time, answer.onset_utc, answer.committed_utc)
      .run();
}

std::vector<AnswerRow> AnswerStore::of_session(std::int64_t session) const {
  std::vector<AnswerRow> answers;
  Query rows(
      database_,
      "SELECT entry, trial, draw, response, correct, response_time_s, onset_utc, committed_utc FROM answer "
      "WHERE session = ? ORDER BY trial",
      session);
  while (rows.next())
    answers.push_back({.entry = rows.integer(0),
                       .session = session,
                       .trial = rows.number(1),
                       .draw = rows.number(2),
                       .response = rows.number(3),
                       .correct = rows.number(4) != 0,
                       .response_time = rows.optional_real(5),
                       .onset_utc = rows.text(6),
                       .committed_utc = rows.text(7)});
  return answers;
}

}  // namespace palpate::trials
