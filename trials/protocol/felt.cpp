#include "trials/protocol/felt.hpp"

#include <algorithm>

namespace palpate::trials {
namespace {

using Order = std::partial_ordering;

/// What holds of two parts together: equal parts leave it to the other.
Order both(Order a, Order b) {
  if (a == Order::equivalent) return b;
  if (b == Order::equivalent || a == b) return a;
  return Order::unordered;
}

Order compare_materials(const sim::BodySpec& a, const sim::BodySpec& b) {
  Order order = a.material.young_modulus <=> b.material.young_modulus;
  for (const auto& [name, material] : a.regions) {
    const auto other = b.regions.find(name);
    if (other == b.regions.end()) return Order::unordered;
    order = both(order, material.young_modulus <=> other->second.young_modulus);
  }
  return order;
}

/// The body with nothing left that compare_materials() and its presence tell.
sim::BodySpec without_stiffness(sim::BodySpec body) {
  body.present = true;
  body.material.young_modulus = 1.0;
  for (auto& [name, material] : body.regions) material.young_modulus = 1.0;
  return body;
}

Order compare_bodies(const sim::BodySpec& a, const sim::BodySpec& b) {
  if (!a.present && !b.present) return Order::equivalent;
  if (without_stiffness(a) != without_stiffness(b)) return Order::unordered;
  if (a.present != b.present) return a.present ? Order::greater : Order::less;
  return compare_materials(a, b);
}

}  // namespace

std::partial_ordering compare_stiffness(const sim::Scene& a, const sim::Scene& b) {
  if (a.contact != b.contact || a.probes != b.probes || a.bodies.size() != b.bodies.size())
    return Order::unordered;
  Order order = Order::equivalent;
  for (std::size_t i = 0; i < a.bodies.size(); ++i)
    order = both(order, compare_bodies(a.bodies[i], b.bodies[i]));
  return order;
}

std::optional<Answer> answer_told_by(const Protocol& protocol, const std::vector<sim::Scene>& scenes) {
  Order order = Order::equivalent;
  for (std::size_t cell = 0; cell < protocol.cells.size(); ++cell)
    for (const std::size_t other : protocol.presented)
      if (other != protocol.correct)
        order = both(order, compare_stiffness(scenes[stimulus_index(protocol, cell, protocol.correct)],
                                              scenes[stimulus_index(protocol, cell, other)]));
  if (order == Order::greater) return Answer::Stiffest;
  if (order == Order::less) return Answer::Softest;
  return std::nullopt;
}

}  // namespace palpate::trials
