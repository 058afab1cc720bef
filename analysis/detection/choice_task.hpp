#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace palpate::analysis {

/// What one answer of a choice task is about. Every alternative is equally likely to be the correct one.
enum class ChoiceKind {
  TwoInterval,     // 2IFC: one of two intervals holds the stronger stimulus
  TwoAlternative,  // 2AFC: the same in space instead of time
  Alternatives,    // m-AFC: one of m holds the stronger stimulus
  Triangle,        // three samples, two of them alike: the one that differs most from the others is named
  Oddity,          // three intervals, two of them alike: the odd one is named, by a stated strategy
  Abx              // two reference stimuli, then one of them again: which?, by a stated strategy
};

/// How an observer makes an answer out of what was felt, where a task leaves that open.
enum class Strategy {
  Differencing,            // distances between the observations of a trial: the rule when stimuli rove
  IndependentObservations  // each against what the stimuli are known to feel like: the best where they stay
};

/// "differencing" or "independent-observations"; anything else is a std::invalid_argument.
Strategy strategy_from_name(std::string_view name);
std::string_view name_of(Strategy strategy);

struct ChoiceTask {
  ChoiceKind kind = ChoiceKind::TwoInterval;
  int alternatives = 2;                // of an answer: 3 for triangle and oddity; free for m-AFC only
  std::optional<Strategy> strategy{};  // of oddity and ABX; empty for the others
};

/// From the task's name ("2IFC", "2AFC", "m-AFC", "triangle", "oddity", "ABX") and what was given with it.
/// m-AFC needs `alternatives` from 2 to 1000, oddity and ABX need a strategy; the others refuse both. Throws
/// std::invalid_argument.
ChoiceTask choice_task(std::string_view name, std::optional<long> alternatives,
                       std::optional<Strategy> strategy);
std::string name_of(const ChoiceTask& task);

/// Probability of a correct guess, 1/alternatives.
double chance_of(const ChoiceTask& task);

/// Proportion correct of an unbiased observer with sensitivity d', with Gaussian noise of unit variance:
///   2IFC, 2AFC  Φ(d'/√2)                                                    [HackerRatcliff1979]
///   m-AFC       ∫ φ(x − d') Φ(x)^(m−1) dx                                   [HackerRatcliff1979]
///   triangle    2 ∫₀^∞ [Φ(−x√3 + d'√(2/3)) + Φ(−x√3 − d'√(2/3))] φ(x) dx    [Ennis1993]
///   oddity      differencing as the triangle; independent observations: the likeliest odd one
///               [Versfeld1996]
///   ABX         Φ(d'/√2) Φ(d'/s) + Φ(−d'/√2) Φ(−d'/s), s = √6 for differencing, 2 for independent
///               observations [MacmillanCreelman2005] ch. 9
/// Triangle, oddity and ABX don't know a direction: they give the same for d' and −d'.
double proportion_correct(const ChoiceTask& task, double d_prime);

/// The d' at which a proportion is expected: ±infinity for 1 and 0. Where a task knows no direction,
/// proportions at chance and below give 0.
double d_prime_at(const ChoiceTask& task, double proportion);

/// Slope of proportion_correct over d'.
double slope_at(const ChoiceTask& task, double d_prime);

/// Whether the task can tell d' from −d': 2IFC, 2AFC, m-AFC.
bool knows_direction(const ChoiceTask& task);

}  // namespace palpate::analysis
