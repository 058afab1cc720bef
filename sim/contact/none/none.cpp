#include "sim/contact/none/none.hpp"

namespace palpate::sim {
namespace {

std::unique_ptr<LawScratch> prepare_nothing(const Model&) {
  return nullptr;
}

SolveReport solve_nothing(const Model&, const FreeState&, std::span<const double>, LawScratch&, Response&) {
  return {};
}

}  // namespace

constinit const ContactLaw kNone{.name = kNoContact,
                                 .meaning = "bodies do not act on each other",
                                 .prepare = prepare_nothing,
                                 .solve = solve_nothing};

}  // namespace palpate::sim
