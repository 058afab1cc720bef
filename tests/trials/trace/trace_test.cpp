#include "trials/trace/trace.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <regex>
#include <stdexcept>

#include "base/clock/utc.hpp"
#include "tests/trials/support/files.hpp"

namespace palpate::trials {
namespace {

/// A trace of depths given in millimetres, pushed back by 1 N where the finger is in the body.
Trace trace_of(const std::vector<double>& depths_mm) {
  Trace trace;
  for (const double depth : depths_mm)
    trace.push_back({.time = static_cast<float>(trace.size()) * 1e-3F,
                     .proposed_depth = static_cast<float>(1e-3 * depth),
                     .depth = static_cast<float>(1e-3 * depth),
                     .displacement = {},
                     .force = {depth > 0 ? 0.6F : 0.0F, 0.0F, depth > 0 ? 0.8F : 0.0F}});
  return trace;
}

RC_GTEST_PROP(Trace, ComesBackAsItWasStored, ()) {
  const auto values = *rc::gen::container<std::vector<float>>(
      rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int i) { return static_cast<float>(i) * 1e-5F; }));
  Trace trace;
  for (const float v : values)
    trace.push_back(
        {.time = v, .proposed_depth = 2 * v, .depth = -v, .displacement = {v, 1, v}, .force = {0, v, 3}});
  RC_ASSERT(decode(encode(trace), trace.size()) == trace);
}

TEST(Trace, DamagedBytesAreRefused) {
  const Trace trace = trace_of({0, 1, 2, 3, 2, 1, 0});
  std::string bytes = encode(trace);
  EXPECT_THROW(decode(bytes, trace.size() + 1), std::invalid_argument);
  EXPECT_THROW(decode(bytes.substr(0, bytes.size() / 2), trace.size()), std::invalid_argument);
  EXPECT_THROW(decode("", 4000000000U), std::invalid_argument);  // no memory is taken for a false claim
  bytes[bytes.size() / 2] = static_cast<char>(~bytes[bytes.size() / 2]);
  EXPECT_THROW(decode(bytes, trace.size()), std::invalid_argument);
}

TEST(Trace, PressesAreCountedWithoutTrembling) {
  // Trembling around the threshold of 0.5 mm is one press until the finger is back below 0.25 mm.
  const ExplorationSummary summary =
      summarise(trace_of({0, 0.4, 0.2, 0, 0.6, 0.4, 0.6, 4.0, 0.4, 0.1, 0, 2.0, 3.0, 2.0}));
  EXPECT_EQ(summary.presses, 2);
  EXPECT_FLOAT_EQ(static_cast<float>(summary.max_depth), 4e-3F);
  EXPECT_NEAR(summary.peak_force, 1.0, 1e-7);  // |(0.6, 0, 0.8)|, single precision
  EXPECT_NEAR(summary.time, 13e-3, 1e-9);
}

TEST(Trace, DepthWithoutForceIsNoContact) {
  Trace trace = trace_of({0, 2, 4, 2});
  trace[2].force = {0, 0, 0};
  EXPECT_FLOAT_EQ(static_cast<float>(summarise(trace).max_depth), 2e-3F);
}

TEST(Trace, TheExplorationRuleIsJudged) {
  const Exploration rule{.least_presses = 1, .most_presses = 2, .min_depth = 3e-3, .max_time = 10};
  EXPECT_EQ(judge(summarise(trace_of({0, 4, 0})), rule), Verdict::Enough);
  EXPECT_EQ(judge(summarise(trace_of({0, 0.3, 0})), rule), Verdict::TooFewPresses);
  EXPECT_EQ(judge(summarise(trace_of({0, 4, 0, 4, 0, 4})), rule), Verdict::TooManyPresses);
  EXPECT_EQ(judge(summarise(trace_of({0, 2, 0})), rule), Verdict::TooShallow);
  EXPECT_EQ(judge(summarise({}), rule), Verdict::TooFewPresses);
}

TEST(Trace, TimeIsWrittenAsIso8601) {
  EXPECT_TRUE(std::regex_match(base::utc_now(), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)")));
}

}  // namespace
}  // namespace palpate::trials
