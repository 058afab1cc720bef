#include "analysis/report/study_table.hpp"

namespace palpate::analysis {

bool came_before(const ChainPlace& a, const std::string& a_utc, const ChainPlace& b,
                 const std::string& b_utc) {
  const bool in_one = a.chain == b.chain && a.entry > 0 && b.entry > 0;
  return in_one ? a.entry < b.entry : a_utc < b_utc;  // ISO 8601 sorts by time
}

}  // namespace palpate::analysis
