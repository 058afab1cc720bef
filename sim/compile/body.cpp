#include "sim/compile/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/compile/placed_mesh.hpp"
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
  for (const Probe& other : others)
    for (const int node : probe.nodes)
      if (std::ranges::find(other.nodes, node) != other.nodes.end())
        refuse_key(
            "probes." + spec.name,
            fmt::format("holds node {} of {}, and so does probes.{}; accepted: probes apart from each other",
                        mesh.node_tags[node], spec.body, other.name));
}

/// What a probe is once its body is condensed; from here on its nodes are touch indices.
void finish_probe(const ProbeSpec& spec, const Body& body, Probe& probe) {
  probe.direction = spec.direction;
  probe.depth = spec.depth;
  probe.tangential = spec.tangential;
  probe.axes = spec.tangential == Tangential::Held ? Eigen::Matrix3Xd(Eigen::Matrix3d::Identity())
                                                   : Eigen::Matrix3Xd(spec.direction);
  for (int& node : probe.nodes) node = body.touch_of_node[node];
  const Eigen::MatrixXd& compliance = body.compliance->touch_touch;
  probe.compliance = Eigen::MatrixXd::Zero(compliance.rows(), probe.axes.cols());
  for (std::size_t i = 0; i < probe.nodes.size(); ++i)
    probe.compliance += probe.weights[i] * compliance.middleCols<3>(3 * probe.nodes[i]) * probe.axes;
}

/// The compliance of the body at E = 1 Pa.
std::shared_ptr<const Compliance> unit_compliance(const BodySpec& spec, const Body& body,
                                                  const std::vector<int>& touched, ComplianceCache& cache) {
  std::vector<Material> unit = body.materials;
  for (Material& material : unit) material.young_modulus /= body.young_modulus;
  try {
    return cache.get(*body.mesh, unit, body.fixed, touched, without(body.surface->nodes, body.fixed));
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}", spec.name), error.what());
  }
}

}  // namespace

CompiledBody compile_body(const BodySpec& spec, const std::vector<const ProbeSpec*>& probes,
                          ComplianceCache& cache) {
  CompiledBody compiled{.body = {.name = spec.name, .young_modulus = spec.material.young_modulus}};
  Body& body = compiled.body;
  body.mesh = std::make_shared<const TetMesh>(read_placed(spec));
  body.surface = std::make_shared<const Surface>(extract_surface(*body.mesh));
  body.materials = materials_of(spec, *body.mesh);
  body.fixed = select(*body.mesh, *spec.fixed, fmt::format("bodies.{}.fixed", spec.name));
  const std::vector<int> colliding = colliding_nodes(spec, *body.mesh, *body.surface, body.fixed);

  std::vector<int> touched = colliding;
  for (const ProbeSpec* probe_spec : probes) {
    Probe probe{.name = probe_spec->name};
    place_probe(*probe_spec, *body.mesh, *body.surface, body.fixed, probe);
    refuse_shared_node(*probe_spec, probe, compiled.probes, *body.mesh);
    touched.insert(touched.end(), probe.nodes.begin(), probe.nodes.end());
    compiled.probes.push_back(std::move(probe));
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  refuse_too_many(spec, touched.size());

  body.compliance = unit_compliance(spec, body, touched, cache);
  add_polygons(body, colliding);
  for (std::size_t i = 0; i < probes.size(); ++i) finish_probe(*probes[i], body, compiled.probes[i]);
  return compiled;
}

}  // namespace palpate::sim
