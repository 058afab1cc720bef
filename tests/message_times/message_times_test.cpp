// When messages reach the page, of whole sittings: host, server, haptic loop and study file as `palpate run` has
// them, and a page of the test's at the other end of the socket, with one hand path for all.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "app/web/host/host.hpp"
#include "devices/devices.hpp"
#include "sim/compliance/cache.hpp"
#include "tests/message_times/leak.hpp"
#include "tests/message_times/listening_page.hpp"
#include "tests/support/places.hpp"
#include "trials/protocol/stimuli.hpp"
#include "trials/study/study_file.hpp"

namespace palpate::app::message_times {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr int kSittings = 3;  // one after the other, of each protocol

struct HeardInterval {
  std::size_t condition = 0, cell = 0;
  IntervalTimes times{};
};

// A contact law that costs more than any that is shipped, when it is made ready and in every cycle: what leaks by
// the cost of a law leaks by this one.
const sim::ContactLaw* plain_law = nullptr;

std::unique_ptr<sim::LawScratch> prepare_slowly(const sim::Model& model) {
  std::this_thread::sleep_for(20ms);
  return plain_law->prepare(model);
}

sim::SolveReport solve_slowly(const sim::Model& model, const sim::FreeState& free,
                              std::span<const double> memory, sim::LawScratch& scratch,
                              sim::Response& response) {
  const auto until = std::chrono::steady_clock::now() + 200us;
  const sim::SolveReport report = plain_law->solve(model, free, memory, scratch, response);
  while (std::chrono::steady_clock::now() < until) {
  }
  return report;
}

/// Sittings of a protocol that is shipped, with intervals that one press ends; the second contact model is made
/// slow.
class Sittings {
 public:
  explicit Sittings(const std::string& name)
      : protocol_(
            trials::load_protocol(fs::path(palpate::test::source_folder()) / "protocols" / (name + ".toml"))),
        folder_(fs::temp_directory_path() / fmt::format("palpate-times-{}-{}", ::getpid(), name)) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    protocol_.exploration.least_presses = protocol_.exploration.most_presses = 1;
    sim::ComplianceCache cache("");
    organs_.stimuli = trials::compile_stimuli(protocol_, cache);
    organs_.practice = *organs_.stimuli.at(trials::stimulus_index(protocol_, 0, protocol_.presented.front()));
    for (const std::size_t condition : protocol_.presented)
      slow_down(organs_.stimuli.at(trials::stimulus_index(protocol_, 1, condition)));
  }
  ~Sittings() { fs::remove_all(folder_); }
  Sittings(const Sittings&) = delete;
  Sittings& operator=(const Sittings&) = delete;

  const trials::Protocol& protocol() const { return protocol_; }

  /// From welcome to thanks.
  void sit(int number, std::vector<HeardInterval>& heard) {
    trials::StudyFile study = trials::open_study(folder_ / fmt::format("{}.db", number), protocol_, "test");
    trials::Session session = trials::start_session(
        study, protocol_,
        {.examinee = "P01", .device = "mouse", .pseudo_haptic = true, .channel = "pointer lag"});
    const fs::path link = folder_ / fmt::format("{}.page", number);
    Host host({.open_browser = false, .kept_link = link, .sitting = "times"});
    std::thread leads([&] { host.lead(session, protocol_, organs_, devices::open("mouse")); });
    const std::vector<IntervalTimes> times = sit_through(link, protocol_.exploration.min_depth);
    leads.join();
    const std::vector<trials::PresentationRow> shown = study.presentations(session.row().id);
    ASSERT_EQ(shown.size(), times.size());
    const std::vector<trials::DrawnTrial> drawn = study.trials(session.row().id);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const trials::Trial& trial = drawn.at(static_cast<std::size_t>(shown[i].trial) - 1).trial;
      ASSERT_EQ(trial.number, shown[i].trial);
      heard.push_back({.condition = shown[i].condition, .cell = trial.cell, .times = times[i]});
    }
  }

 private:
  static void slow_down(std::shared_ptr<const sim::Model>& stimulus) {
    plain_law = stimulus->law;
    static const sim::ContactLaw slow{
        .name = "slow", .prepare = prepare_slowly, .solve = solve_slowly};  // sibille has no memory
    sim::Model model = *stimulus;
    model.law = &slow;
    stimulus = std::make_shared<const sim::Model>(std::move(model));
  }

  trials::Protocol protocol_;
  fs::path folder_;
  Organs organs_;
};

