#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include "sim/mesh/surface.hpp"
#include "sim/model/free_state.hpp"
#include "sim/model/model.hpp"

namespace palpate::sim::test {

/// A body for detection alone, without elasticity: all of its nodes and polygons can collide.
inline Body loose_body(Eigen::Matrix3Xd nodes, const std::vector<Triangle>& triangles) {
  std::vector<int> every(nodes.cols());
  std::iota(every.begin(), every.end(), 0);
  Body body{.rest = std::move(nodes)};
  body.polygons = make_touch_surface(triangles, every, static_cast<int>(every.size()));
  body.colliding_nodes = every;
  body.tree = build_tree(body.polygons.triangles, body.rest);
  return body;
}

/// The boundary of a mesh as such a body, moved by `offset`.
inline Body loose_body(const TetMesh& mesh, const Vec3& offset) {
  const Surface surface = extract_surface(mesh);
  std::vector<int> index(mesh.nodes.size(), -1);
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(surface.nodes.size()));
  for (std::size_t i = 0; i < surface.nodes.size(); ++i) {
    index[surface.nodes[i]] = static_cast<int>(i);
    nodes.col(static_cast<Eigen::Index>(i)) = mesh.nodes[surface.nodes[i]] + offset;
  }
  std::vector<Triangle> triangles = surface.triangles;
  for (Triangle& triangle : triangles)
    for (int& corner : triangle) corner = index[corner];
  return loose_body(std::move(nodes), triangles);
}

/// Two such bodies that may touch.
inline Model loose_pair(Body a, Body b, double overlap = 0.0) {
  Model model{.overlap = overlap};
  model.bodies.push_back(std::move(a));
  model.bodies.push_back(std::move(b));
  model.pairs = {{{0, 1}}};
  return model;
}

/// A motion that brings each touchable node where `where` says that its place at rest goes.
template <class Where>
BodyMotion motion_to(const Body& body, Where where) {
  BodyMotion motion{.displacement = Eigen::VectorXd::Zero(3 * body.rest.cols()), .moved = true};
  for (Eigen::Index i = 0; i < body.rest.cols(); ++i) {
    const Vec3 rest = body.rest.col(i);
    motion.displacement.segment<3>(3 * i) = Vec3(where(rest)) - rest;
  }
  return motion;
}

inline BodyMotion at_rest(const Body& body) {
  return {.displacement = Eigen::VectorXd::Zero(3 * body.rest.cols()), .moved = false};
}

}  // namespace palpate::sim::test
