#include "analysis/statistics/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "analysis/statistics/adjust/description.hpp"
#include "analysis/statistics/bayes/description.hpp"
#include "analysis/statistics/beta_binomial/description.hpp"
#include "analysis/statistics/binomial/description.hpp"
#include "analysis/statistics/bradley_terry/description.hpp"
#include "analysis/statistics/cochran/description.hpp"
#include "analysis/statistics/critical/description.hpp"
#include "analysis/statistics/dprime/description.hpp"
#include "analysis/statistics/examinee_level/description.hpp"
#include "analysis/statistics/friedman/description.hpp"
#include "analysis/statistics/glmm/description.hpp"
#include "analysis/statistics/interval_bias/description.hpp"
#include "analysis/statistics/looks/description.hpp"
#include "analysis/statistics/mcnemar/description.hpp"
#include "analysis/statistics/permutation/description.hpp"
#include "analysis/statistics/power/description.hpp"
#include "analysis/statistics/psychometric/description.hpp"
#include "analysis/statistics/psychometric_bayes/description.hpp"
#include "analysis/statistics/psychometric_compare/description.hpp"
#include "analysis/statistics/randomisation/description.hpp"
#include "analysis/statistics/same_different/description.hpp"
#include "analysis/statistics/sign/description.hpp"
#include "analysis/statistics/similarity/description.hpp"
#include "analysis/statistics/stevens/description.hpp"
#include "analysis/statistics/ttest/description.hpp"
#include "analysis/statistics/wilcoxon/description.hpp"
#include "analysis/statistics/yes_no/description.hpp"
#include "analysis/words/words.hpp"

namespace palpate::analysis {

const std::vector<Statistic>& statistics() {
  static const std::vector<Statistic> all = {
      adjust_statistic(),                //
      bayes_statistic(),                 //
      beta_binomial_statistic(),         //
      binomial_statistic(),              //
      bradley_terry_statistic(),         //
      cochran_statistic(),               //
      critical_statistic(),              //
      dprime_statistic(),                //
      examinee_level_statistic(),        //
      friedman_statistic(),              //
      glmm_statistic(),                  //
      interval_bias_statistic(),         //
      looks_statistic(),                 //
      mcnemar_statistic(),               //
      permutation_statistic(),           //
      power_statistic(),                 //
      psychometric_statistic(),          //
      psychometric_bayes_statistic(),    //
      psychometric_compare_statistic(),  //
      randomisation_statistic(),         //
      same_different_statistic(),        //
      sign_statistic(),                  //
      similarity_statistic(),            //
      stevens_statistic(),               //
      ttest_statistic(),                 //
      wilcoxon_statistic(),              //
      yes_no_statistic(),                //
  };
  return all;
}

const Statistic& statistic_named(std::string_view name) {
  const std::vector<Statistic>& all = statistics();
  const auto found = std::ranges::find(all, name, &Statistic::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Statistic& one : all) names.push_back(one.name);
  throw std::invalid_argument(fmt::format("there is no statistic '{}'; accepted: {}", name, listed(names)));
}

}  // namespace palpate::analysis