struct Time {
  const char* name;
  std::function<std::optional<double>(const IntervalTimes&)> of;
  double told_from;  // a delay of so many ms is found, on a machine that has little else to do
};

/// All that the page can time. What begins with a word of the page meets the messages' beat of 16 ms anywhere, and
/// is spread over it.
const std::vector<Time>& all_times() {
  static const std::vector<Time> times = {
      {"from \"go on\" until the interval is shown", [](const IntervalTimes& t) { return t.from_start; }, 16},
      {"from the pause until the interval is shown", [](const IntervalTimes& t) { return t.from_pause; }, 4},
      {"until the pointer is first told", [](const IntervalTimes& t) { return t.first_probe; }, 4},
      {"between messages about the pointer", [](const IntervalTimes& t) { return t.typical_gap; }, 4},
      {"the longest between these", [](const IntervalTimes& t) { return t.longest_gap; }, 4},
      {"from the press until the interval is over", [](const IntervalTimes& t) { return t.to_over; }, 4},
      {"from there until what comes next", [](const IntervalTimes& t) { return t.to_outcome; }, 4}};
  return times;
}

using Group = std::function<std::size_t(const HeardInterval&)>;

/// What was heard of the first and of the second condition, or model.
std::array<std::vector<double>, 2> split(const std::vector<HeardInterval>& heard, const Time& time,
                                         const Group& group) {
  std::array<std::vector<double>, 2> parts;
  for (const HeardInterval& interval : heard)
    if (const auto value = time.of(interval.times)) parts.at(group(interval)).push_back(*value);
  return parts;
}

/// Sittings of all protocols at once, so that whatever else the machine does meets all conditions alike.
std::vector<HeardInterval> hear_all() {
  std::vector<std::vector<HeardInterval>> heard(3);
  std::vector<std::thread> rooms;
  const std::array names = {"kuroda2003", "kuroda2003-balanced", "kuroda2003-sequential"};
  std::vector<std::unique_ptr<Sittings>> sittings;
  for (const char* name : names) sittings.push_back(std::make_unique<Sittings>(name));
  for (std::size_t i = 0; i < names.size(); ++i)
    rooms.emplace_back([&, i] {
      for (int number = 1; number <= kSittings; ++number) sittings[i]->sit(number, heard[i]);
    });
  for (std::thread& room : rooms) room.join();
  std::vector<HeardInterval> all;
  for (const auto& part : heard) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Half of a sample lies within [ms].
double middle_half(std::vector<double> sample) {
  std::ranges::sort(sample);
  return sample[3 * sample.size() / 4] - sample[sample.size() / 4];
}

/// The same times tell the two apart once one is late: the test would find a leak.
void expect_to_find_a_delay(const Time& time, const std::vector<double>& one, std::vector<double> late) {
  if (middle_half(one) > 0.6 * time.told_from) {
    std::printf("  too much else is done here: %.1f ms could not be told\n", time.told_from);
    return;
  }
  for (double& value : late) value += time.told_from;
  EXPECT_TRUE(leaks(difference(one, late))) << time.name;
}

TEST(MessageTimes, TellNeitherConditionNorModelHoweverMuchALawCosts) {
  const std::vector<HeardInterval> heard = hear_all();
  const std::size_t first_condition = heard.front().condition;
  const std::vector<std::pair<const char*, Group>> groups = {
      {"condition", [&](const HeardInterval& h) { return h.condition == first_condition ? 0U : 1U; }},
      {"contact model", [](const HeardInterval& h) { return h.cell; }}};
  for (const Time& time : all_times()) {
    for (const auto& [name, group] : groups) {
      const auto [one, other] = split(heard, time, group);
      ASSERT_GE(std::min(one.size(), other.size()), 30U);
      const TimeDifference found = difference(one, other);
      std::printf("%-45s by %-14s: n %zu and %zu, AUC %.3f (chance %.3f), medians %+.3f ms\n", time.name,
                  name, one.size(), other.size(), found.share_longer, found.chance, found.median);
      EXPECT_FALSE(leaks(found)) << time.name << " tells the " << name;
      expect_to_find_a_delay(time, one, other);
    }
  }
}

}  // namespace
}  // namespace palpate::app::message_times
