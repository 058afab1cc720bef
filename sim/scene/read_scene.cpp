#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/text/quantity.hpp"
#include "base/text/toml_depth.hpp"
#include "base/text/toml_reader.hpp"
#include "sim/scene/accepted.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {
namespace {

// Keys of later versions, beside those that call for an effect (EffectKey).
constexpr std::array<std::string_view, 2> kLaterRegionKeys{"relaxation", "volumetric"};
constexpr std::array<std::string_view, 1> kLaterProbeKeys{"group"};

Vec3 to_vec3(const base::Triple& values) {
  return Vec3(values.data());
}

/// A value as a TOML file would hold it; what is no TOML is a string, so that units need no quotes in a
/// shell.
toml::table parse_override(const Override& change) {
  const std::string text = "value = " + change.value;
  base::refuse_deep_toml(text, change.key);
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return toml::table{{"value", change.value}};
  }
}

/// An override changes bodies and probes; it makes none, and a slip in a name is not to look like one.
void refuse_invented(const toml::table& root, std::string_view key, std::string_view name) {
  for (const auto& [kind, singular] : {std::pair{"bodies", "body"}, std::pair{"probes", "probe"}}) {
    if (key.substr(0, key.find(name)) != fmt::format("{}.", kind)) continue;
    std::vector<std::string_view> known;
    if (const toml::table* all = root[kind].as_table())
      for (const auto& entry : *all) known.push_back(entry.first.str());
    throw std::invalid_argument(fmt::format("{}: \"{}\" is no {} of this scene; accepted: {}", key, name,
                                            singular, fmt::join(known, ", ")));
  }
}

void apply(toml::table& root, const Override& change) {
  base::refuse_deep_key(change.key);
  toml::table* table = &root;
  std::string_view key = change.key;
  for (auto dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
    const std::string_view name = key.substr(0, dot);
    if (!table->contains(name)) {
      refuse_invented(root, change.key, name);
      table->insert(name, toml::table{});
    }
    table = table->get(name)->as_table();
    if (!table)
      throw std::invalid_argument(fmt::format("{}: \"{}\" is a value and has no parts", change.key, name));
    key.remove_prefix(dot + 1);
  }
  if (key.empty())
    throw std::invalid_argument(
        fmt::format("\"{}\" names no entry of a scene; example: contact.model", change.key));
  const toml::table parsed = parse_override(change);
  parsed.get("value")->visit([&](const auto& value) { table->insert_or_assign(key, value); });
}

NodeSelection read_selection(base::TomlReader& reader, std::string_view key, const toml::node& node) {
  if (node.is_string()) return *node.value<std::string>();
  if (node.is_array()) {
    std::vector<std::int64_t> tags;
    for (const toml::node& item : *node.as_array()) {
      if (!item.is_integer())
        reader.refuse(key, fmt::format("holds {}, accepted: node numbers", base::TomlReader::describe(item)));
      tags.push_back(*item.value<std::int64_t>());
    }
    return tags;
  }
  if (!node.is_table())
    reader.refuse(key, fmt::format("found {}, accepted: a group's name, node numbers, or a box {{ lower = "
                                   "[...], upper = [...] }}",
                                   base::TomlReader::describe(node)));
  base::TomlReader box(*node.as_table(), reader.file(), reader.key_path(key));
  box.required("lower", "accepted: three lengths");
  box.required("upper", "accepted: three lengths");
  const Box found{to_vec3(*box.vector_quantity("lower", base::Dimension::Length)),
                  to_vec3(*box.vector_quantity("upper", base::Dimension::Length))};
  box.refuse_unknown();
  return found;
}

Material read_material(base::TomlReader& reader, double default_poisson) {
  Material material;
  material.young_modulus =
      reader.required_quantity("young_modulus", base::Dimension::Pressure, "\"1.0 MPa\"");
  material.poisson_ratio = reader.number("poisson_ratio").value_or(default_poisson);
  return material;
}

/// @param table  of the scene, as EffectKey names it
EffectValues read_effects(base::TomlReader& reader, std::string_view table) {
  EffectValues values;
  for (const EffectKey& effect : effect_keys()) {
    if (effect.table != table || !reader.has(effect.key)) continue;
    if (!effect.read)
      reader.refuse(effect.key,
                    fmt::format("calls for {}, which this version does not simulate", effect.calls_for));
    values.insert_or_assign(std::string(effect.key), effect.read(reader, effect.key));
  }
  return values;
}

std::string read_word(base::TomlReader& reader, std::string_view key, const AcceptedWords& words) {
  std::string word = reader.required_text(key);
  if (std::ranges::count(words.later, word) > 0)
    reader.refuse(
        key, fmt::format("\"{}\" is not in this version; accepted: {}", word, fmt::join(words.now, ", ")));
  if (std::ranges::count(words.now, word) == 0)
    reader.refuse(key, fmt::format("found \"{}\", accepted: {}", word, fmt::join(words.now, ", ")));
  return word;
}

