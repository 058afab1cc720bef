#pragma once

#include <string>

#include "analysis/statistics/binomial_test.hpp"
#include "analysis/statistics/critical_number.hpp"
#include "analysis/statistics/dprime.hpp"
#include "analysis/statistics/mcnemar.hpp"
#include "analysis/statistics/sign_flip.hpp"
#include "analysis/statistics/sign_test.hpp"
#include "analysis/statistics/signed_rank.hpp"

namespace palpate::app {

// Results for a terminal: a few lines each, every line a whole thought.

std::string in_words(const analysis::BinomialTest& test);
std::string in_words(const analysis::CriticalNumber& critical);
std::string in_words(const analysis::DPrime& d_prime);
std::string in_words(const analysis::McNemarTest& test);
std::string in_words(const analysis::SignTest& test, analysis::Side side);
std::string in_words(const analysis::SignedRankTest& test, analysis::Side side);
std::string in_words(const analysis::SignFlipTest& test, analysis::Side side);

}  // namespace palpate::app
