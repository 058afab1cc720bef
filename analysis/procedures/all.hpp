#pragma once

#include "analysis/procedures/procedure.hpp"

namespace palpate::analysis {

// One function for each file of this folder that describes a procedure; all.cpp lists them by name.

Procedure beta_binomial_procedure();
Procedure binomial_procedure();
Procedure bradley_terry_procedure();
Procedure critical_procedure();
Procedure dprime_procedure();
Procedure examinee_level_procedure();
Procedure glmm_procedure();
Procedure mcnemar_procedure();
Procedure permutation_procedure();
Procedure sign_procedure();
Procedure stevens_procedure();
Procedure wilcoxon_procedure();

}  // namespace palpate::analysis
