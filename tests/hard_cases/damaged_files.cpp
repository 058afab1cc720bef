// 13: mesh files that are cut, foreign, or claim what they do not hold.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "sim/mesh/parse_mesh.hpp"
#include "sim/mesh/quality.hpp"
#include "tests/hard_cases/refusal.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/sim/mesh/fixtures.hpp"
#include "tests/sim/support/box_mesh.hpp"
#include "tests/support/heap_use.hpp"

namespace palpate::hard_cases {
namespace {

using sim::test::replaced;

std::string reading(const std::string& bytes) {
  return refused([&] { sim::validate(sim::parse_mesh(bytes, "body.msh", 1.0).mesh); });
}

/// "body.msh:12: ...", "body.msh: byte 400: ...", or of an empty file "body.msh: the file is empty".
bool names_its_place(const std::string& refusal) {
  const std::string name = "body.msh:";
  if (!refusal.starts_with(name)) return false;
  return std::isdigit(static_cast<unsigned char>(refusal[name.size()])) != 0 || says(refusal, "byte ") ||
         says(refusal, "empty");
}

/// Cut and altered at random places: a sound mesh or a refusal, never another exception.
void strew_damage(Jitter& jitter, Outcome& outcome) {
  std::mt19937_64 random(jitter.seed());
  for (const char* file :
       {"two_boxes.v22.text.msh", "two_boxes.v41.binary.msh", "two_boxes.appended.raw.zlib.uint64.big.vtu"}) {
    const std::string whole = sim::test::read_bytes(sim::test::data_file(file));
    for (int i = 0; i < 200; ++i) {
      std::string bytes = i % 2 == 0 ? whole.substr(0, random() % whole.size()) : whole;
      if (!bytes.empty()) bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
      try {
        reading(bytes);
      } catch (const std::exception& error) {
        outcome.faults.push_back(fmt::format("{}: {}", file, error.what()));
      }
    }
  }
}

}  // namespace

Outcome damaged_files(Jitter& jitter) {
  const std::string sound = sim::test::to_msh2(jitter.of(sim::test::box_mesh(1, 1, 1, Vec3(1, 1, 1)), 1.0));
  Outcome outcome{.limit = 1e4};  // of the mesh and of messages; a billion elements would take some 32 GB
  outcome.expect(reading(sound).empty(), "the sound file is refused");
  std::string with_crlf;
  for (const char c : sound) with_crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  outcome.expect(reading(with_crlf).empty(), "CRLF is refused");
  std::string with_commas = sound;
  std::replace(with_commas.begin() + static_cast<std::ptrdiff_t>(sound.find("$Nodes")), with_commas.end(),
               '.', ',');
  for (const std::string& bad :
       {std::string(),
        std::string("\x7f"
                    "ELF\0\1\2",
                    7),
        sound.substr(0, sound.find("$EndElements")), sound.substr(0, sound.size() / 2),
        replaced(sound, "$Nodes\n8", "$Nodes\neight"),
        jitter.exact() ? replaced(sound, "\n8 1 1 1", "\n8 1,0 1 1") : with_commas}) {
    const std::string refusal = reading(bad);
    outcome.expect(names_its_place(refusal), "refusal: " + refusal);
  }
  for (const char* claim : {"$Elements\n1000000000", "$Elements\n2147483647"}) {
    const std::string huge = replaced(sound, "$Elements\n6", claim);
    std::string refusal;
    const auto taken = palpate::test::heap_use([&] { refusal = reading(huge); });
    outcome.expect(says(refusal, "elements are claimed"), "refusal: " + refusal);
    outcome.figure = std::max(outcome.figure, static_cast<double>(taken.bytes));
  }
  strew_damage(jitter, outcome);
  return outcome;
}

}  // namespace palpate::hard_cases
