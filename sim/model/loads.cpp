#include "sim/model/loads.hpp"

#include "sim/elasticity/static_solve.hpp"
#include "sim/elasticity/stiffness.hpp"

namespace palpate::sim {

Eigen::VectorXf deform(const Model& model, int body, const Loads& loads) {
  const Eigen::VectorXd unit_loads = loads.on_body[body] / model.bodies[body].young_modulus;
  return model.bodies[body].compliance->drawn_touch * unit_loads.cast<float>();
}

std::vector<WholeBody> whole_bodies(const Model& model, const Loads& loads) {
  std::vector<WholeBody> bodies;
  bodies.reserve(model.bodies.size());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    WholeBody& whole = bodies.emplace_back();
    whole.force = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
    Eigen::Index entry = 0;
    for (const int node : body.compliance->touch) {
      whole.force.col(node) = loads.on_body[i].segment<3>(entry);
      entry += 3;
    }
    whole.displacement = static_solve(stiffness(*body.mesh, body.materials), body.fixed, whole.force);
  }
  return bodies;
}

}  // namespace palpate::sim
