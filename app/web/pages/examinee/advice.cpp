#include "app/web/pages/examinee/advice.hpp"

#include <fmt/format.h>

namespace palpate::app {
namespace {

std::string times(int count) {
  return count == 1 ? "once" : fmt::format("{} times", count);
}

}  // namespace

std::string advice(trials::Verdict verdict, const trials::Exploration& rule) {
  switch (verdict) {
    case trials::Verdict::TooFewPresses:
      return fmt::format("This turn needs a press that goes in and out, at least {}.",
                         times(rule.least_presses));
    case trials::Verdict::TooManyPresses:
      return fmt::format("In this turn you may press at most {}.", times(rule.most_presses));
    case trials::Verdict::TooShallow:
      return "Please press a little deeper.";
    case trials::Verdict::Enough:
    case trials::Verdict::Interrupted:
      return {};
  }
  return {};
}

}  // namespace palpate::app
