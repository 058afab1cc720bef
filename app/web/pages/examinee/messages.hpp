#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/loop/interval_engine.hpp"
#include "trials/task/task.hpp"

// What page and server say to each other; messages.ts is the other half. While an interval runs, nothing
// but fixed-size messages at a fixed rate goes to the page, and they hold nothing but the pointer's place and
// what follows from it.

namespace palpate::app {

/// What is said of an answer.
struct Feedback {
  bool right = false;
  int answer = 0;  // that was the right one, from 1
};

/// What is to be shown. Nothing here depends on condition, model or correct answer but `feedback`, which comes once
/// the answer is saved. Where the protocol calls for no feedback its two fields are not sent.
struct PhaseMessage {
  std::uint32_t id = 0;      // of this showing
  std::string_view phase{};  // "welcome", "gesture", "ready", "interval", "pause", "again", "question",
                             // "feedback", "thanks", "end", "fault"
  int interval = 0, intervals = 2;
  int number = 0, questions = 0;  // of the question, from 1; 0 when all are answered
  int minutes = 0;                // that all questions take, about
  std::string question{};
  std::string_view run_mode{};
  bool pseudo_haptic = true;
  bool picture = false;  // whether frames follow
  std::string notice{};  // a sentence to show first; may be empty
  std::array<int, 2> presses{1, 1};
  std::span<const trials::Choice> choices{};  // what can be answered; answer k is choices[k - 1]
  std::string_view hint{}, spoken_hint{};     // how to answer, to read and to hear
  bool gives_feedback = false;                // whether this study says after each answer if it was right
  std::optional<Feedback> feedback{};         // in the phase "feedback" alone
};
std::string encode(const PhaseMessage& message);

/// Pointer and progress, 12 bytes; the depth in whole micrometres. But for the depth all follows from the hand.
std::string encode_probe(const IntervalState& state, std::uint32_t sequence);

/// A JPEG picture behind one byte that says so.
std::string encode_frame(std::string_view jpeg);

struct HandMessage {
  std::uint32_t id = 0;  // of the showing that the page was in
  double depth = 0.0;    // [m]
};
/// Nothing for bytes that are no hand message.
std::optional<HandMessage> parse_hand(std::string_view bytes);

enum class ReplyKind { Continue, Finish, Answer, Early, Strategy };
struct Reply {
  ReplyKind kind = ReplyKind::Continue;
  std::uint32_t id = 0;        // of the showing that it replies to
  int choice = 0;              // of an answer
  double milliseconds = -1.0;  // of an answer: from the question's onset, as the page measured
  std::string text{};          // the key, or the strategy
};
/// Nothing for text that is no reply: a page of ours never sends it.
std::optional<Reply> parse_reply(std::string_view text);

}  // namespace palpate::app
