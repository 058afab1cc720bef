#include "tasks/two_interval/two_interval.hpp"

#include <array>

#include "analysis/detection/dprime.hpp"

namespace palpate::tasks {
namespace {

constexpr std::array<std::string_view, 2> kFirstKeys{"1", "ArrowLeft"};
constexpr std::array<std::string_view, 2> kSecondKeys{"2", "ArrowRight"};
constexpr std::array<trials::Choice, 2> kChoices{
    {{.label = "First turn", .keys = kFirstKeys}, {.label = "Second turn", .keys = kSecondKeys}}};

double d_prime(long correct, long trials) {
  return analysis::dprime_2ifc(correct, trials, analysis::DPrimeCorrection::None).d_prime;
}

}  // namespace

constexpr trials::Task kTwoInterval{
    .name = "2IFC",
    .intervals = 2,
    // Orders are independent coins, or nobody is told whether an answer was right: whatever came before, the
    // next answer is a fair guess.
    .chance = 0.5,
    .choices = kChoices,
    .answer_is = "the number of an interval",
    .hint = "Press 1 or 2, the arrow keys ← →, or click.",
    .spoken_hint = "Press 1 for the first turn, 2 for the second.",
    .meaning =
        "two-interval forced choice: two conditions, one after the other; which interval held the one asked "
        "for?",
    .keys = two_interval::kKeys,
    .order_keys = two_interval::kOrderKeys,
    .read = two_interval::read,
    .read_order = two_interval::read_order,
    .check_primary = two_interval::check_primary,
    .draw = two_interval::draw,
    .redraw = two_interval::redraw,
    .correct_answer = two_interval::correct_answer,
    .decide = two_interval::decide,
    .d_prime = d_prime,
    .question_in_words = two_interval::question_in_words,
    .order_in_words = two_interval::order_in_words,
    .course_in_words = two_interval::course_in_words,
    .task_means = two_interval::task_means,
    .correct_answer_means = two_interval::correct_answer_means,
    .response_means = "Number of the interval that was chosen"};

}  // namespace palpate::tasks
