#include "app/web/pages/examinee/sitting.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "devices/devices.hpp"
#include "tests/app/support/palpation.hpp"
#include "tests/support/places.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;

/// A session on a study file of its own, led without a browser: the test is the page.
class SittingTest : public testing::Test {
 protected:
  explicit SittingTest(const std::string& protocol = "short.toml") {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    protocol_ = trials::load_protocol(palpate::test::source_folder() + "/tests/browser/" + protocol);
    study_.emplace(trials::open_study(folder_ / "study.db", protocol_, "test"));
    session_.emplace(trials::start_session(*study_, protocol_, facts()));
    sim::ComplianceCache cache("");
    organs_.stimuli = trials::compile_stimuli(protocol_, cache);
    organs_.practice = test::palpation("kuroda", "1.0 MPa");
    sitting_.emplace(*session_, protocol_, organs_, loop_, nullptr,
                     Outlets{.text = [this](std::string text) { hear(json::parse(text)); },
                             .binary = [this](std::string) { ++binaries_; },
                             .technician = [this](const std::string& line) { said_ += line + "\n"; },
                             .finished = [this] { finished_ = true; }});
    sitting_->page_opened();
  }
  ~SittingTest() override {
    sitting_.reset();
    std::filesystem::remove_all(folder_);
  }

  static trials::SessionFacts facts() {
    return {.examinee = "P01", .device = "mouse", .pseudo_haptic = true, .channel = "pointer lag"};
  }

  std::string phase() const { return shown_.at("phase"); }

  void hear(json message) {
    shown_ = std::move(message);
    heard_.push_back({.message = shown_});
    if (phase() == "feedback")
      heard_.back().answers_on_disk = trials::read_study(folder_ / "study.db").answers(1).size();
  }

  /// Ready -> Question.
  void feel_both() {
    explore();
    wait_for("pause");
    wait_for("interval");
    explore();
    wait_for("question");
  }

  void reply(const std::string& type, json more = json::object()) {
    more["type"] = type;
    more["id"] = shown_.at("id");
    sitting_->text_from_page(more.dump());
  }

  void hand(double millimetres) {
    std::string bytes(12, '\0');
    bytes[0] = 1;
    const auto id = shown_.at("id").get<std::uint32_t>();
    const auto depth = static_cast<std::int32_t>(millimetres * 1000);
    std::memcpy(bytes.data() + 4, &id, 4);
    std::memcpy(bytes.data() + 8, &depth, 4);
    sitting_->binary_from_page(bytes);
  }

  /// Lets time pass, the hand held somewhere.
  void hold(double millimetres, std::chrono::milliseconds time) {
    const auto until = Sitting::Clock::now() + time;
    while (Sitting::Clock::now() < until) {
      hand(millimetres);
      sitting_->poll(Sitting::Clock::now());
      std::this_thread::sleep_for(5ms);
    }
  }

  void wait_for(const std::string& wanted) {
    for (int i = 0; i < 2000 && phase() != wanted; ++i) hold(-2, 5ms);
    ASSERT_EQ(phase(), wanted);
  }

  void go_to_interval() {
    reply("continue");
    reply("continue");
    reply("continue");
    sitting_->poll(Sitting::Clock::now());  // intervals begin at a poll
    ASSERT_EQ(phase(), "interval");
  }

