#include "analysis/procedures/all.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/words.hpp"

namespace palpate::analysis {

const std::vector<Procedure>& procedures() {
  static const std::vector<Procedure> all = {
      adjust_procedure(),                //
      bayes_procedure(),                 //
      beta_binomial_procedure(),         //
      binomial_procedure(),              //
      bradley_terry_procedure(),         //
      cochran_procedure(),               //
      critical_procedure(),              //
      dprime_procedure(),                //
      examinee_level_procedure(),        //
      friedman_procedure(),              //
      glmm_procedure(),                  //
      interval_bias_procedure(),         //
      looks_procedure(),                 //
      mcnemar_procedure(),               //
      permutation_procedure(),           //
      power_procedure(),                 //
      psychometric_procedure(),          //
      psychometric_bayes_procedure(),    //
      psychometric_compare_procedure(),  //
      randomisation_procedure(),         //
      same_different_procedure(),        //
      sign_procedure(),                  //
      similarity_procedure(),            //
      stevens_procedure(),               //
      ttest_procedure(),                 //
      wilcoxon_procedure(),              //
      yes_no_procedure(),                //
  };
  return all;
}

const Procedure& procedure_named(std::string_view name) {
  const std::vector<Procedure>& all = procedures();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Procedure& one) { return one.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Procedure& one : all) names.push_back(one.name);
  throw std::invalid_argument("there is no procedure '" + std::string(name) +
                              "'; accepted: " + listed(names));
}

}  // namespace palpate::analysis
