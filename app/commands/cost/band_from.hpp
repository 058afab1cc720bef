#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/cost/variant_result.hpp"

namespace palpate::app {

/// What the examinees of a study told apart, as part of the force.
struct StudyBand {
  sim::Band band{};
  std::string source{};
};

/// From a study of two-interval forced choices between conditions that differ in the force alone, such as between contact
/// models: each cell has a relative difference of force (root mean square over the press to the scene's depth) and a share
/// of correct answers, P = Phi(k difference) [MacmillanCreelman2005]. The band is the 95 % profile-likelihood interval
/// of the difference at which 75 % are correct. A study without answers of its own run mode counts with simulated ones, and
/// says so.
/// Throws std::invalid_argument where the file is no such study, or nothing was answered.
StudyBand band_from(const std::filesystem::path& study);

/// The interval by itself. @param differences, correct, trials  of each cell
/// An upper end that the answers do not bound is 1: the whole force.
sim::Band band_of(const std::vector<double>& differences, const std::vector<long>& correct,
                  const std::vector<long>& trials);

}  // namespace palpate::app
