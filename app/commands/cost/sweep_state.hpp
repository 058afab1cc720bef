#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/commands/cost/sweep.hpp"

namespace palpate::app {

/// One variant's result, without what others make of it.
nlohmann::ordered_json result_json(const sim::VariantResult& result);
sim::VariantResult result_from(const nlohmann::ordered_json& json);

/// What a sweep that was interrupted has measured, kept beside the compliances under the hash of all that it depends on:
/// scene, meshes, plan, machine and versions. A file that cannot be read or is another's counts as none.
class SweepState {
 public:
  /// @param versions  of program, compiler and machine
  SweepState(const sim::Scene& scene, const std::vector<std::string>& overrides, const SweepPlan& plan,
             const std::string& versions);

  std::vector<sim::VariantResult> load() const;
  /// A folder that cannot be written costs going on later, not the sweep.
  void save(const std::vector<sim::VariantResult>& done) const;
  void remove() const;

 private:
  std::filesystem::path file_{};  // empty: there is no such place
};

}  // namespace palpate::app
