#include "sim/compile/compile.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "sim/compliance/cache.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/read_mesh.hpp"
#include "sim/model/model.hpp"
#include "sim/pairing/find_pairs.hpp"
#include "sim/probe/footprint.hpp"
#include "sim/scene/refuse_key.hpp"

namespace palpate::sim {
namespace {

constexpr double kLeastBody = 1e-6, kFarthest = 1e9;  // [m] across, and from the origin
constexpr int kMostTouchableNodes = 1000;             // a dense factor over all of them takes 72 MB

std::vector<std::string> group_names(const TetMesh& mesh) {
  std::vector<std::string> names;
  for (const auto& [name, nodes] : mesh.node_groups) names.push_back(name);
  return names;
}

std::vector<int> select(const TetMesh& mesh, const NodeSelection& selection, const std::string& key) {
  std::vector<int> nodes;
  if (const auto* group = std::get_if<std::string>(&selection)) {
    const auto found = mesh.node_groups.find(*group);
    if (found == mesh.node_groups.end())
      refuse_key(key, fmt::format("the mesh has no group \"{}\"; it has: {}", *group,
                                  fmt::join(group_names(mesh), ", ")));
    nodes = found->second;
  } else if (const auto* box = std::get_if<Box>(&selection)) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      if ((mesh.nodes[i].array() >= box->lower.array()).all() &&
          (mesh.nodes[i].array() <= box->upper.array()).all())
        nodes.push_back(static_cast<int>(i));
  } else {
    for (const std::int64_t tag : std::get<std::vector<std::int64_t>>(selection)) {
      const auto found = std::ranges::find(mesh.node_tags, tag);
      if (found == mesh.node_tags.end()) refuse_key(key, fmt::format("the mesh has no node number {}", tag));
      nodes.push_back(static_cast<int>(found - mesh.node_tags.begin()));
    }
    std::ranges::sort(nodes);
  }
  if (nodes.empty()) refuse_key(key, "selects no node of the mesh");
  return nodes;
}

/// A body that scale, offset or rotate have taken to where numbers have no meaning left.
void refuse_misplaced(const BodySpec& spec, const TetMesh& mesh) {
  Vec3 lower = mesh.nodes.front(), upper = lower;
  for (const Vec3& node : mesh.nodes) {
    if (!(node.cwiseAbs().maxCoeff() <= kFarthest))
      refuse_key(
          fmt::format("bodies.{}", spec.name),
          fmt::format("scale, offset or rotate put it at ({:g}, {:g}, {:g}) m; accepted: up to {:g} m from "
                      "the origin",
                      node.x(), node.y(), node.z(), kFarthest));
    lower = lower.cwiseMin(node);
    upper = upper.cwiseMax(node);
  }
  if (const double across = (upper - lower).norm(); across < kLeastBody)
    refuse_key(fmt::format("bodies.{}", spec.name),
               fmt::format("is {:g} m across; accepted: {:g} m or more; look at length_unit and scale",
                           across, kLeastBody));
}

TetMesh read_placed(const BodySpec& spec) {
  TetMesh mesh;
  try {
    mesh = read_mesh(spec.mesh, spec.metres_per_unit).mesh;
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}.mesh", spec.name), error.what());
  }
  try {
    validate(mesh);
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}.mesh: {}", spec.name, spec.mesh.string()), error.what());
  }
  const double angle = spec.rotate.norm();
  const Eigen::Matrix3d turn = angle > 0.0 ? Eigen::AngleAxisd(angle, spec.rotate / angle).toRotationMatrix()
                                           : Eigen::Matrix3d::Identity();
  for (Vec3& node : mesh.nodes) node = turn * (spec.scale * node) + spec.offset;
  refuse_misplaced(spec, mesh);
  return mesh;
}

std::vector<Material> materials_of(const BodySpec& spec, const TetMesh& mesh) {
  std::vector<Material> materials(mesh.region_names.size() + 1, spec.material);
  for (const auto& [name, material] : spec.regions) {
    const auto found = std::ranges::find(mesh.region_names, name);
    if (found == mesh.region_names.end())
      refuse_key(
          fmt::format("bodies.{}.regions.{}", spec.name, name),
          fmt::format("the mesh has no such volume group; it has: {}", fmt::join(mesh.region_names, ", ")));
    const auto region = static_cast<int>(found - mesh.region_names.begin());
    if (std::ranges::find(mesh.region, region) == mesh.region.end())
      refuse_key(
          fmt::format("bodies.{}.regions.{}", spec.name, name),
          "no tetrahedron of the mesh belongs to it: one that lies in several volume groups belongs to "
          "the smallest");
    materials[region + 1] = material;
  }
  return materials;
}

std::vector<int> without(const std::vector<int>& nodes, const std::vector<int>& left_out) {
  std::vector<int> kept;
  std::ranges::set_difference(nodes, left_out, std::back_inserter(kept));
  return kept;
}

std::vector<int> index_of_nodes(std::size_t nodes, const std::vector<int>& list) {
  std::vector<int> index(nodes, -1);
  for (std::size_t i = 0; i < list.size(); ++i) index[list[i]] = static_cast<int>(i);
  return index;
}