  void explore() {
    for (int press = 0; press < 2; ++press) {
      hold(-2, 150ms);
      hold(11, 400ms);
    }
    hold(-2, 150ms);
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("palpate-sitting-" + std::to_string(::getpid()));
  trials::Protocol protocol_;
  std::optional<trials::StudyFile> study_;
  std::optional<trials::Session> session_;
  Organs organs_;
  HapticLoop loop_{devices::open("mouse")};
  std::optional<Sitting> sitting_;
  struct Heard {
    json message{};
    std::size_t answers_on_disk = 0;  // when feedback was sent, as another reader of the file finds them
  };

  json shown_;
  std::vector<Heard> heard_;
  std::string said_;
  int binaries_ = 0;
  bool finished_ = false;
};

TEST_F(SittingTest, OneQuestionIsAskedAndStored) {
  EXPECT_EQ(phase(), "welcome");
  go_to_interval();
  explore();
  wait_for("pause");
  wait_for("interval");
  explore();
  wait_for("question");
  reply("answer", {{"choice", 2}, {"ms", 1.0}});
  EXPECT_EQ(phase(), "ready");
  ASSERT_EQ(study_->answers(1).size(), 1U);
  EXPECT_EQ(study_->answers(1)[0].response, 2);
  EXPECT_DOUBLE_EQ(study_->answers(1)[0].response_time.value(), 1e-3);
  ASSERT_EQ(study_->presentations(1).size(), 2U);
  EXPECT_TRUE(study_->presentations(1)[0].loop.has_value());
  EXPECT_TRUE(study_->presentations(1)[0].solve.has_value());
  EXPECT_NE(said_.find("1 of 4 questions answered"), std::string::npos);
}

TEST_F(SittingTest, AResponseTimeThatCannotBeIsReplacedAndNoted) {
  go_to_interval();
  explore();
  wait_for("pause");
  wait_for("interval");
  explore();
  wait_for("question");
  reply("answer", {{"choice", 1}, {"ms", 3.6e6}});  // an hour
  EXPECT_LT(study_->answers(1).at(0).response_time.value(), 60);
  EXPECT_EQ(study_->events().back().kind, "response time replaced");
}

// Two metres are no place of a hand before a screen: as from a device that has gone wrong.
TEST_F(SittingTest, AnImpossibleHandPausesTheSession) {
  go_to_interval();
  hold(-2, 100ms);
  hold(8, 300ms);
  hold(2000, 50ms);
  ASSERT_EQ(phase(), "fault");
  EXPECT_EQ(session_->phase(), trials::Phase::Ready);
  EXPECT_EQ(study_->presentations(1).at(0).verdict, trials::Verdict::Interrupted);
  reply("continue");
  EXPECT_EQ(phase(), "ready");
}

TEST_F(SittingTest, RepliesToAnotherShowingAreNotHeard) {
  const json before = shown_;
  reply("continue");
  ASSERT_EQ(phase(), "gesture");
  sitting_->text_from_page(json{{"type", "continue"}, {"id", before.at("id")}}.dump());
  EXPECT_EQ(phase(), "gesture");
  reply("answer", {{"choice", 1}, {"ms", 5}});  // no question is open
  EXPECT_EQ(phase(), "gesture");
  EXPECT_TRUE(study_->answers(1).empty());
}

// The session has the question before the page has: a client that is not ours knows the interval's id.
TEST_F(SittingTest, NoAnswerIsTakenBeforeItsQuestionIsShown) {
  go_to_interval();
  explore();
  reply("finish");
  wait_for("pause");
  wait_for("interval");
  explore();
  reply("finish");
  ASSERT_EQ(session_->phase(), trials::Phase::Question);
  ASSERT_EQ(phase(), "interval");
  reply("answer", {{"choice", 1}, {"ms", 5}});
  reply("finish");
  reply("continue");
  EXPECT_TRUE(study_->answers(1).empty());
  EXPECT_EQ(session_->phase(), trials::Phase::Question);
  wait_for("question");
  reply("answer", {{"choice", 1}, {"ms", 5}});
  EXPECT_EQ(study_->answers(1).size(), 1U);
}

TEST_F(SittingTest, AnIntervalUnderWayWhenThePageClosesIsStoredAsCutOff) {
  go_to_interval();
  hold(-2, 100ms);
  hold(8, 200ms);
  sitting_->page_closed();
  EXPECT_EQ(session_->phase(), trials::Phase::Ready);
  EXPECT_EQ(study_->presentations(1).at(0).verdict, trials::Verdict::Interrupted);
  EXPECT_GT(study_->presentations(1).at(0).samples, 0U);
  sitting_->page_opened();
  EXPECT_EQ(phase(), "ready");
  EXPECT_NE(shown_.at("notice").get<std::string>().find("interruption"), std::string::npos);
}

class SittingWithFeedback : public SittingTest {
 protected:
  SittingWithFeedback() : SittingTest("feedback.toml") {}

  /// Answers the question that is open, and waits until it has been said whether that was right.
  /// @return  for how long that was said
  std::chrono::duration<double> answer(int choice) {
    reply("answer", {{"choice", choice}, {"ms", 1.0}});
    const auto since = Sitting::Clock::now();
    EXPECT_EQ(phase(), "feedback");
    while (phase() == "feedback") hold(-2, 5ms);
    return Sitting::Clock::now() - since;
  }
};

TEST_F(SittingWithFeedback, SaysWhetherAnAnswerWasRightOnceItIsOnTheDisk) {
  go_to_interval();
  for (int question = 1; question <= 2; ++question) {
    feel_both();
    const int right = session_->trial().correct_answer;
    const int choice = question == 1 ? right : 3 - right;  // the first time right, then wrong
    const auto lasted = answer(choice);
    const Heard& told = *(heard_.rbegin() + 1);
    EXPECT_EQ(told.message.at("feedback"), (json{{"right", question == 1}, {"answer", right}}));
    EXPECT_EQ(told.answers_on_disk, static_cast<std::size_t>(question));
    EXPECT_EQ(told.message.at("number"), question);  // not the one that comes
    EXPECT_EQ(told.message.at("notice"), "");
    EXPECT_NEAR(lasted.count(), trials::kFeedbackTime, 0.5);
    EXPECT_EQ(phase(), question == 1 ? "ready" : "thanks");
    if (question == 2) break;
    EXPECT_EQ(shown_.at("notice"), "Your answer is saved.");
    reply("continue");
    sitting_->poll(Sitting::Clock::now());
  }
  for (const Heard& heard : heard_) {
    EXPECT_EQ(heard.message.contains("feedback"), heard.message.at("phase") == "feedback") << heard.message;
    EXPECT_TRUE(heard.message.at("gives_feedback"));
  }
}

TEST_F(SittingWithFeedback, IsNotEndedByAKeyAndNotSaidAgainToAPageThatComesBack) {
  go_to_interval();
  feel_both();
  reply("answer", {{"choice", 1}, {"ms", 1.0}});
  ASSERT_EQ(phase(), "feedback");
  reply("continue");
  reply("answer", {{"choice", 2}, {"ms", 1.0}});
  reply("early", {{"key", "1"}});
  EXPECT_EQ(phase(), "feedback");
  EXPECT_EQ(study_->answers(1).size(), 1U);
  sitting_->page_closed();
  sitting_->page_opened();
  EXPECT_EQ(phase(), "ready");
  EXPECT_FALSE(shown_.contains("feedback"));
  EXPECT_EQ(shown_.at("notice"), "Your answer is saved.");
  hold(-2, 100ms);
  EXPECT_EQ(phase(), "ready");
}

}  // namespace
}  // namespace palpate::app
