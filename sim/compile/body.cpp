#include "sim/compile/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/compile/placed_mesh.hpp"
#include "sim/compile/region.hpp"
#include "sim/compile/selection.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/probe/probes.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr int kMostTouchableNodes = 1000;  // a dense factor over all of them takes 72 MB

std::vector<int> index_of_nodes(std::size_t nodes, const std::vector<int>& list) {
  std::vector<int> index(nodes, -1);
  for (int i = 0; i < std::ssize(list); ++i) index[list[i]] = i;
  return index;
}

/// The touched nodes in terms of touch indices, and what detection needs.
void add_polygons(Body& body, const std::vector<int>& colliding) {
  body.touch_of_node = index_of_nodes(body.mesh->nodes.size(), body.compliance->touch);
  std::vector<int> may_collide(body.mesh->nodes.size(), -1);
  for (const int node : colliding) may_collide[node] = body.touch_of_node[node];
  const auto touched = static_cast<int>(body.compliance->touch.size());
  body.rest.resize(3, touched);
  for (int i = 0; i < touched; ++i) body.rest.col(i) = body.mesh->nodes[body.compliance->touch[i]];
  body.polygons = make_touch_surface(body.surface->triangles, may_collide, touched);
  for (int i = 0; i < touched; ++i)
    if (body.polygons.incident_begin[i] < body.polygons.incident_begin[i + 1])
      body.colliding_nodes.push_back(i);
  body.tree = build_tree(body.polygons.triangles, body.rest);
}

void refuse_too_many(const BodySpec& spec, std::size_t touched) {
  if (touched > kMostTouchableNodes)
    refuse_key(fmt::format("bodies.{}.touchable", spec.name),
               fmt::format("{} nodes could be touched, accepted: at most {}; name a smaller group", touched,
                           kMostTouchableNodes));
}

/// A node can follow one probe only.
void refuse_shared_node(const ProbeSpec& spec, const Probe& probe, const std::vector<Probe>& others,
                        const TetMesh& mesh) {
  const auto nodes_of = [](const Probe& held) { return held.region ? held.region->nodes : held.nodes; };
  for (const Probe& other : others) {
    const std::vector<int> taken = nodes_of(other);
    for (const int node : nodes_of(probe))
      if (std::ranges::find(taken, node) != taken.end())
        refuse_key(
            "probes." + spec.name,
            fmt::format("holds node {} of {}, and so does probes.{}; accepted: probes apart from each other",
                        mesh.node_tags[node], spec.body, other.name));
  }
}

/// The nodes that a fingertip may meet as touch indices.
void finish_tip(const Body& body, Probe& probe) {
  Fingertip tip = *probe.tip;
  for (int& node : tip.nodes) node = body.touch_of_node[node];
  probe.tip = std::make_shared<const Fingertip>(std::move(tip));
}

/// What a probe is once its body is condensed; from here on its nodes are touch indices.
void finish_probe(const ProbeSpec& spec, const Body& body, Probe& probe) {
  probe.direction = spec.direction;
  probe.depth = spec.depth;
  probe.tangential = spec.tangential;
  if (probe.region) return;
  if (probe.tip) return finish_tip(body, probe);
  probe.axes = spec.tangential == Tangential::Held ? Eigen::Matrix3Xd(Eigen::Matrix3d::Identity())
                                                   : Eigen::Matrix3Xd(spec.direction);
  for (int& node : probe.nodes) node = body.touch_of_node[node];
  const Eigen::MatrixXd& compliance = body.compliance->touch_touch;
  const auto of = [&](const auto& weights) {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(compliance.rows(), probe.axes.cols());
    for (std::size_t i = 0; i < probe.nodes.size(); ++i)
      if (const double weight = weights[static_cast<Eigen::Index>(i)]; weight != 0.0)
        sum += weight * compliance.middleCols<3>(3 * probe.nodes[i]) * probe.axes;
    return sum;
  };
  probe.compliance = of(Eigen::VectorXd::Map(probe.weights.data(), std::ssize(probe.weights)));
  for (Knot& knot : probe.slide.knots) knot.compliance = of(knot.weights);
}

