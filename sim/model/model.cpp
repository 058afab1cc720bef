#include "sim/model/model.hpp"

namespace palpate::sim {

Model without_contact(Model model) {
  model.pairs.clear();
  return model;
}

}  // namespace palpate::sim
