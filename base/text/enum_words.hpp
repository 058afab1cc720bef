#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::base {

/// An enumerator and the word that files, columns and messages have for it.
template <class Enum>
struct EnumWord {
  Enum value;
  std::string_view word;
  std::string_view
      meaning{};  // what the word stands for in a file, a clause; empty where it says that itself
};

/// The words of an enumeration, all of them, each once: one table serves writing, reading and messages.
template <class Enum, std::size_t count>
using EnumWords = std::array<EnumWord<Enum>, count>;

/// The word of a value; empty for one that is not in the table.
template <class Enum, std::size_t count>
constexpr std::string_view word_of(const EnumWords<Enum, count>& words, Enum value) {
  for (const EnumWord<Enum>& known : words)
    if (known.value == value) return known.word;
  return {};
}

/// The value that a word stands for; nothing where it stands for none.
template <class Enum, std::size_t count>
constexpr std::optional<Enum> value_of(const EnumWords<Enum, count>& words, std::string_view word) {
  for (const EnumWord<Enum>& known : words)
    if (known.word == word) return known.value;
  return std::nullopt;
}

/// "none, sibille, kuroda": what a message says is accepted.
template <class Enum, std::size_t count>
std::string accepted_words(const EnumWords<Enum, count>& words) {
  std::string text;
  for (const EnumWord<Enum>& known : words) text += fmt::format("{}{}", text.empty() ? "" : ", ", known.word);
  return text;
}

}  // namespace palpate::base
