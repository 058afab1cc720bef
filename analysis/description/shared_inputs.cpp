#include "analysis/description/statistic.hpp"

namespace palpate::analysis {

using Kind = Input::Kind;

Input correct_input() {
  return {.name = "correct", .kind = Kind::Count, .meaning = "Correct answers"};
}

Input trials_input() {
  return {.name = "trials", .kind = Kind::Count, .meaning = "All answers"};
}

Input chance_input() {
  return {
      .name = "chance", .kind = Kind::Fraction, .meaning = "Probability of a correct guess", .usual = "1/2"};
}

Input alpha_input() {
  return {.name = "alpha",
          .kind = Kind::Fraction,
          .meaning = "Largest probability of rejecting what is only guessing",
          .usual = "0.05"};
}

Input side_input(const std::string& usual) {
  return {.name = "side",
          .kind = Kind::Choice,
          .meaning = "Alternative, decided beforehand",
          .usual = usual,
          .choices = {"greater", "less", "two-sided"}};
}

Input level_input() {
  return {.name = "level", .kind = Kind::Fraction, .meaning = "Confidence of the intervals", .usual = "0.95"};
}

Input seed_input() {
  return {.name = "seed", .kind = Kind::Seed, .meaning = "Of the random numbers", .usual = "1"};
}

Data difference_data(const std::string& what) {
  return {.shape = Data::Shape::Columns,
          .meaning = "one difference a row, an examinee each",
          .columns = {{.name = "difference", .meaning = what}}};
}

}  // namespace palpate::analysis
