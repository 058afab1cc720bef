#include "app/web/pages/examinee/messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

namespace palpate::app {
namespace {

constexpr unsigned char kHand = 1, kProbe = 2, kFrame = 3;
constexpr std::size_t kBinarySize = 12;
constexpr std::size_t kLongestText = 8000;  // of a strategy [byte]

template <typename Integer>
void put(std::string& bytes, std::size_t at, Integer value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);  // little-endian, as study files are
}

template <typename Integer>
Integer get(std::string_view bytes, std::size_t at) {
  Integer value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::optional<ReplyKind> kind_of(const std::string& type) {
  if (type == "continue") return ReplyKind::Continue;
  if (type == "finish") return ReplyKind::Finish;
  if (type == "answer") return ReplyKind::Answer;
  if (type == "early") return ReplyKind::Early;
  if (type == "strategy") return ReplyKind::Strategy;
  return std::nullopt;
}

/// A number as the page writes it: whole, not below 0 and no larger than its kind holds. JSON's 1.9, true and
/// 2^32 + 1 are none.
template <typename Integer>
std::optional<Integer> whole_number(const nlohmann::json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (!std::in_range<Integer>(number)) return std::nullopt;
  return static_cast<Integer>(number);
}

/// Whether it holds no control characters but line breaks and tabs: a NUL would end it early for other
/// readers of the study file.
bool is_text(std::string_view text) {
  return std::ranges::none_of(
      text, [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\r' && c != '\t') || c == 0x7F; });
}

nlohmann::ordered_json choices_json(std::span<const trials::Choice> choices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const trials::Choice& choice : choices)
    list.push_back({{"label", choice.label}, {"keys", choice.keys}});
  return list;
}

}  // namespace

std::string encode(const PhaseMessage& message) {
  nlohmann::ordered_json json = {{"type", "phase"},
                                 {"id", message.id},
                                 {"phase", message.phase},
                                 {"interval", message.interval},
                                 {"intervals", message.intervals},
                                 {"number", message.number},
                                 {"questions", message.questions},
                                 {"minutes", message.minutes},
                                 {"question", message.question},
                                 {"run_mode", message.run_mode},
                                 {"pseudo_haptic", message.pseudo_haptic},
                                 {"picture", message.picture},
                                 {"notice", message.notice},
                                 {"presses", message.presses},
                                 {"choices", choices_json(message.choices)},
                                 {"hint", message.hint},
                                 {"spoken_hint", message.spoken_hint}};
  if (message.gives_feedback) json["gives_feedback"] = true;
  if (message.feedback)
    json["feedback"] = {{"right", message.feedback->right}, {"answer", message.feedback->answer}};
  return json.dump();
}

std::string encode_probe(const IntervalState& state, std::uint32_t sequence) {
  std::string bytes(kBinarySize, '\0');
  bytes[0] = static_cast<char>(kProbe);
  bytes[1] = static_cast<char>((state.begun ? 1 : 0) | (state.may_finish ? 2 : 0) | (state.over ? 4 : 0) |
                               (state.deep_enough ? 8 : 0));
  bytes[2] = static_cast<char>(std::min(state.presses, 255));
  bytes[3] = static_cast<char>(static_cast<int>(std::clamp(std::ceil(state.time_left), 0.0, 255.0)));
  put(bytes, 4, sequence);
  put(bytes, 8, static_cast<std::int32_t>(std::lround(std::clamp(state.depth, -1.0, 1.0) * 1e6)));
  return bytes;
}

std::string encode_frame(std::string_view jpeg) {
  std::string bytes(1, static_cast<char>(kFrame));
  return bytes.append(jpeg);
}

std::optional<HandMessage> parse_hand(std::string_view bytes) {
  if (bytes.size() != kBinarySize || static_cast<unsigned char>(bytes[0]) != kHand) return std::nullopt;
  return HandMessage{.id = get<std::uint32_t>(bytes, 4), .depth = get<std::int32_t>(bytes, 8) * 1e-6};
}

std::optional<Reply> parse_reply(std::string_view text) try {
  const auto json = nlohmann::json::parse(text);
  const auto kind = kind_of(json.at("type").get<std::string>());
  const auto id = whole_number<std::uint32_t>(json.at("id"));
  if (!kind || !id) return std::nullopt;
  Reply reply{.kind = *kind, .id = *id};
  if (reply.kind == ReplyKind::Answer) {
    const auto choice = whole_number<int>(json.at("choice"));
    const nlohmann::json& milliseconds = json.at("ms");
    if (!choice || !milliseconds.is_number()) return std::nullopt;
    reply.choice = *choice;
    reply.milliseconds = milliseconds.get<double>();
  }
  if (reply.kind == ReplyKind::Early) reply.text = json.at("key").get<std::string>();
  if (reply.kind == ReplyKind::Strategy) reply.text = json.at("text").get<std::string>();
  if (reply.text.size() > kLongestText || !is_text(reply.text)) return std::nullopt;
  return reply;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

}  // namespace palpate::app
