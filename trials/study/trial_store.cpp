#include "trials/study/trial_store.hpp"

#include <algorithm>

#include "trials/study/named.hpp"

namespace palpate::trials {

void TrialStore::add(const DrawnTrial& drawn) {
  const Trial& trial = drawn.trial;
  std::string order;
  for (const std::size_t condition : trial.interval_condition)
    order += (order.empty() ? "" : ",") + design_.conditions.at(condition).name;
  Query(database_,
        "INSERT INTO trial (session, number, draw, block, cell, interval_order, correct_interval) "
        "VALUES (?, ?, ?, ?, ?, ?, ?)",
        drawn.session, trial.number, drawn.draw, trial.block, design_.cells.at(trial.cell).name, order,
        trial.correct_answer)
      .run();
}

std::vector<DrawnTrial> TrialStore::of_session(std::int64_t session) const {
  constexpr std::string_view kTrial = "a trial";
  std::vector<DrawnTrial> trials;
  Query rows(
      database_,
      "SELECT number, draw, block, cell, interval_order, correct_interval FROM trial WHERE session = ? "
      "ORDER BY number, draw",
      session);
  while (rows.next()) {
    DrawnTrial drawn{.session = session, .draw = rows.number(1)};
    drawn.trial.number = rows.number(0);
    drawn.trial.block = rows.number(2);
    drawn.trial.cell = index_of(design_.cells, rows.text(3), kTrial);
    drawn.trial.correct_answer = rows.number(5);
    const std::string order = rows.text(4);
    for (std::size_t at = 0; at <= order.size();) {
      const std::size_t comma = std::min(order.find(',', at), order.size());
      drawn.trial.interval_condition.push_back(
          index_of(design_.conditions, order.substr(at, comma - at), kTrial));
      at = comma + 1;
    }
    trials.push_back(std::move(drawn));
  }
  return trials;
}

}  // namespace palpate::trials
