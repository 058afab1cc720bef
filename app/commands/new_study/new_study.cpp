#include "app/commands/new_study/new_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "app/command_line/data_folder.hpp"
#include "app/commands/new_study/formats.hpp"
#include "base/files/new_folder.hpp"
#include "base/files/read_file.hpp"
#include "trials/protocol/protocol.hpp"
#include "trials/protocol/protocol_keys.hpp"

namespace palpate::app {
namespace {

struct NewOptions {
  std::string folder, reference;
  std::string task{trials::tasks().front()->name}, procedure{trials::procedures().front()->name};
};

constexpr std::array<std::string_view, 2> kMeshes{"prostate.msh", "rectum.msh"};  // that the scene names

template <class Member>
const Member& named(std::span<const Member* const> members, std::string_view name) {
  return **std::ranges::find(members, name, &Member::name);
}

void make_study(const NewOptions& options) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(options.folder).lexically_normal();
  const std::string name = (folder.has_filename() ? folder : folder.parent_path()).filename();
  constexpr std::size_t kLongest = 100;  // letters: file systems take 255 with what stands before and behind
  if (!trials::is_name(name) || name.front() == '-' || name.size() > kLongest)
    throw std::invalid_argument(
        fmt::format("{}: is no name for a study; accepted: {}, no hyphen at the front, at most {} of them",
                    options.folder, trials::kNamesAccepted, kLongest));
  if (fs::exists(fs::symlink_status(folder)))
    throw std::invalid_argument(
        fmt::format("{}: is there already and is not overwritten; accepted: another name", options.folder));
  base::NewFolder study(folder, base::NewFolder::Beside::Nothing);
  study.add("protocol.toml", new_protocol(name, named(trials::tasks(), options.task),
                                          named(trials::procedures(), options.procedure)));
  study.add("scene.toml", new_scene());
  for (const std::string_view mesh : kMeshes)
    study.add(fs::path("meshes") / mesh,
              base::read_file(data_folder() / "data/meshes" / mesh, "a mesh file"));
  study.finish();

  const std::string protocol = folder / "protocol.toml";
  fmt::print("{}\n{}\n", protocol, (folder / "scene.toml").string());
  for (const std::string_view mesh : kMeshes) fmt::print("{}\n", (folder / "meshes" / mesh).string());
  fmt::print(
      "\nOpen {0} in an editor: every key is explained there. Then:\n"
      "  palpate check {0}\n"
      "  palpate plan {0}\n"
      "  palpate simulate {0} --study {1} --examinees 15\n",
      protocol, (folder / "simulated.db").string());
}

void run_new(const NewOptions& options) {
  if (!options.reference.empty())
    fmt::print("{}", reference_of(options.reference));
  else if (options.folder.empty())
    throw CLI::RequiredError("NAME");
  else
    make_study(options);
}

/// What is wrong with a word of the command line; nothing where it is accepted.
std::string refusal(const std::string& word, const base::Words& words) {
  if (std::ranges::find(words.now, word, &base::Word::word) != words.now.end()) return "";
  const bool later = std::ranges::find(words.later, word) != words.later.end();
  return fmt::format("found {}{}, accepted: {}", word, later ? ", which is not in this version" : "",
                     base::accepted(words));
}

void add_new(CLI::App& command) {
  auto options = std::make_shared<NewOptions>();
  command.add_option("NAME", options->folder,
                     "A folder that is not there yet; its name is the study's (letters, digits, - and _)");
  command.add_option("--task", options->task, "What is asked: " + base::accepted(trials::task_words()))
      ->check([](const std::string& word) { return refusal(word, trials::task_words()); })
      ->capture_default_str();
  command
      .add_option("--procedure", options->procedure,
                  "How levels are chosen: " + base::accepted(trials::procedure_words()))
      ->check([](const std::string& word) { return refusal(word, trials::procedure_words()); })
      ->capture_default_str();
  command
      .add_option("--reference", options->reference,
                  "Make nothing; print what a file may hold, with every key explained (Markdown)")
      ->check(CLI::IsMember({"scene", "protocol", "observer"}))
      ->excludes("NAME");
  command.footer(
      "The folder stands alone: protocol, scene and the meshes that it needs. Nothing is ever overwritten.\n\n"
      "Examples:\n  palpate new wall-stiffness\n  palpate new --reference protocol > protocol.md");
  command.callback([options] { run_new(*options); });
}

}  // namespace

const Command new_command{.name = "new",
                          .summary = "A protocol and a scene to start a study of your own from",
                          .heading = "Begin",
                          .add = add_new};

}  // namespace palpate::app
