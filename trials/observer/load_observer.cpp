#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/files/read_file.hpp"
#include "base/text/toml_reader.hpp"
#include "trials/observer/observer.hpp"

namespace palpate::trials {
namespace {

using base::Dimension;
using base::TomlReader;

/// A fraction or ratio without unit.
double number(TomlReader& reader, const std::string& key, double least, double most) {
  const double found = reader.required_number(key);
  if (!(found >= least && found <= most))
    reader.refuse(key, fmt::format("found {}, accepted: a number from {} to {}", found, least, most));
  return found;
}

double quantity(TomlReader& reader, const std::string& key, Dimension dimension, std::string_view example,
                bool may_be_zero) {
  const double found = reader.required_quantity(key, dimension, example);
  if (found < 0.0 || (found == 0.0 && !may_be_zero))
    reader.refuse(key,
                  fmt::format("accepted: a quantity {} 0 such as {}", may_be_zero ? ">=" : ">", example));
  return found;
}

Variation read_variation(TomlReader& reader, const std::string& key, Dimension dimension,
                         std::string_view example) {
  return {.mean = quantity(reader, key, dimension, example, false),
          .between = quantity(reader, key + "_between_examinees", dimension, example, true),
          .within = quantity(reader, key + "_within_examinee", dimension, example, true)};
}

TomlReader section(TomlReader& reader, std::string_view key) {
  reader.required(key, fmt::format("accepted: a table [{}]", key));
  return *reader.table(key);
}

void read_press(TomlReader press, ObserverParameters& p) {
  p.depth = read_variation(press, "depth", Dimension::Length, "\"4.5 mm\"");
  p.duration = read_variation(press, "duration", Dimension::Time, "\"0.6 s\"");
  p.tremor = quantity(press, "tremor", Dimension::Length, "\"0.05 mm\"", true);
  p.tremor_period = quantity(press, "tremor_period", Dimension::Time, "\"0.1 s\"", false);
  p.drift = quantity(press, "drift", Dimension::Length, "\"0.2 mm\"", true);
  p.drift_period = quantity(press, "drift_period", Dimension::Time, "\"2 s\"", false);
  press.refuse_unknown();
}

void read_senses(TomlReader senses, ObserverParameters& p) {
  p.force_noise = quantity(senses, "force_noise", Dimension::Force, "\"0.02 N\"", true);
  p.position_noise = quantity(senses, "position_noise", Dimension::Length, "\"0.1 mm\"", true);
  p.weber_fraction.mean = number(senses, "weber_fraction", 1e-6, 10.0);
  p.weber_fraction.between = number(senses, "weber_fraction_between_examinees", 0.0, 10.0);
  senses.refuse_unknown();
}

void read_decision(TomlReader decision, ObserverParameters& p) {
  p.lapse_rate = number(decision, "lapse_rate", 0.0, 1.0);
  p.interval_bias.mean = number(decision, "interval_bias", -10.0, 10.0);
  p.interval_bias.between = number(decision, "interval_bias_between_examinees", 0.0, 10.0);
  decision.refuse_unknown();
}

nlohmann::json as_json(const Variation& variation) {
  return {{"mean", variation.mean}, {"between", variation.between}, {"within", variation.within}};
}

}  // namespace

ObserverParameters load_observer(const std::filesystem::path& file) {
  ObserverParameters p{.text = base::read_file(file)};
  const toml::table root = base::parse_toml(p.text, file.string());
  TomlReader reader(root, file.string());
  p.name = reader.required_text("name");
  read_press(section(reader, "press"), p);
  TomlReader device = section(reader, "device");
  p.device.force_scale = number(device, "force_scale", 1e-6, 1e6);
  p.device.max_force = quantity(device, "max_force", Dimension::Force, "\"8.5 N\"", false);
  device.refuse_unknown();
  read_senses(section(reader, "senses"), p);
  read_decision(section(reader, "decision"), p);
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
