#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace palpate::bench {

/// One thing that a scene can call for, on a scene that is otherwise that of its plain counterpart.
struct Row {
  std::string name{};
  std::string plain{};                 // the row without it; empty: there is none
  std::string scene{};                 // a file of data/scenes, without .toml
  std::vector<sim::Override> calls{};  // what the row changes there
  bool slides = false;                 // goes across at the full depth; else it presses
};

/// Every contact law and effect, and every kind of probe under `exact`.
std::vector<Row> rows();

/// The same press with one law on meshes from coarse to fine.
struct Family {
  std::string law{};
  std::vector<Row> sizes{};
};

std::vector<Family> families();

}  // namespace palpate::bench
