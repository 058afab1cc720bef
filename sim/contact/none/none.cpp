#include "sim/contact/none/none.hpp"

#include "sim/contact/exact/exact.hpp"

namespace palpate::sim {
namespace {

/// A fingertip touches whatever the bodies do.
std::unique_ptr<LawScratch> prepare_none(const Model& model) {
  return has_tips(model) ? std::make_unique<ExactScratch>(model, false) : nullptr;
}

}  // namespace

constinit const ContactLaw kNone{.name = kNoContact,
                                 .meaning = "bodies do not act on each other",
                                 .prepare = prepare_none,
                                 .solve = solve_exact,
                                 .follows_regions = true};

}  // namespace palpate::sim
