#pragma once

#include <vector>

#include "trials/study/connection.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

class AnswerStore {
 public:
  explicit AnswerStore(SQLite::Database& database) : database_(database) {}
  void add(std::int64_t entry, const AnswerRow& answer);
  std::vector<AnswerRow> of_session(std::int64_t session) const;

 private:
  SQLite::Database& database_;
};

}  // namespace palpate::trials
