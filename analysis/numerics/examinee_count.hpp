#pragma once

namespace palpate::analysis {

/// The answers of one examinee under one cell.
struct ExamineeCount {
  long correct = 0;
  long trials = 0;
};

}  // namespace palpate::analysis
