#include "sim/contact/exact/contact_system.hpp"

#include <algorithm>
#include <vector>

#include "sim/contact/exact/coupling.hpp"
#include "sim/probe/probes.hpp"

namespace palpate::sim {
double opened_by(const FacingPair& pair, int body, const Eigen::Ref<const Eigen::VectorXd>& motion) {
  return pair.normal.dot(relative_motion(pair, body, motion));
}

namespace {

std::vector<Eigen::Index> first_rows_of_probes(const Model& model) {
  std::vector<Eigen::Index> first{0};
  for (const Probe& probe : model.probes) first.push_back(first.back() + probe.axes.cols());
  return first;
}

/// What the nodes of a probe measure of a motion of its body's touchable nodes along its axes.
double measured(const Probe& probe, std::span<const double> weights, Eigen::Index axis,
                const Eigen::Ref<const Eigen::VectorXd>& motion) {
  double sum = 0.0;
  for (std::size_t i = 0; i < probe.nodes.size(); ++i)
    sum += weights[i] * probe.axes.col(axis).dot(motion.segment<3>(3 * probe.nodes[i]));
  return sum;
}

/// A contact's row with those of the probes, and what it takes off the regions.
void fill_with_probes(const Model& model, const ProbeRows& probes, const FacingPair& pair, Eigen::Index row,
                      ContactSystem& system) {
  for (std::size_t p = 0; p < model.probes.size(); ++p) {
    const Probe& probe = model.probes[p];
    if (probe.axes.cols() == 0 || (probe.body != pair.node_body && probe.body != pair.polygon_body)) continue;
    const Eigen::MatrixXd& compliance = compliance_of(probe, probes[p]);
    for (Eigen::Index axis = 0; axis < probe.axes.cols(); ++axis) {
      const Eigen::Index column = system.first_of_probe[p] + axis;
      system.compliance(row, column) = system.compliance(column, row) =
          opened_by(pair, probe.body, compliance.col(axis)) / model.bodies[probe.body].young_modulus;
    }
  }
  for (RegionPull& pull : system.regions) {
    const Probe& probe = model.probes[pull.probe];
    if (probe.tip) {
      const bool its_own = pair.polygon_body == kRigid && pair.touch_pair == pull.probe;
      pull.rows.row(row) =
          its_own ? Eigen::RowVector3d(pair.normal.transpose()) : Eigen::RowVector3d::Zero().eval();
      continue;
    }
    for (Eigen::Index component = 0; component < 3; ++component)
      pull.rows(row, component) = opened_by(pair, probe.body, probe.region->touch_motion.col(component));
  }
}

}  // namespace

void write_between_probes(const Model& model, const ProbeRows& probes, Eigen::MatrixXd& compliance) {
  const auto first_row = [&](int probe) {
    Eigen::Index row = 0;
    for (int before = 0; before < probe; ++before) row += model.probes[before].axes.cols();
    return row;
  };
  for (const Body& body : model.bodies)
    for (const int pressing : body.probes)
      for (Eigen::Index from = 0; from < model.probes[pressing].axes.cols(); ++from) {
        const auto motion = compliance_of(model.probes[pressing], probes[pressing]).col(from);
        for (const int measuring : body.probes)
          for (Eigen::Index to = 0; to < model.probes[measuring].axes.cols(); ++to)
            compliance(first_row(measuring) + to, first_row(pressing) + from) =
                measured(model.probes[measuring], weights_of(model.probes[measuring], probes[measuring]), to,
                         motion) /
                body.young_modulus;
      }
}

void fill_probes(const Model& model, const ProbeRows& probes, ContactSystem& system) {
  write_between_probes(model, probes, system.compliance);
  for (RegionPull& region : system.regions) {
    if (!model.probes[region.probe].region) continue;
    for (const int other : model.bodies[model.probes[region.probe].body].probes)
      for (Eigen::Index axis = 0; axis < model.probes[other].axes.cols(); ++axis)
        for (Eigen::Index component = 0; component < 3; ++component)
          region.rows(system.first_of_probe[other] + axis, component) =
              measured(model.probes[other], weights_of(model.probes[other], probes[other]), axis,
                       model.probes[region.probe].region->touch_motion.col(component));
  }
}

ContactSystem empty_system(const Model& model, std::size_t contacts) {
  ContactSystem system{.first_of_probe = first_rows_of_probes(model)};
  system.bilateral = system.first_of_probe.back();
  const Eigen::Index size = system.bilateral + static_cast<Eigen::Index>(contacts);
  system.compliance.setZero(size, size);
  for (int p = 0; p < std::ssize(model.probes); ++p)
    if (model.probes[p].region || model.probes[p].tip)
      system.regions.push_back({p, Eigen::MatrixXd::Zero(size, 3)});
  fill_probes(model, probe_rows(model), system);
  return system;
}

void fill_contacts(const Model& model, const ProbeRows& probes, std::span<const Eigen::Matrix3d> turns,
                   std::span<const FacingPair> pairs, std::span<const int> which, std::span<const int> with,
                   PushResponse& response, ContactSystem& system) {
  for (const int i : which) {
    const Eigen::Index row = system.bilateral + i;
    fill_with_probes(model, probes, pairs[i], row, system);
    respond(model, turns, pairs[i], response);
    for (const int j : with) {
      if (j < i && std::ranges::binary_search(which, j)) continue;  // both are of `which`: once is enough
      const Eigen::Index column = system.bilateral + j;
      system.compliance(row, column) = system.compliance(column, row) =
          pairs[j].normal.dot(coupling(turns, pairs[j], response) * pairs[i].normal);
    }
  }
}

}  // namespace palpate::sim
