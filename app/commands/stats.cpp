#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/statistics/to_json.hpp"
#include "app/commands/commands.hpp"
#include "app/number_column.hpp"
#include "app/output.hpp"
#include "app/parse_number.hpp"
#include "app/stats_text.hpp"

namespace palpate::app {
namespace {

using namespace analysis;

// What any of the procedures may be asked; each adds the options that it takes.
struct Options {
  long correct = 0, trials = 0;
  std::string chance = "1/2", alpha = "0.05", level = "0.95";
  std::string side = "two-sided";
  std::string correction = "half-trial", zeros = "pratt", table;
  std::string file;
  std::uint64_t seed = SignFlipOptions{}.seed;
  long resamples = SignFlipOptions{}.resamples;
  std::string format;
};

void print(const Options& options, const std::string& text, nlohmann::ordered_json json) {
  if (options.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}", text);
  }
}

// Tests of one column give three p values; the asked one stands first, as "p".
void print_sided(const Options& options, const std::string& text, nlohmann::ordered_json json) {
  json["side"] = options.side;
  json["p"] = json["p_values"][options.side == "two-sided" ? "two_sided" : options.side];
  print(options, text, std::move(json));
}

void add_side(CLI::App& command, Options& options, const std::string& usual) {
  options.side = usual;
  command.add_option("--side", options.side, "Alternative, decided beforehand: greater, less or two-sided")
      ->check(CLI::IsMember({"greater", "less", "two-sided"}))
      ->capture_default_str();
}

void add_level(CLI::App& command, Options& options) {
  command.add_option("--level", options.level, "Confidence of the intervals")->capture_default_str();
}

void add_counts(CLI::App& command, Options& options) {
  command.add_option("--correct", options.correct, "Correct answers")->required();
  command.add_option("--trials", options.trials, "All answers")->required();
}

void add_file(CLI::App& command, Options& options) {
  command.add_option("FILE", options.file, "CSV file with one difference on each line; a header is allowed")
      ->required();
}

void add_chance(CLI::App& command, Options& options) {
  command.add_option("--chance", options.chance, "Probability of a correct guess, as 1/2 or 0.5")
      ->capture_default_str();
}

using Setup = std::function<void(CLI::App&, Options&)>;
using Run = std::function<void(const Options&)>;

void add(CLI::App& stats, const std::string& name, const std::string& what, const std::string& teaches,
         const Setup& setup, const Run& run) {
  CLI::App* command = stats.add_subcommand(name, what);
  command->footer(teaches);
  const auto options = std::make_shared<Options>();
  setup(*command, *options);
  add_format(*command, options->format);
  command->callback([options, run] { run(*options); });
}

void add_binomial(CLI::App& stats) {
  add(
      stats, "binomial", "Are more answers correct than guessing gives? (exact binomial test)",
      "Tests that every answer is correct with the probability of a guess. It asks for answers that are\n"
      "independent when nobody feels anything: orders drawn by fair coins make them so. Two-sided p values "
      "add\n"
      "up all outcomes that are no likelier than the one seen, as R's binom.test does.\n\n"
      "Example: 41 of 60 answers in a two-interval task\n"
      "  palpate stats binomial --correct 41 --trials 60 --chance 1/2 --side greater\n",
      [](CLI::App& command, Options& options) {
        add_counts(command, options);
        add_chance(command, options);
        add_side(command, options, "greater");
        add_level(command, options);
      },
      [](const Options& options) {
        const BinomialTest test =
            binomial_test(options.correct, options.trials, parse_fraction("--chance", options.chance),
                          side_from_name(options.side), parse_fraction("--level", options.level));
        print(options, in_words(test), to_json(test));
      });
}

void add_critical(CLI::App& stats) {
  add(
      stats, "critical", "How many correct answers are needed? (critical number of the binomial test)",
      "The smallest number of correct answers that guessing reaches with a probability of at most alpha, and "
      "how\n"
      "large that probability really is.\n\n"
      "Example: Kuroda et al. 2003, 60 answers per model: 37\n"
      "  palpate stats critical --trials 60 --chance 1/2 --alpha 0.05 --side greater\n",
      [](CLI::App& command, Options& options) {
        command.add_option("--trials", options.trials, "All answers")->required();
        add_chance(command, options);
        command
            .add_option("--alpha", options.alpha, "Largest probability of rejecting what is only guessing")
            ->capture_default_str();
        add_side(command, options, "greater");
      },
      [](const Options& options) {
        const CriticalNumber critical =
            critical_number(options.trials, parse_fraction("--chance", options.chance),
                            parse_fraction("--alpha", options.alpha), side_from_name(options.side));
        print(options, in_words(critical), to_json(critical));
      });
}

void add_mcnemar(CLI::App& stats) {
  add(
      stats, "mcnemar", "Is one of two answers to the same trials correct more often? (McNemar's test)",
      "The table counts pairs of answers to the same trials: both correct, the first only, the second only,\n"
      "neither. Only where the design pairs trials: two contact models that an examinee met on separate "
      "trials\n"
      "are compared by examinee (permutation, wilcoxon) instead.\n\n"
      "Example: Agresti, Categorical Data Analysis, section 10.1\n"
      "  palpate stats mcnemar --table 794,86,150,570\n",
      [](CLI::App& command, Options& options) {
        command.add_option("--table", options.table, "Counts: both,first only,second only,neither")
            ->required();
        add_level(command, options);
      },
      [](const Options& options) {
        const std::vector<long> counts = parse_counts("--table", options.table, 4);
        const McNemarTest test = mcnemar_test({counts[0], counts[1], counts[2], counts[3]},
                                              parse_fraction("--level", options.level));
        print(options, in_words(test), to_json(test));
      });
}

void add_sign(CLI::App& stats) {
  add(
      stats, "sign", "Are differences more often positive than negative? (sign test)",
      "Looks at nothing but the signs, so it asks for no more than independent differences. Zeros are left "
      "out.\n\n"
      "Example: one difference for each examinee, in a file of one column\n"
      "  palpate stats sign differences.csv --side greater\n",
      [](CLI::App& command, Options& options) {
        add_file(command, options);
        add_side(command, options, "two-sided");
        add_level(command, options);
      },
      [](const Options& options) {
        const SignTest test =
            sign_test(read_number_column(options.file), parse_fraction("--level", options.level));
        print_sided(options, in_words(test, side_from_name(options.side)), to_json(test));
      });
}

void add_wilcoxon(CLI::App& stats) {
  add(
      stats, "wilcoxon", "Are differences centred on zero? (Wilcoxon's signed-rank test)",
      "Ranks the differences by size and adds up the ranks of the positive ones. It asks for differences "
      "that are\n"
      "symmetric about zero when there is no effect. Exact with ties and zeros up to 500 differences.\n\n"
      "Example: number correct with one model less that with another, one line for each examinee\n"
      "  palpate stats wilcoxon differences.csv --zeros pratt\n",
      [](CLI::App& command, Options& options) {
        add_file(command, options);
        add_side(command, options, "two-sided");
        add_level(command, options);
        command
            .add_option("--zeros", options.zeros,
                        "Zeros: drop (Wilcoxon 1945), pratt (ranked, then left out)")
            ->check(CLI::IsMember({"drop", "pratt"}))
            ->capture_default_str();
      },
      [](const Options& options) {
        const SignedRankTest test =
            signed_rank_test(read_number_column(options.file), zeros_from_name(options.zeros),
                             parse_fraction("--level", options.level));
        print_sided(options, in_words(test, side_from_name(options.side)), to_json(test));
      });
}

void add_permutation(CLI::App& stats) {
  add(
      stats, "permutation", "Is the mean difference zero? (sign-flip permutation test)",
      "If the two things compared are exchangeable for each examinee, a difference has either sign with\n"
      "probability 1/2. The test counts the sign patterns whose sum is as extreme as the one seen: all of "
      "them\n"
      "where that can be done (up to 20 differences, or whole steps of a common unit), else a seeded "
      "sample.\n\n"
      "Example: one difference for each examinee, in a file of one column\n"
      "  palpate stats permutation differences.csv\n",
      [](CLI::App& command, Options& options) {
        add_file(command, options);
        add_side(command, options, "two-sided");
        add_level(command, options);
        command.add_option("--seed", options.seed, "Of the random sample of patterns")->capture_default_str();
        command.add_option("--resamples", options.resamples, "Its size")->capture_default_str();
      },
      [](const Options& options) {
        const SignFlipTest test = sign_flip_test(read_number_column(options.file),
                                                 {.level = parse_fraction("--level", options.level),
                                                  .resamples = options.resamples,
                                                  .seed = options.seed});
        print_sided(options, in_words(test, side_from_name(options.side)), to_json(test));
      });
}

void add_dprime(CLI::App& stats) {
  add(
      stats, "dprime", "How well are two stimuli told apart? (d' of a two-interval forced choice)",
      "d' = sqrt(2) z(proportion correct): the distance between the two stimuli in standard deviations of "
      "what\n"
      "one interval feels like, for an observer who prefers neither interval. At 0 and 100 % it would be "
      "infinite:\n"
      "half-trial puts 1/(2n) and 1 - 1/(2n) there (Macmillan & Kaplan 1985), log-linear always takes\n"
      "(k + 1/2)/(n + 1) (Hautus 1995), none leaves it.\n\n"
      "Example:\n"
      "  palpate stats dprime --correct 41 --trials 60\n",
      [](CLI::App& command, Options& options) {
        add_counts(command, options);
        command
            .add_option("--correction", options.correction, "At 0 and 100 %: half-trial, log-linear or none")
            ->check(CLI::IsMember({"half-trial", "log-linear", "none"}))
            ->capture_default_str();
        add_level(command, options);
      },
      [](const Options& options) {
        const DPrime d_prime =
            dprime_2ifc(options.correct, options.trials, correction_from_name(options.correction),
                        parse_fraction("--level", options.level));
        print(options, in_words(d_prime), to_json(d_prime));
      });
}

}  // namespace

void add_stats(CLI::App& app) {
  CLI::App* stats = app.add_subcommand("stats", "One statistical procedure on numbers or a CSV file");
  stats->footer(
      "Each procedure teaches when it applies: palpate stats binomial --help\n\n"
      "Example:\n"
      "  palpate stats binomial --correct 41 --trials 60 --chance 1/2 --side greater\n");
  stats->require_subcommand(1);
  add_binomial(*stats);
  add_critical(*stats);
  add_mcnemar(*stats);
  add_sign(*stats);
  add_wilcoxon(*stats);
  add_permutation(*stats);
  add_dprime(*stats);
}

}  // namespace palpate::app
