#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "app/loop/haptic_loop.hpp"
#include "app/web/pages/examinee/messages.hpp"
#include "app/web/pages/examinee/stages.hpp"
#include "app/web/server/frames.hpp"
#include "sim/model/model.hpp"
#include "trials/protocol/stimuli.hpp"
#include "trials/session/session.hpp"

namespace palpate::app {

/// What can be pressed in a sitting: compiled once, before the page opens.
struct Organs {
  trials::Stimuli stimuli;  // one for each of Protocol::stimuli
  sim::Model practice;      // the scene as its file has it, for practising the movement
};

/// Where a sitting speaks to.
struct Outlets {
  std::function<void(std::string)> text;               // to the page
  std::function<void(std::string)> binary;             // to the page
  std::function<void(const std::string&)> technician;  // a line on the terminal: never condition nor model
  std::function<void()> finished;                      // nothing more is to come
};

/// Leads an examinee through a session: which phase is shown, what the loop runs, what is stored. It knows
/// neither sockets nor timers: poll() is called at a fixed rate. Not thread-safe.
class Sitting {
 public:
  using Clock = std::chrono::steady_clock;

  /// All but `outlets` must outlive the sitting. @param frames  may be null: no pictures
  Sitting(trials::Session& session, const trials::Protocol& protocol, const Organs& organs, HapticLoop& loop,
          FrameStream* frames, Outlets outlets);
  ~Sitting();

  void page_opened();
  void page_closed();
  void text_from_page(std::string_view text);
  void binary_from_page(std::string_view bytes);
  /// Once a sixtieth of a second: sends the pointer's place, begins what is due and ends what has run out.
  /// @param now  when it was to be called, so that what follows does not hang on how long anything took
  void poll(Clock::time_point now);

  /// What was being felt is stored as cut off, so that the session can be taken up again.
  void interrupt(std::string_view reason);
  bool complete() const;  // every question is answered

 private:
  enum class Next { Nothing, Outcome, Interval, EndOfFeedback };  // what is due by the clock
  struct Answered {                                               // the question that feedback is on
    int number = 0;
    Feedback feedback{};
  };

  void enter(Stage stage);
  void show();
  PhaseMessage message() const;
  bool shows_organs() const;
  void schedule(Next next, Clock::time_point when);

  void make_engine(const sim::Model& model, const IntervalLimits& limits);
  void run_engine();
  void prepare_interval();
  trials::LoopTiming release_engine();
  trials::IntervalRecord release_record();
  void begin_interval();
  void end_interval(Clock::time_point ended);
  void show_outcome(Clock::time_point now);
  void report_fault();

  void receive(const Reply& reply);
  void go_on();
  void answer(const Reply& reply);
  void give_feedback(const Answered& answered);
  void leave_answer();
  void note_early_key(const Reply& reply);
  void tell_progress();

  trials::Session& session_;
  const trials::Protocol& protocol_;
  const Organs& organs_;
  HapticLoop& loop_;
  FrameStream* frames_;
  Outlets outlets_;

  Stage stage_ = Stage::Welcome;
  std::uint32_t id_ = 0;                    // of the showing
  trials::Phase shown_phase_{};             // that it shows, in Stage::Trial
  std::uint32_t sequence_ = 0;              // of messages about the pointer
  std::unique_ptr<IntervalEngine> engine_;  // of the interval that comes or runs, or of the last one
  bool connected_ = false;
  std::string notice_;
  Answered answered_{};        // in Stage::Feedback
  std::string onset_utc_;      // of the interval or the question
  Clock::time_point shown_{};  // of this showing
  Next next_ = Next::Nothing;
  Clock::time_point due_{};
  int early_keys_ = 0;
};

}  // namespace palpate::app
