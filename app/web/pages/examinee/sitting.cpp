#include "app/web/pages/examinee/sitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/web/pages/examinee/advice.hpp"
#include "base/clock/utc.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;

// From the end of an interval until the page hears what comes next: longer than the disk needs, so that the
// moment tells nothing about what was stored.
constexpr auto kOutcomeAfter = 250ms;
constexpr auto kPause = std::chrono::milliseconds(static_cast<int>(1000 * trials::kPauseBetweenIntervals));
constexpr auto kFeedback = std::chrono::milliseconds(static_cast<int>(1000 * trials::kFeedbackTime));
constexpr int kMostEarlyKeys = 1000;  // noted in one sitting; more than that is a book on the keyboard

constexpr std::string_view kPageClosed = "the page was closed or its connection was lost";

IntervalLimits limits_of(const trials::Exploration& rule) {
  return {.least_presses = rule.least_presses,
          .most_presses = rule.most_presses,
          .min_depth = rule.min_depth,
          .max_time = rule.max_time};
}

}  // namespace

Sitting::Sitting(trials::Session& session, const trials::Protocol& protocol, const Organs& organs,
                 HapticLoop& loop, FrameStream* frames, Outlets outlets)
    : session_(session),
      protocol_(protocol),
      organs_(organs),
      loop_(loop),
      frames_(frames),
      outlets_(std::move(outlets)) {
  if (session_.view().resumed)
    notice_ = session_.answered() > 0
                  ? "Welcome back. Your earlier answers are saved, and we go on from there."
                  : "Welcome back.";
  if (complete()) stage_ = Stage::Thanks;
}

Sitting::~Sitting() {
  release_engine();
}

bool Sitting::complete() const {
  return session_.phase() == trials::Phase::Finished;
}

// ---- What is shown ----

PhaseMessage Sitting::message() const {
  const trials::SessionView view = session_.view();
  const bool on_answer = stage_ == Stage::Feedback;  // the session is at the next question already
  return {.id = id_,
          .phase = shown_name(stage_, view.phase),
          .interval = view.interval,
          .intervals = view.intervals,
          .number = on_answer ? answered_.number : view.number,
          .questions = view.questions,
          .minutes = trials::minutes_of(protocol_),
          .question = view.question,
          .run_mode = trials::to_string(view.run_mode),
          .pseudo_haptic = view.pseudo_haptic,
          .picture = frames_ != nullptr && is_pressing(stage_, view.phase) && shows_organs(),
          .notice = notice_,
          .presses = {protocol_.exploration.least_presses, protocol_.exploration.most_presses},
          .choices = view.choices,
          .hint = view.hint,
          .spoken_hint = view.spoken_hint,
          .gives_feedback = protocol_.feedback,
          .feedback = on_answer ? std::optional(answered_.feedback) : std::nullopt};
}

/// In practice always, in an interval where the protocol says so.
bool Sitting::shows_organs() const {
  return stage_ == Stage::Gesture || protocol_.during_interval == trials::DuringInterval::Organs;
}

void Sitting::show() {
  ++id_;
  shown_phase_ = session_.phase();
  shown_ = Clock::now();
  if (connected_) outlets_.text(encode(message()));
}

void Sitting::enter(Stage stage) {
  release_engine();
  next_ = Next::Nothing;
  stage_ = stage;
  if (stage == Stage::Gesture && connected_) {
    make_engine(organs_.practice, {});
    run_engine();
  }
  show();
  prepare_interval();
}

void Sitting::schedule(Next next, Clock::time_point when) {
  next_ = next;
  due_ = when;
}

// ---- The page comes and goes ----

void Sitting::page_opened() {
  connected_ = true;
  outlets_.technician("The examinee's page is open.");
  enter(stage_);
}

void Sitting::page_closed() {
  connected_ = false;
  interrupt(kPageClosed);
  if (stage_ != Stage::End)
    outlets_.technician("The examinee's page is closed; open the link again to go on.");
}

