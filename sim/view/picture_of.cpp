#include "sim/view/picture_of.hpp"

#include <array>
#include <cassert>

namespace palpate::sim {
namespace {

// What is felt through, what is felt for, and others: told apart by lightness as well as by hue.
constexpr std::array<Colour, 5> kTissues = {{{0.93F, 0.53F, 0.47F},
                                             {0.87F, 0.68F, 0.43F},
                                             {0.55F, 0.66F, 0.80F},
                                             {0.62F, 0.72F, 0.50F},
                                             {0.70F, 0.56F, 0.74F}}};
constexpr Colour kSteel{0.62F, 0.66F, 0.71F};
constexpr Colour kSkin{0.91F, 0.74F, 0.64F};
constexpr float kTranslucent = 0.28F;

DrawnBody drawn_body(const Model& model, int index, const Loads& loads) {
  const Body& body = model.bodies[index];
  DrawnBody drawn{.name = body.name, .triangles = body.surface->triangles, .behind = body.surface->behind};
  drawn.positions.resize(3, static_cast<Eigen::Index>(body.mesh->nodes.size()));
  Eigen::Index node = 0;
  for (const Vec3& rest : body.mesh->nodes) drawn.positions.col(node++) = rest.cast<float>();
  const Eigen::VectorXf u = deform(model, index, loads);
  Eigen::Index entry = 0;
  for (const int moved : body.compliance->drawn) {
    drawn.positions.col(moved) += u.segment<3>(entry);
    entry += 3;
  }
  for (const int probe : body.probes)
    if (const auto& region = model.probes[probe].region)
      for (const int moved : region->nodes)
        drawn.positions.col(moved) +=
            (motion_at(body.mesh->nodes[moved] - model.probes[probe].at) * loads.held[probe]).cast<float>();
  drawn.colour = kTissues[index % std::ssize(kTissues)];
  drawn.opacity = !body.probes.empty() && model.bodies.size() > 1 ? kTranslucent : 1.0F;
  return drawn;
}

}  // namespace

Picture picture_of(const Model& model, const Stage& stage, const Loads& loads, ProbeDisplacements probes) {
  assert(probes.size() == model.probes.size() && stage.probes.size() == model.probes.size());
  Picture picture{.camera = stage.camera, .scale_bar = stage.scale_bar};
  for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body)
    picture.bodies.push_back(drawn_body(model, body, loads));
  for (std::size_t i = 0; i < model.probes.size(); ++i) {
    const Probe& probe = model.probes[i];
    if (probe.region) continue;  // what it holds is seen to move
    const ProbeShape& shape = stage.probes[i];
    picture.probes.push_back(
        {.touch = (probe.slide.knots.empty() ? probe.at : probe.slide.start) + probes[i].from_rest,
         .direction = probe.direction,
         .shaft = shape.shaft,
         .radius = shape.radius,
         .length = shape.length,
         .colour = probe.nodes.size() == 1 ? kSteel : kSkin});
  }
  return picture;
}

}  // namespace palpate::sim
