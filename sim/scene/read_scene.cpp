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
#include "sim/scene/refuse_key.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/scene_keys.hpp"

namespace palpate::sim {
namespace {

// Keys of later versions, beside those that call for an effect (EffectKey).
constexpr std::array<std::string_view, 2> kLaterRegionKeys{"relaxation", "volumetric"};

Vec3 to_vec3(const base::Triple& values) {
  return Vec3(values.data());
}

/// The line of every key of the file, by its path.
void add_lines(const toml::table& table, const std::string& path, KeyLines& lines) {
  for (const auto& [key, node] : table) {
    const std::string key_path = path.empty() ? std::string(key) : fmt::format("{}.{}", path, key.str());
    lines.of_key.emplace(key_path, static_cast<int>(node.source().begin.line));
    if (const toml::table* below = node.as_table()) add_lines(*below, key_path, lines);
  }
}

KeyLines lines_of(const toml::table& root) {
  KeyLines lines;
  add_lines(root, "", lines);
  return lines;
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

NodeSelection read_selection(base::TomlReader& reader, std::string_view key) {
  const toml::node& node = reader.other(key);
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
  base::TomlReader box = reader.table_at(key, node, box_keys());
  const Box found{to_vec3(box.three_quantities("lower")), to_vec3(box.three_quantities("upper"))};
  box.refuse_unknown();
  return found;
}

/// @param table  of the scene, as EffectKey names it
EffectValues read_effects(base::TomlReader& reader, std::string_view table) {
  EffectValues values;
  for (const EffectKey& effect : effect_keys()) {
    if (effect.table != table) continue;
    if (!effect.read) {
      reader.refuse_later(effect.key.name, effect.calls_for);
      continue;
    }
    reader.also(std::span(&effect.key, 1));
    if (reader.has(effect.key.name))
      values.insert_or_assign(std::string(effect.key.name), effect.read(reader, effect.key.name));
  }
  return values;
}

Material read_region(base::TomlReader reader, double poisson_ratio_of_body) {
  reader.refuse_later(kLaterRegionKeys);
  const Material region{
      .young_modulus = reader.quantity("young_modulus"),
      .poisson_ratio = reader.has("poisson_ratio") ? reader.number("poisson_ratio") : poisson_ratio_of_body};
  reader.refuse_unknown();
  return region;
}

std::vector<std::filesystem::path> read_refinements(base::TomlReader& reader,
                                                    const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> meshes;
  for (const toml::node& item : reader.as_array("refinements", reader.other("refinements"))) {
    if (!item.is_string())
      reader.refuse("refinements",
                    fmt::format("holds {}, accepted: mesh files", base::TomlReader::describe(item)));
    meshes.push_back(folder / *item.value<std::string>());
  }
  return meshes;
}

BodySpec read_body(base::TomlReader reader, const std::string& name, const std::filesystem::path& folder) {
  BodySpec body{.name = name};
  body.present = reader.boolean("present");
  body.mesh = folder / reader.text("mesh");
  body.metres_per_unit = base::metres_per_unit(reader.word("length_unit"));
  body.material = {.young_modulus = reader.quantity("young_modulus"),
                   .poisson_ratio = reader.number("poisson_ratio")};
  if (reader.has("regions")) {
    base::TomlReader regions = reader.table("regions", tables_by_name());
    for (const std::string& region : regions.keys())
      body.regions[region] = read_region(regions.table(region, region_keys()), body.material.poisson_ratio);
  }
  if (reader.has("fixed")) body.fixed = read_selection(reader, "fixed");
  if (reader.has("touchable")) body.touchable = read_selection(reader, "touchable");
  body.scale = reader.number("scale");
  body.rotate = to_vec3(reader.three_quantities("rotate"));
  body.offset = to_vec3(reader.three_quantities("offset"));
  body.interior = static_cast<int>(reader.whole("interior"));
  if (reader.has("refinements")) body.refinements = read_refinements(reader, folder);
  body.effects = read_effects(reader, "bodies");
  reader.refuse_unknown();
  return body;
}

/// A key that one contact model alone knows.
void refuse_other_models(const base::TomlReader& reader, std::string_view key, std::string_view model,
                         const ContactSpec& contact) {
  if (contact.model != model)
    reader.refuse(key, fmt::format("is for the contact model {}, and model is \"{}\"; accepted: the scene "
                                   "without it, or model = \"{}\"",
                                   model, contact.model, model));
}

/// The body whose nodes alone meet polygons; nothing for those of both.
std::string read_pairing(base::TomlReader& reader, const ContactSpec& contact) {
  constexpr std::string_view kNodesOf = "nodes of ";
  const std::string pairing = reader.text("pairing");
  refuse_other_models(reader, "pairing", "exact", contact);
  if (pairing == "both") return {};
  std::string body = pairing.starts_with(kNodesOf) ? pairing.substr(kNodesOf.size()) : "";
  std::vector<std::string> accepted;
  for (const auto& pair : contact.touch)
    for (const std::string& name : pair)
      if (std::ranges::find(accepted, name) == accepted.end()) accepted.push_back(name);
  if (std::ranges::find(accepted, body) != accepted.end()) return body;
  reader.refuse("pairing", fmt::format("found \"{}\", accepted: \"both\", \"{}{}\"", pairing, kNodesOf,
                                       fmt::join(accepted, fmt::format("\", \"{}", kNodesOf))));
}

ContactSpec read_contact(base::TomlReader reader) {
  ContactSpec contact;
  for (const toml::node& item : reader.as_array("touch", reader.other("touch"))) {
    const toml::array* pair = item.as_array();
    if (!pair || pair->size() != 2 || !(*pair)[0].is_string() || !(*pair)[1].is_string())
      reader.refuse("touch", "accepted: pairs of bodies such as [[\"rectum\", \"prostate\"]]");
    contact.touch.push_back({*(*pair)[0].value<std::string>(), *(*pair)[1].value<std::string>()});
  }
  contact.model = reader.word("model");
  if (reader.has("overlap")) contact.overlap = reader.quantity("overlap");
  if (reader.has("reading")) {
    refuse_other_models(reader, "reading", "kuroda", contact);
    contact.reading = reader.word("reading", kReadingWords);
  }
  if (reader.has("pairing")) contact.nodes_of = read_pairing(reader, contact);
  if (reader.has("tolerance")) {
    refuse_other_models(reader, "tolerance", "exact", contact);
    contact.tolerance = reader.quantity("tolerance");
  }
  if (reader.has("precision")) {
    refuse_other_models(reader, "precision", "exact", contact);
    contact.precision = reader.word("precision", kPrecisionWords);
  }
  contact.effects = read_effects(reader, "contact");
  reader.refuse_unknown();
  return contact;
}

const ProbeKindKeys& keys_of_kind(const std::string& name) {
  const std::span<const ProbeKindKeys> kinds = probe_kind_keys();
  return *std::ranges::find(kinds, name, &ProbeKindKeys::name);
}

/// The kinds that take a key: `pad" or "fingertip`.
std::string kinds_with(bool ProbeKindKeys::*takes) {
  std::vector<std::string_view> names;
  for (const ProbeKindKeys& kind : probe_kind_keys())
    if (kind.*takes) names.push_back(kind.name);
  return fmt::format("{}", fmt::join(names, "\" or \""));
}

/// Where the probe is: a group for those that hold one, a node or a place for the others.
void read_place(base::TomlReader& reader, ProbeSpec& probe) {
  const bool has_node = reader.has("node"), has_place = reader.has("at"), has_group = reader.has("group");
  if (keys_of_kind(probe.kind).takes_group) {
    if (!has_group || has_node || has_place)
      reader.refuse(
          has_group ? (has_node ? "node" : "at") : "group",
          fmt::format("a {} holds a named group of the mesh; accepted: group = \"NAME\" in place of at and "
                      "node",
                      probe.kind));
    probe.group = reader.text("group");
    return;
  }
  if (has_group)
    reader.refuse("group", fmt::format("a {} holds no group; accepted: at or node, or kind = \"{}\"",
                                       probe.kind, kinds_with(&ProbeKindKeys::takes_group)));
  if (has_node == has_place)
    reader.refuse("at",
                  "exactly one of at (a place) and node (a node's number in the mesh file) is accepted");
  if (has_node)
    probe.at = reader.whole("node");
  else
    probe.at = to_vec3(reader.three_quantities("at"));
}

/// A radius where the probe's kind takes one.
double read_radius(base::TomlReader& reader, const std::string& kind_name) {
  const ProbeKindKeys& kind = keys_of_kind(kind_name);
  const bool given = reader.has("radius");
  if (kind.takes_radius && given) return reader.quantity("radius");
  if (!kind.takes_radius && !given) return 0.0;
  if (kind.takes_radius)
    reader.refuse("radius", fmt::format("a {} needs a radius > 0, such as \"6 mm\"", kind.name));
  reader.refuse("radius", fmt::format("a {} has no radius; kind = \"{}\" has one", kind.name,
                                      kinds_with(&ProbeKindKeys::takes_radius)));
}

ProbeSpec read_probe(base::TomlReader reader, const std::string& name) {
  ProbeSpec probe{.name = name};
  probe.body = reader.text("body");
  probe.kind = reader.word("kind");
  read_place(reader, probe);
  probe.direction = to_vec3(reader.three_numbers("direction"));
  if (!probe.direction.allFinite() || probe.direction.stableNorm() == 0.0)
    reader.refuse("direction", "has no length; accepted: three numbers, not all 0");
  probe.direction.stableNormalize();
  probe.depth = reader.quantity("depth");
  probe.radius = read_radius(reader, probe.kind);
  if (reader.has("reach")) {
    if (!keys_of_kind(probe.kind).takes_reach)
      reader.refuse("reach",
                    fmt::format("a {} does not slide; accepted: the scene without it, or kind = \"{}\"",
                                probe.kind, kinds_with(&ProbeKindKeys::takes_reach)));
    probe.reach = reader.quantity("reach");
  }
  if (reader.has("tangential") && !keys_of_kind(probe.kind).holds_mean)
    reader.refuse("tangential",
                  fmt::format("a {} takes none; accepted: the scene without it, or kind = \"{}\"", probe.kind,
                              kinds_with(&ProbeKindKeys::holds_mean)));
  probe.tangential = reader.word("tangential", kTangentialWords);
  reader.refuse_unknown();
  return probe;
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, std::span<const Override> overrides) {
  toml::table root = base::read_toml(file);
  for (const Override& change : overrides) apply(root, change);
  base::TomlReader reader(root, file.string(), scene_keys());
  Scene scene{.name = reader.text("name"), .file = file, .lines = lines_of(root)};

  base::TomlReader bodies = reader.table("bodies", tables_by_name());
  for (const std::string& name : bodies.keys())
    scene.bodies.push_back(read_body(bodies.table(name, body_keys()), name, file.parent_path()));
  if (reader.has("contact")) scene.contact = read_contact(reader.table("contact", contact_keys()));
  base::TomlReader probes = reader.table("probes", tables_by_name());
  for (const std::string& name : probes.keys())
    scene.probes.push_back(read_probe(probes.table(name, probe_keys()), name));
  reader.refuse_unknown();
  with_place(scene, [&] { validate(scene); });
  return scene;
}

}  // namespace palpate::sim
