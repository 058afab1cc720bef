#pragma once

#include "analysis/procedures/procedure.hpp"

namespace palpate::analysis {

// One function for each file of this folder that describes a procedure; all.cpp lists them by name.

Procedure adjust_procedure();
Procedure bayes_procedure();
Procedure beta_binomial_procedure();
Procedure binomial_procedure();
Procedure bradley_terry_procedure();
Procedure cochran_procedure();
Procedure critical_procedure();
Procedure dprime_procedure();
Procedure examinee_level_procedure();
Procedure friedman_procedure();
Procedure glmm_procedure();
Procedure interval_bias_procedure();
Procedure looks_procedure();
Procedure mcnemar_procedure();
Procedure permutation_procedure();
Procedure power_procedure();
Procedure psychometric_procedure();
Procedure psychometric_bayes_procedure();
Procedure psychometric_compare_procedure();
Procedure randomisation_procedure();
Procedure same_different_procedure();
Procedure sign_procedure();
Procedure similarity_procedure();
Procedure stevens_procedure();
Procedure ttest_procedure();
Procedure wilcoxon_procedure();
Procedure yes_no_procedure();

}  // namespace palpate::analysis
