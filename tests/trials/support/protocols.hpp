#pragma once

#include <string>
#include <string_view>

#include "base/files/sha256.hpp"
#include "tests/support/places.hpp"
#include "tests/trials/support/files.hpp"
#include "trials/protocol/protocol.hpp"

namespace palpate::trials::test {

/// The shipped protocol's text, its scene named by an absolute path so that it can be read from anywhere.
inline std::string shipped_text() {
  const std::filesystem::path root = palpate::test::source_folder();
  std::string text = read(root / "protocols/kuroda2003.toml");
  const std::string relative = "../data/scenes/";
  text.replace(text.find(relative), relative.size(), (root / "data/scenes/").string());
  return text;
}

/// `text` with every `from` replaced; throws when there is none, so that no test passes by a typing error.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not in the text: " + std::string(from));
  for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
  return text;
}

/// The shipped study with `trials` questions a cell. Neither scene nor meshes are read; a line stands for the
/// scene.
inline Protocol small_protocol(int trials = 2) {
  Protocol protocol = parse_protocol(
      with(shipped_text(), "per_cell = 4", "per_cell = " + std::to_string(trials)), "small.toml");
  protocol.scene_text = "name = \"no scene\"\n";
  protocol.files = {{"scene", "scene.toml", base::sha256_hex(protocol.scene_text)}};
  return protocol;
}

}  // namespace palpate::trials::test
