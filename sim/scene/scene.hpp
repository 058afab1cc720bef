#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/text/enum_words.hpp"
#include "sim/elasticity/stiffness.hpp"
#include "sim/mesh/tet_mesh.hpp"

namespace palpate::sim {

/// Nodes named in a scene: a group of the mesh, a box in the body's rest placement, or node numbers of the
/// mesh file.
struct Box {
  Vec3 lower = Vec3::Zero(), upper = Vec3::Zero();  // [m]

  bool operator==(const Box&) const = default;
};
using NodeSelection = std::variant<std::string, Box, std::vector<std::int64_t>>;

/// What a table of the scene says of the effects that it calls for: by key, the numbers that its value stands
/// for (effect_keys() of accepted.hpp).
using EffectValues = std::map<std::string, std::vector<double>>;

struct BodySpec {
  std::string name{};
  bool present = true;
  std::filesystem::path mesh{};  // absolute, or relative to the working directory
  double metres_per_unit = 1.0;  // of the mesh file [m]
  Material material{};
  std::map<std::string, Material> regions{};  // named volume groups of another material
  std::optional<NodeSelection> fixed{};
  std::optional<NodeSelection> touchable{};  // absent: the whole free surface
  double scale = 1.0;
  Vec3 rotate = Vec3::Zero();  // rotation vector: axis times angle [rad]
  Vec3 offset = Vec3::Zero();  // [m], after scale and rotation
  int interior = 0;            // how often the mesh is cut finer inside
  std::vector<std::filesystem::path>
      refinements{};  // finer meshes of the same body, each finer than the one before
  EffectValues effects{};

  bool operator==(const BodySpec&) const = default;
};

/// The contact model of a scene that has no contact table.
inline constexpr std::string_view kNoContact = "none";

/// Which collisions the contact model `kuroda` carries out by equations (3), (4) of the paper.
enum class Reading { EveryPair, Literal };
inline constexpr base::EnumWords<Reading, 2> kReadingWords{
    {{Reading::EveryPair, "every pair", "every node that has passed a polygon, and that polygon, move"},
     {Reading::Literal, "literal",
      "of the two polygons of a collision only the one with the larger force moves, and the node that has passed "
      "it, as the paper does to reduce computation"}}};

/// In which the contact model `exact` keeps the compliance that it reckons gaps with.
enum class Precision { Double, Single };
inline constexpr base::EnumWords<Precision, 2> kPrecisionWords{
    {{Precision::Double, "double", "16 digits"},
     {Precision::Single, "single",
      "7 digits, half as much to read in a cycle; the bound of the error knows it"}}};

struct ContactSpec {
  std::vector<std::array<std::string, 2>> touch{};  // which bodies may touch
  std::string model{kNoContact};                    // a name that contact_model_words() lists
  double overlap = 0.0;                             // of bodies at rest, by no more than this [m]
  Reading reading = Reading::EveryPair;
  std::string nodes_of{};  // the body whose nodes alone meet the other's polygons; empty: those of both
  double tolerance = 0.0;  // part of the force that the law may be wrong by; 0: none
  Precision precision = Precision::Double;
  EffectValues effects{};

  bool operator==(const ContactSpec&) const = default;
};

/// Whether a probe holds what it presses across its direction, too.
enum class Tangential { Held, Free };
inline constexpr base::EnumWords<Tangential, 2> kTangentialWords{
    {{Tangential::Held, "held", "it sticks: what it presses cannot slip sideways"},
     {Tangential::Free, "free", "it moves the surface along its direction only"}}};

struct ProbeSpec {
  std::string name{};
  std::string body{};
  std::string kind{};  // a name that probe_kind_words() lists
  /// A place [m], or a node's number in the mesh file.
  std::variant<Vec3, std::int64_t> at = Vec3(Vec3::Zero());
  Vec3 direction = Vec3::UnitZ();  // of the press, unit length
  double depth = 0.0;              // default depth of a press [m]
  double radius = 0.0;             // of a pad [m]
  double reach = 0.0;              // how far it slides across its direction [m]; 0: it stays at its place
  std::string group{};             // of a region: the nodes that it holds
  Tangential tangential = Tangential::Held;

  bool operator==(const ProbeSpec&) const = default;
};

/// Where a scene file says what: the line of each key, by its path ("bodies.rectum.mesh"); 0 for one that an
/// override put there. No part of what is simulated: all are equal.
struct KeyLines {
  std::map<std::string, int, std::less<>> of_key{};

  bool operator==(const KeyLines&) const { return true; }
};

/// Bodies, materials, supports, what may touch what, probes. Plain data, validated at the border.
struct Scene {
  std::string name{};
  std::filesystem::path file{};    // where it was read
  std::vector<BodySpec> bodies{};  // in the order of the file
  ContactSpec contact{};
  std::vector<ProbeSpec> probes{};  // the first is the finger whose force is reported
  KeyLines lines{};

  bool operator==(const Scene&) const = default;
};

/// One entry of a scene replaced: dotted key and TOML value, e.g. {"bodies.prostate.young_modulus", "\"5.0
/// MPa\""}. A value that is no TOML is taken as a string, so that `--set bodies.prostate.young_modulus="5
/// MPa"` works.
struct Override {
  std::string key{};
  std::string value{};
};

/// Reads and validates a scene file, `overrides` put in place first.
/// Throws std::invalid_argument: file, line or key, what was found, what is accepted. An unknown key is an
/// error.
Scene load_scene(const std::filesystem::path& file, std::span<const Override> overrides = {});

/// Throws RefusedKey (refuse_key.hpp) for a reference to what does not exist. Single values are checked where
/// they are read.
void validate(const Scene& scene);

}  // namespace palpate::sim