/// The surface nodes that may touch another body: the scene's group, or the whole free surface.
std::vector<int> colliding_nodes(const BodySpec& spec, const TetMesh& mesh, const Surface& surface,
                                 const std::vector<int>& fixed) {
  std::vector<int> wanted = surface.nodes;
  if (spec.touchable) {
    const std::string key = fmt::format("bodies.{}.touchable", spec.name);
    const std::vector<int> named = select(mesh, *spec.touchable, key);
    wanted.clear();
    std::ranges::set_intersection(named, surface.nodes, std::back_inserter(wanted));
    if (wanted.empty()) refuse_key(key, "selects no node of the surface");
  }
  wanted = without(wanted, fixed);
  if (wanted.empty()) refuse_key(fmt::format("bodies.{}.touchable", spec.name), "selects fixed nodes only");
  return wanted;
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

/// @param probes  of this body, their nodes as mesh nodes
Body compile_body(const BodySpec& spec, TetMesh placed, const std::vector<const ProbeSpec*>& probe_specs,
                  std::vector<Probe>& probes, ComplianceCache& cache) {
  Body body{.name = spec.name, .young_modulus = spec.material.young_modulus};
  body.mesh = std::make_shared<const TetMesh>(std::move(placed));
  body.surface = std::make_shared<const Surface>(extract_surface(*body.mesh));
  body.materials = materials_of(spec, *body.mesh);
  body.fixed = select(*body.mesh, *spec.fixed, fmt::format("bodies.{}.fixed", spec.name));
  const std::vector<int> colliding = colliding_nodes(spec, *body.mesh, *body.surface, body.fixed);

  std::vector<int> touched = colliding;
  for (const ProbeSpec* probe_spec : probe_specs) {
    Probe probe{.name = probe_spec->name};
    place_probe(*probe_spec, *body.mesh, *body.surface, body.fixed, probe);
    refuse_shared_node(*probe_spec, probe, probes, *body.mesh);
    touched.insert(touched.end(), probe.nodes.begin(), probe.nodes.end());
    probes.push_back(std::move(probe));
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  refuse_too_many(spec, touched.size());

  std::vector<Material> unit = body.materials;
  for (Material& material : unit) material.young_modulus /= body.young_modulus;
  try {
    body.compliance =
        cache.get(*body.mesh, unit, body.fixed, touched, without(body.surface->nodes, body.fixed));
  } catch (const std::invalid_argument& error) {
    refuse_key(fmt::format("bodies.{}", spec.name), error.what());
  }
  add_polygons(body, colliding);
  return body;
}

void finish_probe(const ProbeSpec& spec, int body_number, const Body& body, Probe& probe) {
  probe.body = body_number;
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

/// Deepest place of a node of `inner` inside `outer` at rest, over the whole boundary of both.
double overlap_at_rest(const Body& inner, const Body& outer) {
  std::vector<int> every(outer.mesh->nodes.size());
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = static_cast<int>(i);
  Body whole{.polygons = make_touch_surface(outer.surface->triangles, every, static_cast<int>(every.size()))};
  whole.rest.resize(3, static_cast<Eigen::Index>(every.size()));
  for (std::size_t i = 0; i < every.size(); ++i)
    whole.rest.col(static_cast<Eigen::Index>(i)) = outer.mesh->nodes[i];
  whole.tree = build_tree(whole.polygons.triangles, whole.rest);

  Body points;
  points.rest.resize(3, static_cast<Eigen::Index>(inner.surface->nodes.size()));
  for (std::size_t i = 0; i < inner.surface->nodes.size(); ++i) {
    points.rest.col(static_cast<Eigen::Index>(i)) = inner.mesh->nodes[inner.surface->nodes[i]];
    points.colliding_nodes.push_back(static_cast<int>(i));
  }
  Model probe_model;
  probe_model.bodies = {std::move(points), std::move(whole)};
  probe_model.pairs = {{{0, 1}}};
  FreeMotion motion = rest_motion(probe_model);
  motion[0].displacement.setConstant(std::numeric_limits<double>::infinity());  // looks at every polygon
  motion[0].moved = true;
  return deepest_overlaps(probe_model, motion).front();
}

void refuse_overlap(const Body& a, const Body& b) {
  const double size = (a.rest.rowwise().maxCoeff() - a.rest.rowwise().minCoeff()).norm();
  const double overlap = std::max(overlap_at_rest(a, b), overlap_at_rest(b, a));
  if (overlap > 1e-9 * size)
    refuse_key(
        "bodies",
        fmt::format("{} and {} overlap at rest by {:.3g} mm; accepted: bodies that are apart (see offset)",
                    a.name, b.name, 1e3 * overlap));
}

Model compile_all(const Scene& scene, ComplianceCache& cache) {
  Model model{.scene = scene.name, .law = scene.contact.model};
  model.probes.resize(scene.probes.size());
  for (const BodySpec& spec : scene.bodies) {
    if (!spec.present) continue;
    std::vector<const ProbeSpec*> specs;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < scene.probes.size(); ++i) {
      if (scene.probes[i].body != spec.name) continue;
      specs.push_back(&scene.probes[i]);
      places.push_back(i);
    }
    std::vector<Probe> probes;
    Body body = compile_body(spec, read_placed(spec), specs, probes, cache);
    const auto number = static_cast<int>(model.bodies.size());
    for (std::size_t i = 0; i < probes.size(); ++i) {
      finish_probe(*specs[i], number, body, probes[i]);
      body.probes.push_back(static_cast<int>(places[i]));
      model.probes[places[i]] = std::move(probes[i]);
    }
    model.bodies.push_back(std::move(body));
  }
  for (const auto& names : scene.contact.touch) {
    const auto a = std::ranges::find(model.bodies, names[0], &Body::name);
    const auto b = std::ranges::find(model.bodies, names[1], &Body::name);
    if (a == model.bodies.end() || b == model.bodies.end()) continue;  // one of them is not present
    refuse_overlap(*a, *b);
    model.pairs.push_back(
        {{static_cast<int>(a - model.bodies.begin()), static_cast<int>(b - model.bodies.begin())}});
  }
  return model;
}

}  // namespace

Model compile(const Scene& scene, ComplianceCache& cache) {
  try {
    return compile_all(scene, cache);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", scene.file.string(), error.what()));
  }
}

}  // namespace palpate::sim