/// The compliance of the body at E = 1 Pa.
std::shared_ptr<const Compliance> unit_compliance(const BodySpec& spec, const Body& body,
                                                  const std::vector<int>& held,
                                                  const std::vector<int>& touched, ComplianceCache& cache) {
  std::vector<Material> unit = body.materials;
  for (Material& material : unit) material.young_modulus /= body.young_modulus;
  try {
    return cache.get(*body.mesh, unit, held, touched, without(body.surface->nodes, held), body.interior);
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}", spec.name), error.what());
  }
}

/// Whether a region is all that holds the body. Then it is also all that presses it: what a probe pressed would turn
/// with the body.
void find_out_who_is_alone(const BodySpec& spec, const Body& body, const std::vector<const ProbeSpec*>& specs,
                           std::vector<Probe>& probes) {
  const auto regions =
      std::ranges::count_if(probes, [](const Probe& probe) { return probe.region != nullptr; });
  for (std::size_t i = 0; i < probes.size(); ++i)
    if (probes[i].region && specs[i]->reach > 0.0 && (!body.fixed.empty() || regions > 1))
      refuse_key(fmt::format("probes.{}.reach", probes[i].name),
                 fmt::format(
                     "a region goes far only where it is all that holds its body, and {} has other supports; "
                     "accepted: the probe without reach, or the body without fixed",
                     spec.name));
  if (!body.fixed.empty() || regions > 1) return;
  if (regions == 0)
    refuse_key(
        fmt::format("bodies.{}", spec.name),
        "nothing holds it: fixed is missing, and no probe of kind \"region\" holds a part of it; accepted: either");
  if (probes.size() > 1)
    refuse_key(
        fmt::format("bodies.{}", spec.name),
        fmt::format("only the region that a probe moves holds it, and {} presses it, too; accepted: fixed "
                    "nodes, or no other probe on it",
                    std::ranges::find_if(probes, [](const Probe& probe) { return !probe.region; })->name));
  Region region = *probes.front().region;
  region.alone = true;
  region.carries = specs.front()->reach > 0.0;
  probes.front().region = std::make_shared<const Region>(std::move(region));
}

}  // namespace

CompiledBody compile_body(const BodySpec& spec, const std::vector<const ProbeSpec*>& probes,
                          ComplianceCache& cache) {
  CompiledBody compiled{
      .body = {.name = spec.name, .interior = spec.interior, .young_modulus = spec.material.young_modulus}};
  Body& body = compiled.body;
  body.mesh = std::make_shared<const TetMesh>(read_placed(spec));
  body.surface = std::make_shared<const Surface>(extract_surface(*body.mesh));
  body.materials = materials_of(spec, *body.mesh);
  if (spec.fixed) body.fixed = select(*body.mesh, *spec.fixed, fmt::format("bodies.{}.fixed", spec.name));
  std::vector<int> held = body.fixed, touched;
  for (const ProbeSpec* probe_spec : probes) {
    Probe probe{.name = probe_spec->name};
    place_probe(*probe_spec, *body.mesh, *body.surface, body.fixed, probe);
    refuse_shared_node(*probe_spec, probe, compiled.probes, *body.mesh);
    touched.insert(touched.end(), probe.nodes.begin(), probe.nodes.end());
    if (probe.tip) touched.insert(touched.end(), probe.tip->nodes.begin(), probe.tip->nodes.end());
    if (probe.region) held.insert(held.end(), probe.region->nodes.begin(), probe.region->nodes.end());
    compiled.probes.push_back(std::move(probe));
  }
  std::ranges::sort(held);
  find_out_who_is_alone(spec, body, probes, compiled.probes);
  const std::vector<int> colliding = colliding_nodes(spec, *body.mesh, *body.surface, held);
  touched.insert(touched.end(), colliding.begin(), colliding.end());
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  refuse_too_many(spec, touched.size());

  body.compliance = unit_compliance(spec, body, held, touched, cache);
  add_polygons(body, colliding);
  for (std::size_t i = 0; i < probes.size(); ++i) finish_probe(*probes[i], body, compiled.probes[i]);
  finish_regions(body, compiled.probes);
  return compiled;
}

}  // namespace palpate::sim
