#pragma once

#include "trials/study/connection.hpp"
#include "trials/study/rows.hpp"

namespace palpate::trials {

/// The one study of a file, with the files that it was run on.
class StudyStore {
 public:
  explicit StudyStore(SQLite::Database& database) : database_(database) {}
  void add(const StudyRow& study);
  StudyRow get() const;

 private:
  SQLite::Database& database_;
};

}  // namespace palpate::trials
