#include "sim/scene/scene_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "sim/scene/accepted.hpp"
#include "sim/scene/scene.hpp"

namespace palpate::sim {
namespace {

using base::Dimension;
using base::Key;

base::Words units_of_length() {
  return {.now = {{"m"}, {"cm"}, {"mm"}, {"um"}}, .later = {}};
}

constexpr double kAny = std::numeric_limits<double>::infinity();  // no bound

constexpr std::string_view kSelection =
    "a group's name, node numbers, or a box { lower = [...], upper = [...] }";

constexpr std::array kSceneKeys{
    Key{.name = "name",
        .takes = base::kText,
        .example = "\"rectal palpation\"",
        .meaning = "What the scene is called in results."},
    Key{.name = "bodies", .takes = base::takes_table("one table [bodies.NAME] a body")},
    Key{.name = "contact",
        .takes = base::takes_table("a table [contact]"),
        .absent = "no body touches another"},
    Key{.name = "probes", .takes = base::takes_table("one table [probes.NAME] a probe")},
};

constexpr Key kYoungModulus{.name = "young_modulus",
                            .takes = base::takes_quantity(Dimension::Pressure, base::kPositive),
                            .example = "\"1.0 MPa\"",
                            .meaning = "How stiff the material is."};
constexpr base::Takes kPoissonRatio = base::takes_number({.least = -1.0, .most = 0.5, .open = true});

constexpr std::array kBodyKeys{
    Key{.name = "mesh",
        .takes = base::kText,
        .example = "\"meshes/prostate.msh\"",
        .meaning =
            "The mesh file, seen from this file: tetrahedra, as Gmsh MSH 2.2 or 4.1 or VTU. Where Gmsh is "
            "installed, what it reads, too."},
    Key{.name = "length_unit",
        .takes = base::takes_word(units_of_length),
        .example = "\"m\"",
        .meaning = "The unit of the mesh file's coordinates, which the file itself does not tell."},
    kYoungModulus,
    Key{.name = "poisson_ratio",
        .takes = kPoissonRatio,
        .example = "0.40",
        .meaning = "How much the material keeps its volume: near 0.5 it keeps all of it. From 0.45 on linear "
                   "tetrahedra come out too stiff, and `palpate check` warns."},
    Key{.name = "fixed",
        .takes = base::takes_other(kSelection),
        .example = "\"fixed\"",
        .absent = "a region that a probe holds is what holds the body",
        .meaning =
            "The nodes that cannot move: a named group of the mesh, node numbers as in the mesh file, or "
            "all nodes within a box. Without enough of them the body would float away, which is refused.",
        .in_use = true},
    Key{.name = "touchable",
        .takes = base::takes_other(kSelection),
        .example = "\"contact\"",
        .absent = "the whole free surface",
        .meaning =
            "The part of the surface that may touch other bodies, named in the same ways as `fixed`. The "
            "smaller it is, the faster is a cycle.",
        .in_use = true},
    Key{.name = "present",
        .takes = base::kBoolean,
        .example = "false",
        .fallback = "true",
        .meaning = "`false` takes the body out of the scene: a condition without it."},
    Key{.name = "scale",
        .takes = base::takes_number(base::kPositive),
        .example = "1.1",
        .fallback = "1.0",
        .meaning = "Makes the body so many times as large, about the origin of its mesh."},
    Key{.name = "rotate",
        .takes = base::takes_three(Dimension::Angle),
        .example = "[\"0 deg\", \"0 deg\", \"10 deg\"]",
        .fallback = "[\"0 deg\", \"0 deg\", \"0 deg\"]",
        .meaning = "Turns the body about the axis with these parts, by the angle that is their length "
                   "(a rotation vector), after `scale`."},
    Key{.name = "offset",
        .takes = base::takes_three(Dimension::Length),
        .example = "[\"0 mm\", \"0 mm\", \"1 mm\"]",
        .fallback = "[\"0 mm\", \"0 mm\", \"0 mm\"]",
        .meaning =
            "Moves the body, after `scale` and `rotate`. Bodies that overlap at rest by more than contact.overlap "
            "are refused."},
    Key{.name = "interior",
        .takes = base::takes_whole(0, 3),
        .example = "1",
        .fallback = "0",
        .meaning =
            "How often the mesh is cut finer inside, each tetrahedron in eight, while the surface that may be "
            "touched keeps its nodes: a more accurate force at the same cost of a cycle, for a longer preparation."},
    Key{.name = "refinements",
        .takes = base::takes_other("mesh files, as [\"meshes/prostate-fine.msh\"]"),
        .example = "[\"meshes/prostate-fine.msh\"]",
        .absent = "no finer mesh is known",
        .meaning =
            "Finer meshes of the same body with the same groups, each finer than the one before: what `palpate cost` "
            "reckons the error of the mesh from. Nothing else reads them."},
    Key{.name = "regions",
        .takes = base::takes_table("one table [bodies.NAME.regions.GROUP] a region"),
        .absent = "one material throughout"},
};

constexpr std::array kRegionKeys{
    Key{.name = "young_modulus",
        .takes = base::takes_quantity(Dimension::Pressure, base::kPositive),
        .example = "\"20 MPa\"",
        .meaning = "How stiff the region is."},
    Key{.name = "poisson_ratio",
        .takes = kPoissonRatio,
        .example = "0.45",
        .absent = "that of the body",
        .meaning = "How much the region keeps its volume."},
};

constexpr std::array kBoxKeys{
    Key{.name = "lower",
        .takes = base::takes_three(Dimension::Length),
        .example = "[\"-10 mm\", \"-10 mm\", \"0 mm\"]",
        .meaning = "The corner of least x, y and z, where the scene puts the body."},
    Key{.name = "upper",
        .takes = base::takes_three(Dimension::Length),
        .example = "[\"10 mm\", \"10 mm\", \"5 mm\"]",
        .meaning = "The corner of largest x, y and z."},
};

constexpr std::array kContactKeys{
    Key{.name = "touch",
        .takes = base::takes_other("pairs of bodies such as [[\"rectum\", \"prostate\"]]"),
        .example = "[[\"rectum\", \"prostate\"]]",
        .meaning = "Which bodies may touch: pairs of their names, each pair once."},
    Key{.name = "model",
        .takes = base::takes_word(contact_model_words),
        .example = "\"kuroda\"",
        .meaning = "The contact model: what bodies that touch do to each other."},
    Key{.name = "overlap",
        .takes = base::takes_quantity(Dimension::Length, base::kNotNegative),
        .example = "\"0.1 mm\"",
        .absent = "none: bodies are apart or touch",
        .meaning =
            "How far bodies of the scene may reach into each other at rest. What they do counts as touching: "
            "it is not felt."},
    Key{.name = "reading",
        .takes = base::takes_word(base::words_of<kReadingWords>),
        .example = "\"literal\"",
        .absent = "\"every pair\"",
        .meaning = "With the contact model `kuroda`: how equations (3) and (4) of the paper are read.",
        .along = "model = \"kuroda\""},
    Key{.name = "pairing",
        .takes = base::kText,
        .example = "\"nodes of prostate\"",
        .absent = "\"both\"",
        .meaning = "With the contact model `exact`: whose nodes are kept out of the other body: \"both\", or "
                   "\"nodes of BODY\" in every pair of that body.",
        .along = "model = \"exact\""},
    Key{.name = "tolerance",
        .takes = base::takes_quantity(Dimension::Fraction, {.least = 0.0, .most = 1.0, .open = true}),
        .example = "\"1 %\"",
        .absent = "solved to the last digit",
        .meaning =
            "With the contact model `exact`: the part of a probe's force by which it may be wrong. A cycle may "
            "then end early, as soon as the bound of its error is within that.",
        .along = "model = \"exact\""},
    Key{.name = "precision",
        .takes = base::takes_word(base::words_of<kPrecisionWords>),
        .example = "\"single\"",
        .absent = "\"double\"",
        .meaning =
            "With the contact model `exact`: how many digits the compliance has that gaps are reckoned with.",
        .along = "model = \"exact\""},
};

constexpr std::array kProbeKeys{
    Key{.name = "body",
        .takes = base::kText,
        .example = "\"rectum\"",
        .meaning = "The body that it presses."},
    Key{.name = "kind",
        .takes = base::takes_word(probe_kind_words),
        .example = "\"point\"",
        .meaning = "What it presses with."},
    Key{.name = "radius",
        .takes = base::takes_quantity(Dimension::Length, base::kPositive),
        .example = "\"9 mm\"",
        .absent = "the kind has none",
        .meaning = "The radius of a kind that has one.",
        .along = "kind = \"pad\""},
    Key{.name = "reach",
        .takes = base::takes_quantity(Dimension::Length, base::kPositive),
        .example = "\"5 mm\"",
        .absent = "it stays at its place, and what it holds goes along with it",
        .meaning =
            "How far a pad or a fingertip slides over the surface, across its direction, or a region takes a body that nothing "
            "else holds. `palpate press --path` sets it to what the path needs.",
        .along = "kind = \"pad\"\nradius = \"9 mm\""},
    Key{.name = "group",
        .takes = base::kText,
        .example = "\"cap\"",
        .absent = "`at` or `node` says where",
        .meaning = "The named group of the mesh that a region holds and moves as one.",
        .along = "kind = \"region\"",
        .instead_of = "at"},
    Key{.name = "at",
        .takes = base::takes_three(Dimension::Length),
        .example = "[\"0 mm\", \"0 mm\", \"12 mm\"]",
        .absent = "`node` or `group` says where",
        .meaning = "Where it presses: the node of the body's free surface that is nearest to this place.",
        .in_use = true},
    Key{.name = "node",
        .takes = base::takes_whole(-kAny, kAny),
        .example = "5",
        .absent = "`at` or `group` says where",
        .meaning = "In place of `at`: a node's number in the mesh file.",
        .instead_of = "at"},
    Key{.name = "direction",
        .takes = base::kThreeNumbers,
        .example = "[0, 0, 1]",
        .meaning = "Which way it presses: into the body. Its length does not matter."},
    Key{.name = "depth",
        .takes = base::takes_quantity(Dimension::Length, base::kPositive),
        .example = "\"5 mm\"",
        .meaning = "How deep `palpate press` and `palpate check` press it, and how deep an examinee can."},
    Key{.name = "tangential",
        .takes = base::takes_word(base::words_of<kTangentialWords>),
        .example = "\"free\"",
        .fallback = "\"held\"",
        .meaning = "What a point or a pad does to the surface across its direction."},
};

constexpr std::array kTablesByName{
    Key{.name = base::kAnyName, .takes = base::takes_table("a table")},
};

/// A table's own keys and those that effects bring to it.
template <std::size_t count>
std::vector<Key> with_effects(const std::array<Key, count>& keys, std::string_view table) {
  std::vector<Key> all(keys.begin(), keys.end());
  for (const EffectKey& effect : effect_keys())
    if (effect.table == table && effect.read) all.push_back(effect.key);
  return all;
}

std::vector<std::string> later_keys() {
  std::vector<std::string> later{"bodies.NAME.regions.GROUP.relaxation",
                                 "bodies.NAME.regions.GROUP.volumetric"};
  for (const EffectKey& effect : effect_keys())
    if (!effect.read)
      later.push_back(
          fmt::format("{}.{}", effect.table == "bodies" ? "bodies.NAME" : effect.table, effect.key.name));
  return later;
}

constexpr std::string_view kIntroduction =
    "A scene says what there is to touch: bodies, their materials and supports, which of them may touch, and "
    "the probes that press. A protocol names a scene and changes single entries of it, and so does `--set` on "
    "the command line (`--set bodies.prostate.young_modulus=\"5 MPa\"`).";

}  // namespace

std::span<const Key> scene_keys() {
  return kSceneKeys;
}
std::span<const Key> body_keys() {
  return kBodyKeys;
}
std::span<const Key> region_keys() {
  return kRegionKeys;
}
std::span<const Key> box_keys() {
  return kBoxKeys;
}
std::span<const Key> contact_keys() {
  return kContactKeys;
}
std::span<const Key> probe_keys() {
  return kProbeKeys;
}
std::span<const Key> tables_by_name() {
  return kTablesByName;
}

base::FileFormat scene_format() {
  return {
      .name = "scene",
      .introduction = kIntroduction,
      .tables =
          {{.path = "", .keys = {kSceneKeys.begin(), kSceneKeys.end()}, .shown = {{}}},
           {.path = "bodies.NAME",
            .meaning = "A body: one elastic object. Its name is free, and is what other entries call it by.",
            .keys = with_effects(kBodyKeys, "bodies"),
            .shown = {{.path = "bodies.prostate"},
                      {.path = "bodies.rectum", .examples = {{"mesh", "\"meshes/rectum.msh\""}}}}},
           {.path = "bodies.NAME.regions.GROUP",
            .meaning =
                "A part of a body of another material, such as a nodule: a volume group of the mesh, by "
                "its name there.",
            .keys = {kRegionKeys.begin(), kRegionKeys.end()}},
           {.path = "bodies.NAME.fixed",
            .called = "a box",
            .meaning = "`fixed` and `touchable` as a box: `fixed = { lower = [...], upper = [...] }`.",
            .keys = {kBoxKeys.begin(), kBoxKeys.end()}},
           {.path = "contact",
            .meaning = "What happens where bodies touch. Without this table no body touches another.",
            .keys = with_effects(kContactKeys, "contact"),
            .shown = {{.path = "contact"}}},
           {.path = "probes.NAME",
            .meaning =
                "What presses. The first probe is the finger: its force is what `palpate press` reports and an "
                "examinee feels.",
            .keys = {kProbeKeys.begin(), kProbeKeys.end()},
            .shown = {{.path = "probes.finger"}}}},
      .apart = combinations_in_words(),
      .later = later_keys()};
}

}  // namespace palpate::sim
