#include "analysis/procedures/all.hpp"

#include <algorithm>
#include <stdexcept>

#include "analysis/words.hpp"

namespace palpate::analysis {

const std::vector<Procedure>& procedures() {
  static const std::vector<Procedure> all = {
      beta_binomial_procedure(),   //
      binomial_procedure(),        //
      bradley_terry_procedure(),   //
      critical_procedure(),        //
      dprime_procedure(),          //
      examinee_level_procedure(),  //
      glmm_procedure(),            //
      mcnemar_procedure(),         //
      permutation_procedure(),     //
      sign_procedure(),            //
      stevens_procedure(),         //
      wilcoxon_procedure(),        //
  };
  return all;
}

const Procedure& procedure_named(std::string_view name) {
  const std::vector<Procedure>& all = procedures();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Procedure& one) { return one.name == name; });
  if (found != all.end()) return *found;
  std::vector<std::string> names;
  for (const Procedure& one : all) names.push_back(one.name);
  throw std::invalid_argument("there is no procedure '" + std::string(name) +
                              "'; accepted: " + listed(names));
}

}  // namespace palpate::analysis
