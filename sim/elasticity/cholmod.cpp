#include "sim/elasticity/cholmod.hpp"

#include "base/machine/shared_library.hpp"

namespace palpate::sim {
namespace {

Cholmod load() {
  const base::SharedLibrary library("libcholmod.so.3", "libcholmod3", "no body can be condensed");
  Cholmod loaded;
  library.find("cholmod_l_start", loaded.start);
  library.find("cholmod_l_finish", loaded.finish);
  library.find("cholmod_l_analyze", loaded.analyze);
  library.find("cholmod_l_factorize", loaded.factorize);
  library.find("cholmod_l_solve", loaded.solve);
  library.find("cholmod_l_free_factor", loaded.free_factor);
  library.find("cholmod_l_free_dense", loaded.free_dense);
  return loaded;
}

}  // namespace

const Cholmod& cholmod() {
  static const Cholmod loaded = load();
  return loaded;
}

}  // namespace palpate::sim
