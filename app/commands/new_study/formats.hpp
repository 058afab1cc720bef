#pragma once

#include <string>
#include <string_view>

#include "base/text/file_format.hpp"
#include "trials/procedure/procedure.hpp"
#include "trials/task/task.hpp"

namespace palpate::app {

/// A protocol to start from, every key explained.
std::string new_protocol(std::string_view name, const trials::Task& task, const trials::Procedure& procedure);
/// Its scene, "scene.toml". The meshes that it names stand in "meshes", beside it.
std::string new_scene();

/// The reference of a file's keys (Markdown). @param file  "scene", "protocol" or "observer"
std::string reference_of(std::string_view file);

/// All that such a file may hold.
base::FileFormat format_of(std::string_view file);

}  // namespace palpate::app