void Sitting::interrupt(std::string_view reason) {
  next_ = Next::Nothing;
  if (stage_ == Stage::Feedback) leave_answer();  // it is not said again
  const trials::Phase phase = session_.phase();
  if (phase == trials::Phase::Ready || phase == trials::Phase::Finished) {
    release_engine();
    return;
  }
  session_.interrupt(release_record(), reason);
  stage_ = Stage::Trial;
  notice_ = "There was an interruption. Your answers are saved, and this question starts anew.";
}

// ---- Intervals ----

void Sitting::make_engine(const sim::Model& model, const IntervalLimits& limits) {
  release_engine();
  engine_ = std::make_unique<IntervalEngine>(model, limits, loop_.device());
}

/// While the examinee rests: how long it takes hangs on the contact model, and nobody is to wait for it.
void Sitting::prepare_interval() {
  const trials::Phase phase = session_.phase();
  const bool rests = phase == trials::Phase::Ready || phase == trials::Phase::Pause;
  if (!connected_ || !rests || (stage_ != Stage::Trial && stage_ != Stage::Again)) return;
  make_engine(*organs_.stimuli.at(session_.stimulus()), limits_of(protocol_.exploration));
}

void Sitting::run_engine() {
  loop_.forget_hand();
  loop_.run(*engine_);
  if (frames_ != nullptr && shows_organs()) frames_->show(&engine_->felt());
}

/// The engine stays until the next one is made, for its trace.
trials::LoopTiming Sitting::release_engine() {
  if (frames_ != nullptr) frames_->show(nullptr);
  return loop_.stop();
}

trials::IntervalRecord Sitting::release_record() {
  const trials::LoopTiming timing = release_engine();
  trials::IntervalRecord record{.onset_utc = onset_utc_};
  if (!engine_) return record;
  record.trace = engine_->trace();
  if (timing.rate_hz > 0) {
    record.loop = timing;
    record.solve = engine_->solve_record();
  }
  return record;
}

/// The page hears of it before the loop has its first cycle, for a cycle takes as long as the contact model.
void Sitting::begin_interval() {
  session_.begin_interval();
  notice_.clear();
  stage_ = Stage::Trial;
  onset_utc_ = base::utc_now();
  show();
  run_engine();
}

/// @param ended  before anything is stored, which takes its time
void Sitting::end_interval(Clock::time_point ended) {
  const trials::Verdict verdict = session_.end_interval(release_record());
  notice_ = advice(verdict, protocol_.exploration);
  schedule(Next::Outcome, ended + kOutcomeAfter);
}

void Sitting::show_outcome(Clock::time_point now) {
  if (!notice_.empty()) return enter(Stage::Again);
  enter(Stage::Trial);
  if (session_.phase() == trials::Phase::Pause) schedule(Next::Interval, now + kPause);
  if (session_.phase() == trials::Phase::Question) onset_utc_ = base::utc_now();
}

void Sitting::report_fault() {
  outlets_.technician(
      "The input was no position that a hand can have. The force is off and the session waits: see to the "
      "device, then let the examinee go on.");
  interrupt("fault: the input was no number");
  notice_.clear();
  enter(Stage::Fault);
}

void Sitting::poll(Clock::time_point now) {
  if (next_ != Next::Nothing && now >= due_) {
    const Next next = std::exchange(next_, Next::Nothing);
    if (next == Next::Outcome) show_outcome(now);
    if (next == Next::Interval) begin_interval();
    if (next == Next::EndOfFeedback) {
      leave_answer();
      enter(stage_);
    }
    return;
  }
  if (!is_pressing(stage_, session_.phase())) return;
  const IntervalState state = loop_.state();
  if (connected_) outlets_.binary(encode_probe(state, ++sequence_));
  if (!state.begun) onset_utc_ = base::utc_now();  // the trace begins when the hand has left the skin
  if (state.fault != Fault::None) return report_fault();
  if (stage_ == Stage::Trial && state.over) end_interval(now);
}

