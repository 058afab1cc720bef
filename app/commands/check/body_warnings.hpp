#pragma once

#include <string>
#include <vector>

#include "sim/model/model.hpp"

namespace palpate::app {

/// What of a body and its probes can be computed and will mislead, a sentence each.
std::vector<std::string> body_warnings(const sim::Model& model, const sim::Body& body);

}  // namespace palpate::app
