#include <nlohmann/json.hpp>

#include "base/files/read_file.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/observer/observer.hpp"
#include "trials/observer/observer_keys.hpp"

namespace palpate::trials {
namespace {

using base::TomlReader;

Variation read_variation(TomlReader& reader, const std::string& key) {
  return {.mean = reader.quantity(key),
          .between = reader.quantity(key + "_between_examinees"),
          .within = reader.quantity(key + "_within_examinee")};
}

void read_press(TomlReader press, ObserverParameters& p) {
  p.depth = read_variation(press, "depth");
  p.duration = read_variation(press, "duration");
  p.tremor = press.quantity("tremor");
  p.tremor_period = press.quantity("tremor_period");
  p.drift = press.quantity("drift");
  p.drift_period = press.quantity("drift_period");
  press.refuse_unknown();
}

void read_device(TomlReader device, ObserverParameters& p) {
  p.device.force_scale = device.number("force_scale");
  p.device.max_force = device.quantity("max_force");
  device.refuse_unknown();
}

void read_senses(TomlReader senses, ObserverParameters& p) {
  p.force_noise = senses.quantity("force_noise");
  p.position_noise = senses.quantity("position_noise");
  p.weber_fraction.mean = senses.number("weber_fraction");
  p.weber_fraction.between = senses.number("weber_fraction_between_examinees");
  senses.refuse_unknown();
}

void read_decision(TomlReader decision, ObserverParameters& p) {
  p.lapse_rate = decision.number("lapse_rate");
  p.interval_bias.mean = decision.number("interval_bias");
  p.interval_bias.between = decision.number("interval_bias_between_examinees");
  decision.refuse_unknown();
}

nlohmann::json as_json(const Variation& variation) {
  return {{"mean", variation.mean}, {"between", variation.between}, {"within", variation.within}};
}

}  // namespace

ObserverParameters load_observer(const std::filesystem::path& file) {
  ObserverParameters p{.text = base::read_file(file)};
  const toml::table root = base::parse_toml(p.text, file.string());
  TomlReader reader(root, file.string(), observer_keys());
  p.name = reader.text("name");
  read_press(reader.table("press", press_keys()), p);
  read_device(reader.table("device", device_keys()), p);
  read_senses(reader.table("senses", senses_keys()), p);
  read_decision(reader.table("decision", decision_keys()), p);
  reader.refuse_unknown();
  return p;
}

std::string to_json(const ObserverParameters& p) {
  return nlohmann::json{{"name", p.name},
                        {"depth_m", as_json(p.depth)},
                        {"duration_s", as_json(p.duration)},
                        {"tremor_m", p.tremor},
                        {"tremor_period_s", p.tremor_period},
                        {"drift_m", p.drift},
                        {"drift_period_s", p.drift_period},
                        {"force_scale", p.device.force_scale},
                        {"max_force_n", p.device.max_force},
                        {"force_noise_n", p.force_noise},
                        {"position_noise_m", p.position_noise},
                        {"weber_fraction", as_json(p.weber_fraction)},
                        {"weber_fraction_at_share_correct", 0.75},
                        {"lapse_rate", p.lapse_rate},
                        {"interval_bias", as_json(p.interval_bias)}}
      .dump();
}

}  // namespace palpate::trials
