#include "app/command_line/output.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <charconv>

namespace palpate::app {

CLI::Option* add_seed(CLI::App& command, const std::string& meaning,
                      const std::function<void(std::uint64_t)>& take) {
  const auto read = [take](const std::string& text) {
    std::uint64_t seed = 0;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, seed);
    if (error != std::errc() || at != end) {
      throw CLI::ValidationError(
          "--seed", fmt::format("found {}, accepted: a whole number from 0 to {}", text, UINT64_MAX));
    }
    take(seed);
  };
  return command.add_option_function<std::string>("--seed", read, meaning)->type_name("UINT");
}

std::string json_text(const nlohmann::ordered_json& result, int indent) {
  return result.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void print_json(const nlohmann::ordered_json& result) {
  fmt::print("{}\n", json_text(result));
}

std::size_t terminal_width() {
  constexpr std::size_t kLeast = 40, kMost = 100;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kMost;
  return std::clamp<std::size_t>(size.ws_col, kLeast, kMost);
}

}  // namespace palpate::app
