#include "app/web/pages/examinee/stages.hpp"

#include "base/text/enum_words.hpp"

namespace palpate::app {
namespace {

using trials::Phase;

constexpr base::EnumWords<Stage, 8> kNames{{{Stage::Welcome, "welcome"},
                                            {Stage::Gesture, "gesture"},
                                            {Stage::Trial, "trial"},
                                            {Stage::Again, "again"},
                                            {Stage::Feedback, "feedback"},
                                            {Stage::Thanks, "thanks"},
                                            {Stage::End, "end"},
                                            {Stage::Fault, "fault"}}};

}  // namespace

std::string_view shown_name(Stage stage, Phase phase) {
  return stage == Stage::Trial ? trials::to_string(phase) : base::word_of(kNames, stage);
}

bool takes(Stage stage, Phase phase, ReplyKind kind) {
  switch (kind) {
    case ReplyKind::Continue:
      return onward_from(stage, phase) != Onward::Nowhere;
    case ReplyKind::Finish:
      return stage == Stage::Trial && phase == Phase::Interval;
    case ReplyKind::Answer:
      return stage == Stage::Trial && phase == Phase::Question;
    case ReplyKind::Early:
      return stage == Stage::Trial;
    case ReplyKind::Strategy:
      return stage == Stage::Thanks;
  }
  return false;
}

Onward onward_from(Stage stage, Phase phase) {
  switch (stage) {
    case Stage::Welcome:
      return Onward::ToGesture;
    case Stage::Gesture:
    case Stage::Fault:
      return Onward::ToTrial;
    case Stage::Again:
      return Onward::IntoInterval;
    case Stage::Trial:
      return phase == Phase::Ready ? Onward::IntoInterval : Onward::Nowhere;
    case Stage::Feedback:
    case Stage::Thanks:
    case Stage::End:
      return Onward::Nowhere;
  }
  return Onward::Nowhere;
}

bool is_pressing(Stage stage, Phase phase) {
  return stage == Stage::Gesture || (stage == Stage::Trial && phase == Phase::Interval);
}

}  // namespace palpate::app