// ---- What the page says ----

void Sitting::binary_from_page(std::string_view bytes) {
  const auto hand = parse_hand(bytes);
  if (hand && hand->id == id_ && is_pressing(stage_, shown_phase_)) loop_.set_hand(hand->depth);
}

void Sitting::text_from_page(std::string_view text) {
  const auto reply = parse_reply(text);
  if (reply && reply->id == id_) receive(*reply);
}

/// Nothing is taken but what the page has been shown to ask for. Between an interval's end and what follows it,
/// the session is already further than the page.
void Sitting::receive(const Reply& reply) {
  if (!takes(stage_, shown_phase_, reply.kind)) return;
  if (next_ == Next::Outcome && reply.kind != ReplyKind::Early) return;
  switch (reply.kind) {
    case ReplyKind::Continue:
      return go_on();
    case ReplyKind::Finish:
      if (loop_.state().may_finish) end_interval(Clock::now());
      return;
    case ReplyKind::Answer:
      return answer(reply);
    case ReplyKind::Early:
      return note_early_key(reply);
    case ReplyKind::Strategy:
      if (!reply.text.empty()) session_.note(trials::event_kind::kStrategy, reply.text);
      enter(Stage::End);
      outlets_.finished();
      return;
  }
}

void Sitting::go_on() {
  switch (onward_from(stage_, session_.phase())) {
    case Onward::ToGesture:
      notice_.clear();
      outlets_.technician("The examinee is practising the movement.");
      return enter(Stage::Gesture);
    case Onward::ToTrial:
      return enter(Stage::Trial);
    case Onward::IntoInterval:  // at the next poll, as every interval
      return schedule(Next::Interval, Clock::now());
    case Onward::Nowhere:
      return;
  }
}

void Sitting::answer(const Reply& reply) {
  if (reply.choice < 1 || reply.choice > std::ssize(session_.view().choices)) return;
  // The page measures from the painted question. It cannot have taken longer than we know of.
  const double waited = std::chrono::duration<double>(Clock::now() - shown_).count();
  const double measured = reply.milliseconds * 1e-3;
  const bool plausible = measured >= 0 && measured <= waited;
  if (!plausible)
    session_.note(
        "response time replaced",
        fmt::format("the page measured {} s of {} s; the program's own is stored", measured, waited));
  const int right = session_.trial().correct_answer;
  const Answered answered{.number = session_.view().number,
                          .feedback = {.right = reply.choice == right, .answer = right}};
  session_.answer(reply.choice, plausible ? measured : waited, onset_utc_);
  tell_progress();
  if (protocol_.feedback) return give_feedback(answered);
  leave_answer();
  enter(stage_);
}

/// As long whatever was answered. What comes next is prepared afterwards: how long that takes hangs on the model.
void Sitting::give_feedback(const Answered& answered) {
  answered_ = answered;
  enter(Stage::Feedback);
  schedule(Next::EndOfFeedback, shown_ + kFeedback);
}

/// To what follows an answer, without showing it yet.
void Sitting::leave_answer() {
  if (!complete()) notice_ = "Your answer is saved.";
  stage_ = complete() ? Stage::Thanks : Stage::Trial;
}

void Sitting::note_early_key(const Reply& reply) {
  const bool answers = std::ranges::any_of(session_.view().choices, [&](const trials::Choice& choice) {
    return std::ranges::find(choice.keys, reply.text) != choice.keys.end();
  });
  if (!answers || ++early_keys_ > kMostEarlyKeys) return;
  const double after = std::chrono::duration<double>(Clock::now() - shown_).count();
  session_.note(trials::event_kind::kEarlyKey,
                fmt::format("{} during {}, {:.3f} s after it was shown", reply.text,
                            shown_name(stage_, shown_phase_), after));
}

void Sitting::tell_progress() {
  outlets_.technician(fmt::format("{} of {} questions answered.", session_.answered(),
                                  trials::trials_per_session(protocol_)));
}

}  // namespace palpate::app
