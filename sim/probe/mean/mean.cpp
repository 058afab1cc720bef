#include "sim/probe/mean/mean.hpp"

namespace palpate::sim {

void prescribe_mean(const Probe& probe, const ProbeDisplacement& displacement, ProbeRow& row) {
  row.pressing = displacement.from_rest.dot(probe.direction) > 0.0;
  row.value.setZero();
  for (Eigen::Index k = 0; k < probe.axes.cols(); ++k)
    row.value[k] = probe.axes.col(k).dot(displacement.from_rest);
}

}  // namespace palpate::sim
