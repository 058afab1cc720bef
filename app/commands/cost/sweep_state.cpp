#include "app/commands/cost/sweep_state.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <limits>
#include <system_error>

#include "base/files/atomic_file.hpp"
#include "base/files/read_file.hpp"
#include "base/files/sha256.hpp"
#include "base/machine/cache_folder.hpp"

namespace palpate::app {

using nlohmann::ordered_json;

namespace {

ordered_json number_or_null(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

}  // namespace

ordered_json result_json(const sim::VariantResult& result) {
  const sim::Variant& variant = result.variant;
  ordered_json json = {{"model", variant.model},
                       {"friction", variant.friction},
                       {"tolerance", variant.tolerance},
                       {"mesh", variant.mesh},
                       {"interior", variant.interior},
                       {"precision", base::word_of(sim::kPrecisionWords, variant.precision)},
                       {"nodes", result.nodes},
                       {"touchable_nodes", result.touchable},
                       {"edge", result.edge},
                       {"force", result.forces},
                       {"displacement_error", nullptr},
                       {"penetration", result.penetration},
                       {"imbalance", result.imbalance},
                       {"largest_jump", result.largest_jump},
                       {"force_error_bound", number_or_null(result.force_error_bound)},
                       {"unsolved", result.unsolved},
                       {"time",
                        {{"median", result.time.median},
                         {"p99", result.time.p99},
                         {"p99_9", result.time.p999},
                         {"slowest", result.time.slowest},
                         {"first", result.first},
                         {"rounds", result.rounds}}},
                       {"prepare_s", result.prepare},
                       {"memory_bytes", result.bytes}};
  if (result.displacement_error) json["displacement_error"] = *result.displacement_error;
  return json;
}

sim::VariantResult result_from(const ordered_json& json) {
  const ordered_json& time = json.at("time");
  sim::VariantResult result{
      .variant = {.model = json.at("model"),
                  .friction = json.at("friction"),
                  .tolerance = json.at("tolerance"),
                  .mesh = json.at("mesh"),
                  .interior = json.at("interior"),
                  .precision =
                      json.at("precision") == "single" ? sim::Precision::Single : sim::Precision::Double},
      .nodes = json.at("nodes"),
      .touchable = json.at("touchable_nodes"),
      .edge = json.at("edge"),
      .forces = json.at("force").get<std::vector<double>>(),
      .penetration = json.at("penetration"),
      .imbalance = json.at("imbalance"),
      .largest_jump = json.at("largest_jump"),
      .force_error_bound = json.at("force_error_bound").is_null()
                               ? std::numeric_limits<double>::infinity()
                               : json.at("force_error_bound").get<double>(),
      .unsolved = json.at("unsolved"),
      .rounds = time.at("rounds").get<std::vector<double>>(),
      .time = {time.at("median"), time.at("p99"), time.at("p99_9"), time.at("slowest")},
      .first = time.at("first"),
      .prepare = json.at("prepare_s"),
      .bytes = json.at("memory_bytes")};
  if (!json.at("displacement_error").is_null()) result.displacement_error = json.at("displacement_error");
  return result;
}

SweepState::SweepState(const sim::Scene& scene, const std::vector<std::string>& overrides,
                       const SweepPlan& plan, const std::string& versions) {
  const std::filesystem::path folder = base::cache_folder();
  if (folder.empty()) return;
  std::string all = versions + base::read_file(scene.file);
  for (const std::string& change : overrides) all += '\n' + change;
  for (const sim::BodySpec& body : scene.bodies) {
    if (!body.present) continue;
    all += base::sha256_hex(base::read_file(body.mesh));
    for (const std::filesystem::path& mesh : body.refinements) all += base::sha256_hex(base::read_file(mesh));
  }
  all += fmt::format("\n{} {} {}", plan.depth, plan.seconds, plan.model);
  file_ = folder / "cost" / (base::sha256_hex(all) + ".json");
}

std::vector<sim::VariantResult> SweepState::load() const {
  std::vector<sim::VariantResult> done;
  if (std::error_code error; file_.empty() || !std::filesystem::exists(file_, error)) return done;
  try {
    for (const ordered_json& one : ordered_json::parse(base::read_file(file_)))
      done.push_back(result_from(one));
  } catch (const std::exception&) {
    done.clear();
  }
  return done;
}

void SweepState::save(const std::vector<sim::VariantResult>& done) const {
  if (file_.empty()) return;
  ordered_json all = ordered_json::array();
  for (const sim::VariantResult& result : done) all.push_back(result_json(result));
  try {
    std::filesystem::create_directories(file_.parent_path());
    base::write_atomically(file_, all.dump());
  } catch (const std::system_error& refusal) {
    spdlog::debug("a sweep that is interrupted will begin anew: {}", refusal.what());
  }
}

void SweepState::remove() const {
  std::error_code ignored;
  if (!file_.empty()) std::filesystem::remove(file_, ignored);
}

}  // namespace palpate::app