BodySpec read_body(base::TomlReader& reader, const std::string& name, const std::filesystem::path& folder) {
  BodySpec body{.name = name};
  body.present = reader.boolean("present").value_or(true);
  body.mesh = folder / reader.required_text("mesh");
  const std::string unit = reader.required_text("length_unit");
  try {
    body.metres_per_unit = base::metres_per_unit(unit);
  } catch (const std::invalid_argument& error) {
    reader.refuse("length_unit", error.what());
  }
  reader.required("poisson_ratio", "accepted: a number between -1 and 0.5");
  body.material = read_material(reader, 0.0);
  if (auto regions = reader.table("regions")) {
    for (const std::string& region : regions->keys()) {
      auto table = regions->table(region);
      table->refuse_later(kLaterRegionKeys);
      body.regions[region] = read_material(*table, body.material.poisson_ratio);
      table->refuse_unknown();
    }
  }
  body.fixed = read_selection(reader, "fixed",
                              reader.required("fixed", "accepted: a group's name, node numbers, or a box"));
  if (const toml::node* touchable = reader.node("touchable"))
    body.touchable = read_selection(reader, "touchable", *touchable);
  body.scale = reader.number("scale").value_or(1.0);
  body.rotate = to_vec3(reader.vector_quantity("rotate", base::Dimension::Angle).value_or(base::Triple{}));
  body.offset = to_vec3(reader.vector_quantity("offset", base::Dimension::Length).value_or(base::Triple{}));
  body.effects = read_effects(reader, "bodies");
  reader.refuse_unknown();
  return body;
}

ContactSpec read_contact(base::TomlReader& reader) {
  ContactSpec contact;
  for (const toml::node& item :
       reader.as_array("touch", reader.required("touch", "accepted: pairs of bodies"),
                       "pairs of bodies such as [[\"rectum\", \"prostate\"]]")) {
    const toml::array* pair = item.as_array();
    if (!pair || pair->size() != 2 || !(*pair)[0].is_string() || !(*pair)[1].is_string())
      reader.refuse("touch", "accepted: pairs of bodies such as [[\"rectum\", \"prostate\"]]");
    contact.touch.push_back({*(*pair)[0].value<std::string>(), *(*pair)[1].value<std::string>()});
  }
  contact.model = read_word(reader, "model", contact_model_words());
  contact.effects = read_effects(reader, "contact");
  reader.refuse_unknown();
  return contact;
}

/// A radius where the probe's kind takes one.
double read_radius(base::TomlReader& reader, const std::string& kind_name) {
  const std::span<const ProbeKindKeys> kinds = probe_kind_keys();
  const ProbeKindKeys& kind = *std::ranges::find(kinds, kind_name, &ProbeKindKeys::name);
  const double radius = reader.quantity("radius", base::Dimension::Length).value_or(0.0);
  if (kind.takes_radius == (radius > 0.0)) return radius;
  if (kind.takes_radius)
    reader.refuse("radius", fmt::format("a {} needs a radius > 0, such as \"6 mm\"", kind.name));
  std::vector<std::string_view> with_radius;
  for (const ProbeKindKeys& other : kinds)
    if (other.takes_radius) with_radius.push_back(other.name);
  reader.refuse("radius", fmt::format("a {} has no radius; kind = \"{}\" has one", kind.name,
                                      fmt::join(with_radius, "\" or \"")));
}

ProbeSpec read_probe(base::TomlReader& reader, const std::string& name) {
  ProbeSpec probe{.name = name};
  probe.body = reader.required_text("body");
  probe.kind = read_word(reader, "kind", probe_kind_words());
  reader.refuse_later(kLaterProbeKeys);
  const auto node = reader.integer("node");
  const auto at = reader.vector_quantity("at", base::Dimension::Length);
  if (node.has_value() == at.has_value())
    reader.refuse("at",
                  "exactly one of at (a place) and node (a node's number in the mesh file) is accepted");
  if (node)
    probe.at = *node;
  else
    probe.at = to_vec3(*at);
  reader.required("direction", "accepted: three numbers such as [0, 0, 1]");
  probe.direction = to_vec3(*reader.vector_number("direction"));
  if (!probe.direction.allFinite() || probe.direction.stableNorm() == 0.0)
    reader.refuse("direction", "has no length; accepted: three numbers, not all 0");
  probe.direction.stableNormalize();
  probe.depth = reader.required_quantity("depth", base::Dimension::Length, "\"5 mm\"");
  probe.radius = read_radius(reader, probe.kind);
  const std::string tangential = reader.text("tangential").value_or("held");
  const auto known = base::value_of(kTangentialWords, tangential);
  if (!known)
    reader.refuse("tangential", fmt::format("found \"{}\", accepted: {}", tangential,
                                            base::accepted_words(kTangentialWords)));
  probe.tangential = *known;
  reader.refuse_unknown();
  return probe;
}

base::TomlReader required_table(base::TomlReader& reader, std::string_view key, std::string_view accepted) {
  reader.required(key, accepted);
  return *reader.table(key);
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, std::span<const Override> overrides) {
  toml::table root = base::read_toml(file);
  for (const Override& change : overrides) apply(root, change);
  base::TomlReader reader(root, file.string());
  Scene scene{.name = reader.required_text("name"), .file = file};

  base::TomlReader bodies = required_table(reader, "bodies", "accepted: one table [bodies.NAME] a body");
  for (const std::string& name : bodies.keys()) {
    auto body = bodies.table(name);
    scene.bodies.push_back(read_body(*body, name, file.parent_path()));
  }
  if (auto contact = reader.table("contact")) scene.contact = read_contact(*contact);
  base::TomlReader probes = required_table(reader, "probes", "accepted: one table [probes.NAME] a probe");
  for (const std::string& name : probes.keys()) {
    auto probe = probes.table(name);
    scene.probes.push_back(read_probe(*probe, name));
  }
  reader.refuse_unknown();
  try {
    validate(scene);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", file.string(), error.what()));
  }
  return scene;
}

}  // namespace palpate::sim
