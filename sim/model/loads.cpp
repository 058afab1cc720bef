#include "sim/model/loads.hpp"

namespace palpate::sim {

Eigen::VectorXf deform(const Model& model, int body, const Loads& loads) {
  const Eigen::VectorXd unit_loads = loads.on_body[body] / model.bodies[body].young_modulus;
  return model.bodies[body].compliance->drawn_touch * unit_loads.cast<float>();
}

}  // namespace palpate::sim
