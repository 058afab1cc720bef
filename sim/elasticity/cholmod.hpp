#pragma once

#include <cholmod.h>

namespace palpate::sim {

/// What is called of CHOLMOD, its long interface. It and the BLAS below it take longer to load than most commands
/// run, and few condense a body: so it is loaded when the first body is.
struct Cholmod {
  decltype(&::cholmod_l_start) start = nullptr;
  decltype(&::cholmod_l_finish) finish = nullptr;
  decltype(&::cholmod_l_analyze) analyze = nullptr;
  decltype(&::cholmod_l_factorize) factorize = nullptr;
  decltype(&::cholmod_l_solve) solve = nullptr;
  decltype(&::cholmod_l_free_factor) free_factor = nullptr;
  decltype(&::cholmod_l_free_dense) free_dense = nullptr;
};

/// Loaded at the first call, and kept. Throws std::runtime_error that names the package where it cannot be had.
const Cholmod& cholmod();

}  // namespace palpate::sim
