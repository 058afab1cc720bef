#include "tests/analysis/mixed/support/data_sets.hpp"

#include <string>

namespace palpate::analysis {

std::vector<LevelAnswers> pleuropneumonia() {
  return {{"1", 1, 2, 14},  {"1", 2, 3, 12},  {"1", 3, 4, 9},   {"1", 4, 0, 5},    {"2", 1, 3, 22},
          {"2", 2, 1, 18},  {"2", 3, 1, 21},  {"3", 1, 8, 22},  {"3", 2, 2, 16},   {"3", 3, 0, 16},
          {"3", 4, 2, 20},  {"4", 1, 2, 10},  {"4", 2, 0, 10},  {"4", 3, 2, 9},    {"4", 4, 0, 6},
          {"5", 1, 5, 18},  {"5", 2, 0, 25},  {"5", 3, 0, 24},  {"5", 4, 1, 4},    {"6", 1, 3, 17},
          {"6", 2, 0, 17},  {"6", 3, 0, 18},  {"6", 4, 1, 20},  {"7", 1, 8, 16},   {"7", 2, 1, 10},
          {"7", 3, 3, 9},   {"7", 4, 0, 5},   {"8", 1, 12, 34}, {"9", 1, 2, 9},    {"9", 2, 0, 6},
          {"9", 3, 0, 8},   {"9", 4, 0, 6},   {"10", 1, 1, 22}, {"10", 2, 1, 22},  {"10", 3, 0, 18},
          {"10", 4, 2, 22}, {"11", 1, 0, 25}, {"11", 2, 5, 27}, {"11", 3, 3, 22},  {"11", 4, 1, 22},
          {"12", 1, 2, 10}, {"12", 2, 1, 8},  {"12", 3, 0, 6},  {"12", 4, 0, 5},   {"13", 1, 1, 21},
          {"13", 2, 2, 24}, {"13", 3, 0, 19}, {"13", 4, 0, 23}, {"14", 1, 11, 19}, {"14", 2, 0, 2},
          {"14", 3, 0, 3},  {"14", 4, 0, 2},  {"15", 1, 1, 19}, {"15", 2, 1, 15},  {"15", 3, 1, 15},
          {"15", 4, 0, 15}};
}

std::vector<LevelAnswers> eight_examinees() {
  const long ones[8][7] = {{3, 2, 5, 7, 9, 8, 10}, {0, 2, 0, 4, 7, 7, 9},  {2, 4, 6, 7, 10, 10, 10},
                           {1, 0, 2, 0, 6, 9, 10}, {0, 0, 5, 2, 4, 10, 8}, {0, 0, 3, 9, 9, 10, 10},
                           {1, 0, 1, 2, 3, 3, 3},  {1, 0, 5, 5, 7, 9, 9}};
  std::vector<LevelAnswers> answers;
  for (int examinee = 0; examinee < 8; ++examinee) {
    for (int k = 0; k < 7; ++k) {
      answers.push_back({std::to_string(examinee + 1), k - 3.0, ones[examinee][k], 10});
    }
  }
  return answers;
}

std::vector<LevelAnswers> four_alike() {
  const long ones[4][4] = {{1, 4, 6, 9}, {2, 3, 7, 9}, {1, 3, 7, 8}, {1, 4, 6, 9}};
  std::vector<LevelAnswers> answers;
  for (int examinee = 0; examinee < 4; ++examinee) {
    for (int k = 0; k < 4; ++k) answers.push_back({std::to_string(examinee), k + 1.0, ones[examinee][k], 10});
  }
  return answers;
}

}  // namespace palpate::analysis
