#include "sim/cycle/region_force.hpp"

#include <Eigen/Geometry>

namespace palpate::sim {

void add_region_force(const Model& model, int index, Response& response) {
  const Probe& probe = model.probes[index];
  const Body& body = model.bodies[probe.body];
  const Eigen::VectorXd& loads = response.loads.on_body[probe.body];
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  if (probe.region->carries) {
    const Eigen::Matrix3d turn = rotation_of(response.loads.held[index]);
    for (Eigen::Index node = 0; node < body.rest.cols(); ++node) {
      const Vec3 load = loads.segment<3>(3 * node);
      force -= load;
      torque -= (turn * (body.rest.col(node) - probe.at)).cross(load);
    }
  } else {
    const RegionMotion work = probe.region->touch_motion.transpose() * loads;
    force -= work.head<3>();
    const Eigen::Matrix3d arms = work.tail<9>().reshaped(3, 3);  // sum of load times r^T
    torque -= Vec3(arms(2, 1) - arms(1, 2), arms(0, 2) - arms(2, 0), arms(1, 0) - arms(0, 1));
    std::size_t mine = 0;
    for (const int other : body.probes) {
      if (other == index) break;
      mine += model.probes[other].region ? 1 : 0;
    }
    for (const int other : body.probes) {
      if (!model.probes[other].region) continue;
      const Eigen::Vector<double, 6> taken =
          body.young_modulus * (model.probes[other].region->reactions[mine] * response.loads.held[other]);
      force += taken.head<3>();
      torque += taken.tail<3>();
    }
  }
  response.probe_forces[index] += force;
  response.probe_torques[index] += torque;
}

}  // namespace palpate::sim
