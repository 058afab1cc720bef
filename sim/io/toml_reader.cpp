#include "sim/io/toml_reader.hpp"

#include <fstream>
#include <sstream>

namespace palpate::sim {

toml::table read_toml(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    throw std::invalid_argument(fmt::format("{}: no such file", file.string()));
  if (std::filesystem::is_directory(file))
    throw std::invalid_argument(fmt::format("{}: is a folder, accepted: a TOML file", file.string()));
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw std::invalid_argument(fmt::format("{}: cannot be read", file.string()));
  try {
    return toml::parse(text.str(), file.string());
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(fmt::format("{}:{}: no valid TOML: {}", file.string(),
                                            error.source().begin.line, error.description()));
  }
}

}  // namespace palpate::sim
