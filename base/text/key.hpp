#pragma once

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/enum_words.hpp"
#include "base/text/quantity.hpp"

namespace palpate::base {

// A key of a file is described once. Its reader (TomlReader), what messages say is accepted, the reference for
// those who write files, and the file that `palpate new` writes are all made from that.

/// A word that a key accepts, and what it stands for: a clause, empty where the word says it.
struct Word {
  std::string_view word{}, meaning{};
};

/// Words that a key accepts, and words of a later version, which are refused as such.
struct Words {
  std::vector<Word> now{};
  std::vector<std::string_view> later{};
};

inline constexpr std::array<std::string_view, 0> kNoWords{};

/// The words of an enumeration, as Takes::words names them.
template <const auto& words, const auto& later = kNoWords>
Words words_of() {
  Words all{.now = {}, .later = {later.begin(), later.end()}};
  for (const auto& known : words) all.now.push_back({known.word, known.meaning});
  return all;
}

/// Where a number must be, in SI. Only finite numbers are ever accepted.
struct Bounds {
  double least = -INFINITY, most = INFINITY;
  bool open = false;  // the ends themselves are refused
};
inline constexpr Bounds kAnyNumber{};
inline constexpr Bounds kPositive{.least = 0.0, .open = true};
inline constexpr Bounds kNotNegative{.least = 0.0};

/// What stands at a key.
struct Takes {
  enum class Kind {
    Text,
    Texts,
    Word,
    Boolean,
    Number,
    Whole,       // a whole number
    Numbers,     // three
    Quantity,    // with its unit
    Quantities,  // three
    Table,
    Other,
  };
  Kind kind = Kind::Text;
  Bounds bounds{};        // of a number, a whole number, a quantity
  Dimension dimension{};  // of quantities
  Words (*words)() = nullptr;
  std::string_view accepted{};  // of a table or of another value, in words: "a table [task]"
};

inline constexpr Takes kText{.kind = Takes::Kind::Text};
inline constexpr Takes kTexts{.kind = Takes::Kind::Texts};
inline constexpr Takes kBoolean{.kind = Takes::Kind::Boolean};
inline constexpr Takes kThreeNumbers{.kind = Takes::Kind::Numbers};
constexpr Takes takes_word(Words (*words)()) {
  return {.kind = Takes::Kind::Word, .words = words};
}
constexpr Takes takes_number(const Bounds& bounds) {
  return {.kind = Takes::Kind::Number, .bounds = bounds};
}
constexpr Takes takes_whole(double least, double most) {
  return {.kind = Takes::Kind::Whole, .bounds = {.least = least, .most = most}};
}
constexpr Takes takes_quantity(Dimension dimension, const Bounds& bounds = kAnyNumber) {
  return {.kind = Takes::Kind::Quantity, .bounds = bounds, .dimension = dimension};
}
constexpr Takes takes_three(Dimension dimension) {
  return {.kind = Takes::Kind::Quantities, .dimension = dimension};
}
constexpr Takes takes_table(std::string_view accepted) {
  return {.kind = Takes::Kind::Table, .accepted = accepted};
}
/// A value that its reader looks into by itself.
constexpr Takes takes_other(std::string_view accepted) {
  return {.kind = Takes::Kind::Other, .accepted = accepted};
}

/// One key of a table. It is required where it has neither `fallback` nor `absent`.
struct Key {
  std::string_view name{};
  Takes takes{};
  std::string_view example{};   // its value as TOML: "\"5 mm\""; of kAnyName a whole line
  std::string_view fallback{};  // the value as TOML that stands where the key is left out
  std::string_view absent{};  // what leaving it out means, where no value says that: "the whole free surface"
  std::string_view meaning{};  // one or two sentences

  // For the example file and the reference.
  std::string_view along{};       // lines that the example needs beside it: "kind = \"pad\""
  std::string_view instead_of{};  // the key that it takes the place of
  bool in_use = false;            // may be left out, and the example file has it nevertheless
};

/// The name of a key that stands for every name: [conditions.NAME].
inline constexpr std::string_view kAnyName = "NAME";

constexpr bool is_required(const Key& key) {
  return key.fallback.empty() && key.absent.empty();
}

/// " > 0", " from 0 to 1", " greater than 0 and less than 1", " >= 0.5 s"; empty where any will do.
std::string bounds_in_words(const Bounds& bounds, std::string_view unit);

/// What a key accepts, as messages say it: "a number from 0 to 1", "a quantity > 0 such as \"5 mm\"".
std::string accepted(const Key& key);

/// "none, sibille, kuroda"
std::string accepted(const Words& words);

}  // namespace palpate::base
