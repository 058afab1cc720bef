#pragma once

#include <string_view>

#include "app/web/pages/examinee/messages.hpp"
#include "trials/session/session.hpp"

namespace palpate::app {

/// What an examinee is shown. The order stands here and nowhere else; the page shows what it is told:
///
///     Welcome -> Gesture -> Trial -> ... -> Trial -> Thanks -> End
///                             ^  \-> Again (an interval that was not explored enough) -> Trial
///                             |  \-> Feedback (an answer is saved, and the protocol says so) -> Trial, Thanks
///                             \----- Fault (the input was no number)
///
/// Within Trial the session's phase says what is shown: ready, interval, pause, question. Feedback ends by the
/// clock.
enum class Stage { Welcome, Gesture, Trial, Again, Feedback, Thanks, End, Fault };

/// The name that the page knows it by: "welcome", "interval", ...
std::string_view shown_name(Stage stage, trials::Phase phase);

/// Whether a reply of this kind means anything there; all others are passed over.
bool takes(Stage stage, trials::Phase phase, ReplyKind kind);

/// What "continue" leads to.
enum class Onward { Nowhere, ToGesture, ToTrial, IntoInterval };
Onward onward_from(Stage stage, trials::Phase phase);

/// Whether the probe moves there.
bool is_pressing(Stage stage, trials::Phase phase);

}  // namespace palpate::app
