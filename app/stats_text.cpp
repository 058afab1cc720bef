#include "app/stats_text.hpp"

#include <fmt/core.h>

#include "analysis/words.hpp"

namespace palpate::app {

using namespace analysis;

namespace {

std::string source_line(const Method& method) {
  return fmt::format("Method: {} ({}).\n", method.name, method.source);
}

std::string p_line(const PValues& p, Side side) {
  return fmt::format("{} (side {}; greater {}, less {}, two-sided {})\n", p_in_words(p.of(side)),
                     name_of(side), number(p.greater), number(p.less), number(p.two_sided));
}

std::string bound_line(const BinomialTest& test) {
  if (test.side == Side::TwoSided) return "";
  const bool greater = test.side == Side::Greater;
  return fmt::format("One-sided {} bound that belongs to the test: {} {}\n", short_percent(test.bound.level),
                     greater ? "at least" : "at most",
                     percent(greater ? test.bound.lower : test.bound.upper));
}

}  // namespace

std::string in_words(const BinomialTest& test) {
  return fmt::format("{} of {} correct: {}\n", test.correct, test.trials, percent(test.proportion)) +
         fmt::format("Against chance {}: ", chance_in_words(test.chance)) + p_line(test.p, test.side) +
         fmt::format("{} interval: {} (Clopper-Pearson, exact), {} (Wilson)\n",
                     short_percent(test.interval.level), percent_range(test.interval),
                     percent_range(test.wilson)) +
         bound_line(test) + source_line(test.method);
}

std::string in_words(const CriticalNumber& critical) {
  std::string text;
  if (critical.at_least) text += fmt::format("{} or more of {} correct", *critical.at_least, critical.trials);
  if (critical.at_most) {
    text += fmt::format("{}{} or fewer of {} correct", text.empty() ? "" : ", or ", *critical.at_most,
                        critical.trials);
  }
  if (text.empty()) {
    return fmt::format(
        "No number of correct answers in {} rejects chance {} at alpha {} (side {}): there are too "
        "few trials.\n",
        counted(critical.trials, "trial", "trials"), chance_in_words(critical.chance), critical.alpha,
        name_of(critical.side));
  }
  return fmt::format("{} rejects chance {} at alpha {} (side {}).\n", text, chance_in_words(critical.chance),
                     critical.alpha, name_of(critical.side)) +
         fmt::format("Actual size: guessing is rejected with probability {}.\n", number(critical.size)) +
         source_line(critical.method);
}

std::string in_words(const DPrime& d_prime) {
  const double observed = static_cast<double>(d_prime.correct) / static_cast<double>(d_prime.trials);
  return fmt::format("{} of {} correct: {}\n", d_prime.correct, d_prime.trials, percent(observed)) +
         (d_prime.corrected ? fmt::format("Corrected to {} ({}).\n", percent(d_prime.proportion),
                                          name_of(d_prime.correction))
                            : "") +
         fmt::format("d' = {} (standard error {})\n{} interval: {} ({})\n", number(d_prime.d_prime),
                     number(d_prime.standard_error), short_percent(d_prime.interval.level),
                     range(d_prime.interval), d_prime.interval.method) +
         source_line(d_prime.method);
}

std::string in_words(const McNemarTest& test) {
  const PairedTable& table = test.table;
  return fmt::format("{} of {} discordant; the first alone is correct in {}, the second alone in {}\n",
                     test.discordant, counted(test.pairs, "pair", "pairs"), table.first_only,
                     table.second_only) +
         "Exact:      " + p_line(test.exact, Side::TwoSided) +
         "Mid-p:      " + p_line(test.mid_p, Side::TwoSided) +
         fmt::format(
             "Asymptotic: chi-squared = {}, 1 degree of freedom, {}; with continuity correction {}, {}\n",
             number(test.chi_squared), p_in_words(test.p_asymptotic), number(test.chi_squared_corrected),
             p_in_words(test.p_asymptotic_corrected)) +
         fmt::format("Difference of proportions: {}, {} interval {} ({})\n", number(test.difference),
                     short_percent(test.difference_interval.level), range(test.difference_interval),
                     test.difference_interval.method) +
         fmt::format("Odds ratio (conditional): {}, {} interval {} ({})\n", number(test.odds_ratio),
                     short_percent(test.odds_ratio_interval.level), range(test.odds_ratio_interval),
                     test.odds_ratio_interval.method) +
         source_line(test.method);
}

std::string in_words(const SignTest& test, Side side) {
  return fmt::format("{}: {} positive, {} negative, {} zero\n",
                     counted(static_cast<long>(test.n), "difference", "differences"), test.positive,
                     test.negative, test.zeros) +
         p_line(test.p, side) +
         fmt::format("Median {}, {} interval {} ({})\n", number(test.median),
                     short_percent(test.interval.level), range(test.interval), test.interval.method) +
         source_line(test.method);
}

std::string in_words(const SignedRankTest& test, Side side) {
  return fmt::format("{}, {} of them zero{}; V = {} of {}\n",
                     counted(static_cast<long>(test.n), "difference", "differences"), test.zeros,
                     test.ties ? ", with ties" : "", number(test.v), number(test.v_max)) +
         p_line(test.p, side) +
         fmt::format("Pseudo-median {}, {} interval {} ({})\nEffect size (rank-biserial correlation): {}\n",
                     number(test.pseudo_median), short_percent(test.interval.level), range(test.interval),
                     test.interval.method, number(test.rank_biserial)) +
         source_line(test.method);
}

std::string in_words(const SignFlipTest& test, Side side) {
  return fmt::format("{}, mean {}\n", counted(static_cast<long>(test.n), "difference", "differences"),
                     number(test.mean)) +
         p_line(test.p, side) +
         fmt::format("{} interval for the mean: {} ({})\n", short_percent(test.interval.level),
                     range(test.interval), test.interval.method) +
         source_line(test.method);
}

}  // namespace palpate::app
