#include "app/command_line/usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "base/text/toml_reader.hpp"

namespace palpate::app {
namespace {

std::set<std::string> option_names(const CLI::App& command) {
  std::set<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.insert("--" + name);
  return names;
}

std::set<std::string> command_names(const CLI::App& command) {
  std::set<std::string> names;
  for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; }))
    names.insert(one->get_name());
  return names;
}

/// "no option --modl; did you mean --model?"
std::string unknown(const CLI::App& command, std::string word) {
  const bool option = word.starts_with('-');
  if (option) word = word.substr(0, word.find('='));
  const std::set<std::string> known = option ? option_names(command) : command_names(command);
  if (known.empty()) return fmt::format("found '{}', and no more arguments are expected", word);
  const std::string what = fmt::format("no {} '{}'", option ? "option" : "command", word);
  if (const auto meant = base::nearest_key(word, known))
    return what + fmt::format("; did you mean {}?", *meant);
  return option ? what : what + fmt::format("; accepted: {}", fmt::join(known, ", "));
}

}  // namespace

std::string usage_error(const CLI::App* app, const CLI::Error& error) {
  std::string command = app->get_name();
  const CLI::App* at = app;
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    command += " " + at->get_name();
  }
  const std::vector<std::string> left = at->remaining();
  const auto word = std::ranges::find_if(left, [](const std::string& one) { return one.starts_with('-'); });
  std::string said = error.what();
  if (word != left.end())
    said = unknown(*at, *word);
  else if (!left.empty() && (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError) ||
                             !command_names(*at).empty()))
    said = unknown(*at, left.front());
  return fmt::format("Error: {}\n`{} --help` shows what is accepted.\n", said, command);
}

void refuse_empty(std::span<char* const> arguments) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string_view word = arguments[i];
    const bool nothing_behind = word.starts_with("--") && word.find('=') == word.size() - 1;
    if (!word.empty() && !nothing_behind) continue;
    const std::string name(nothing_behind ? word.substr(0, word.size() - 1) : arguments[i - 1]);
    throw CLI::ValidationError(
        nothing_behind || name.starts_with("--") ? name : fmt::format("argument {}", i),
        "is empty; accepted: a value (is a shell variable empty?)");
  }
}

}  // namespace palpate::app
