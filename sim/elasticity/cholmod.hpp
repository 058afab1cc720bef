#pragma once

#include <cholmod.h>

namespace palpate::sim {

// CHOLMOD and the BLAS below it take longer to load than most commands run, and few condense a body. So its
// functions are looked up when the first body is condensed, under their own names.

#define PALPATE_CHOLMOD_FUNCTIONS        \
  PALPATE_CHOLMOD(cholmod_l_analyze)     \
  PALPATE_CHOLMOD(cholmod_l_factorize)   \
  PALPATE_CHOLMOD(cholmod_l_finish)      \
  PALPATE_CHOLMOD(cholmod_l_free_dense)  \
  PALPATE_CHOLMOD(cholmod_l_free_factor) \
  PALPATE_CHOLMOD(cholmod_l_solve)       \
  PALPATE_CHOLMOD(cholmod_l_start)

// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared takes none
#define PALPATE_CHOLMOD(name) extern decltype(&::name) name;
PALPATE_CHOLMOD_FUNCTIONS
#undef PALPATE_CHOLMOD

/// Loads the library, once; before any of them is called. Throws std::runtime_error where it is not installed.
void load_cholmod();

}  // namespace palpate::sim
