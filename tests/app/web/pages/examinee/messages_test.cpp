#include "app/web/pages/examinee/messages.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

namespace palpate::app {
namespace {

TEST(ProbeMessage, HasOneSizeAndWholeMicrometres) {
  const std::string bytes =
      encode_probe({.depth = 1234.4e-6, .begun = true, .may_finish = false, .over = true}, 0x01020304);
  EXPECT_EQ(bytes, std::string("\x02\x05\0\0\x04\x03\x02\x01\xD2\x04\0\0", 12));  // 1234 = 0x04D2
  EXPECT_EQ(encode_probe({.depth = 1e300}, 0).size(), 12U);
}

TEST(HandMessage, IsReadBack) {
  const auto hand = parse_hand(std::string("\x01\0\0\0\x07\0\0\0\x18\xFC\xFF\xFF", 12));  // -1000 micrometres
  ASSERT_TRUE(hand);
  EXPECT_EQ(hand->id, 7U);
  EXPECT_DOUBLE_EQ(hand->depth, -1e-3);
}

TEST(HandMessage, OfAnotherSizeOrKindIsNone) {
  EXPECT_FALSE(parse_hand(""));
  EXPECT_FALSE(parse_hand(std::string(11, '\x01')));
  EXPECT_FALSE(parse_hand(std::string(12, '\x02')));
}

TEST(Reply, IsReadBack) {
  const auto reply = parse_reply(R"({"type":"answer","id":9,"choice":2,"ms":812.5})");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->kind, ReplyKind::Answer);
  EXPECT_EQ(reply->choice, 2);
  EXPECT_DOUBLE_EQ(reply->milliseconds, 812.5);
}

TEST(Reply, ThatOursNeverSendsIsNone) {
  for (const std::string_view text :
       {"", "[]", "{}", "{\"type\":\"answer\",\"id\":1}", R"({"type":"reveal","id":1})",
        R"({"type":"continue"})", R"({"type":"continue","id":"1"})", R"({"type":"early","id":1,"key":2})",
        "\xff", "{\"type\":\"continue\",\"id\":1"})
    EXPECT_FALSE(parse_reply(text)) << text;
  EXPECT_FALSE(parse_reply(R"({"type":"strategy","id":1,"text":")" + std::string(9000, 'x') + R"("})"));
}

// Each of them would otherwise count as something else: 1.9 and true as choice 1, 2^32 + 1 as showing 1.
TEST(Reply, WithANumberOrTextThatOursNeverHoldsIsNone) {
  for (const std::string_view choice :
       {"1.9", "1.0", "true", "-1", "4294967297", "18446744073709551617", "null"})
    EXPECT_FALSE(parse_reply(fmt::format(R"({{"type":"answer","id":9,"choice":{},"ms":812.5}})", choice)))
        << choice;
  for (const std::string_view id : {"4294967296", "4294967297", "1.0", "1.5", "true", "-1", "-4294967295"})
    EXPECT_FALSE(parse_reply(fmt::format(R"({{"type":"continue","id":{}}})", id))) << id;
  for (const std::string_view ms : {"true", "\"1\"", "null"})
    EXPECT_FALSE(parse_reply(fmt::format(R"({{"type":"answer","id":9,"choice":1,"ms":{}}})", ms))) << ms;
  for (const std::string_view key : {R"(\u0000)", R"(a\u0000b)", R"(\u001b)", R"(\u007f)"}) {
    EXPECT_FALSE(parse_reply(fmt::format(R"({{"type":"early","id":1,"key":"{}"}})", key))) << key;
    EXPECT_FALSE(parse_reply(fmt::format(R"({{"type":"strategy","id":1,"text":"{}"}})", key))) << key;
  }
  EXPECT_EQ(parse_reply(R"({"type":"continue","id":4294967295})")->id, 4294967295U);
  EXPECT_EQ(parse_reply(R"({"type":"strategy","id":1,"text":"two\nlines"})")->text, "two\nlines");
}

TEST(PhaseMessage, SaysWhatIsToBeShownAndNothingElse) {
  constexpr std::string_view kKeys[] = {"1", "ArrowLeft"};
  const trials::Choice choices[] = {{.label = "The first", .keys = kKeys}};
  EXPECT_EQ(
      encode(PhaseMessage{.id = 3,
                          .phase = "question",
                          .number = 3,
                          .questions = 8,
                          .minutes = 4,
                          .question = "Which?",
                          .run_mode = "pilot",
                          .presses = {1, 5},
                          .choices = choices,
                          .hint = "Press 1.",
                          .spoken_hint = "Press one."}),
      R"({"type":"phase","id":3,"phase":"question","interval":0,"intervals":2,"number":3,"questions":8,"minutes":4,)"
      R"("question":"Which?","run_mode":"pilot","pseudo_haptic":true,"picture":false,"notice":"","presses":[1,5],)"
      R"("choices":[{"label":"The first","keys":["1","ArrowLeft"]}],"hint":"Press 1.","spoken_hint":"Press one."})");
}

// Without feedback its fields are not there at all: the test above holds every byte.
TEST(PhaseMessage, OfAStudyWithFeedbackSaysSoAndTellsTheRightAnswerInItsPhaseAlone) {
  const std::string plain = encode(PhaseMessage{.phase = "ready"});
  std::string asking = encode(PhaseMessage{.phase = "ready", .gives_feedback = true});
  EXPECT_EQ(asking, plain.substr(0, plain.size() - 1) + R"(,"gives_feedback":true})");
  const std::string telling = encode(PhaseMessage{
      .phase = "feedback", .gives_feedback = true, .feedback = Feedback{.right = false, .answer = 2}});
  EXPECT_TRUE(telling.ends_with(R"(,"gives_feedback":true,"feedback":{"right":false,"answer":2}})"))
      << telling;
}

}  // namespace
}  // namespace palpate::app
