#include "trials/trace/trace.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <string>

#include "base/text/enum_words.hpp"

namespace palpate::trials {
namespace {

static_assert(std::endian::native == std::endian::little, "traces are stored as little-endian float32");

constexpr double kPressBegins = 0.5e-3;  // [m]
constexpr double kPressEnds = 0.25e-3;   // [m]
constexpr std::size_t kColumns = 9;

constexpr base::EnumWords<Verdict, 5> kVerdicts{{{Verdict::Enough, "enough"},
                                                 {Verdict::TooFewPresses, "too few presses"},
                                                 {Verdict::TooManyPresses, "too many presses"},
                                                 {Verdict::TooShallow, "not pressed deep enough"},
                                                 {Verdict::Interrupted, "interrupted"}}};

std::array<float, kColumns> columns_of(const TraceSample& s) {
  return {s.time,     s.proposed_depth, s.depth,   s.displacement[0], s.displacement[1], s.displacement[2],
          s.force[0], s.force[1],       s.force[2]};
}

TraceSample sample_of(const std::array<float, kColumns>& c) {
  return {.time = c[0],
          .proposed_depth = c[1],
          .depth = c[2],
          .displacement = {c[3], c[4], c[5]},
          .force = {c[6], c[7], c[8]}};
}

/// The number that a single-precision value is written as: 0.999, not 0.9990000128746033.
double decimal(double value) {
  return std::stod(fmt::format("{}", static_cast<float>(value)));
}

double magnitude(const std::array<float, 3>& force) {
  return std::hypot(static_cast<double>(force[0]), static_cast<double>(force[1]),
                    static_cast<double>(force[2]));
}

}  // namespace

void PressCounter::add(double depth) {
  if (!pressing_ && depth > kPressBegins) {
    pressing_ = true;
    ++begun_;
  } else if (pressing_ && depth < kPressEnds) {
    pressing_ = false;
  }
}

ExplorationSummary summarise(const Trace& trace) {
  ExplorationSummary summary;
  PressCounter presses;
  for (const TraceSample& sample : trace) {
    const double force = magnitude(sample.force);
    presses.add(sample.proposed_depth);
    summary.hand_depth = std::max(summary.hand_depth, static_cast<double>(sample.proposed_depth));
    summary.peak_force = std::max(summary.peak_force, force);
    if (force > 0) summary.max_depth = std::max(summary.max_depth, static_cast<double>(sample.depth));
  }
  summary.presses = presses.begun();
  summary.peak_force = decimal(summary.peak_force);
  summary.max_depth = decimal(summary.max_depth);
  summary.hand_depth = decimal(summary.hand_depth);
  if (!trace.empty()) summary.time = decimal(trace.back().time);
  return summary;
}

Verdict judge(const ExplorationSummary& summary, const Exploration& rule) {
  if (summary.presses < rule.least_presses) return Verdict::TooFewPresses;
  if (summary.presses > rule.most_presses) return Verdict::TooManyPresses;
  if (summary.hand_depth < rule.min_depth) return Verdict::TooShallow;
  return Verdict::Enough;
}

std::string_view to_string(Verdict verdict) {
  return base::word_of(kVerdicts, verdict);
}

Verdict verdict_from(std::string_view word) {
  if (const auto verdict = base::value_of(kVerdicts, word)) return *verdict;
  throw std::invalid_argument(
      fmt::format("verdict: found \"{}\", accepted: {}", word, base::accepted_words(kVerdicts)));
}

std::string encode(const Trace& trace) {
  // Column by column: neighbours differ little, and so compress well.
  std::vector<float> columns(kColumns * trace.size());
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const auto row = columns_of(trace[i]);
    for (std::size_t c = 0; c < kColumns; ++c) columns[c * trace.size() + i] = row[c];
  }
  const uLong raw = static_cast<uLong>(columns.size() * sizeof(float));
  uLongf length = compressBound(raw);
  std::string bytes(length, '\0');
  if (compress2(reinterpret_cast<Bytef*>(bytes.data()), &length,
                reinterpret_cast<const Bytef*>(columns.data()), raw, Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("zlib could not compress a trace");
  bytes.resize(length);
  return bytes;
}

Trace decode(std::string_view bytes, std::size_t samples) {
  // zlib cannot shrink below about 1 : 1032, so a larger claim is false and no memory is taken for it.
  if (samples > 1032 * (bytes.size() + 1))
    throw std::invalid_argument(
        fmt::format("a trace of {} bytes cannot hold {} samples", bytes.size(), samples));
  std::vector<float> columns(kColumns * samples);
  uLongf length = static_cast<uLongf>(columns.size() * sizeof(float));
  const uLongf expected = length;
  const int status =
      uncompress(reinterpret_cast<Bytef*>(columns.data()), &length,
                 reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  if (expected > 0 && (status != Z_OK || length != expected))
    throw std::invalid_argument(fmt::format("a trace is damaged: {} samples were to be read", samples));
  Trace trace(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    std::array<float, kColumns> row{};
    for (std::size_t c = 0; c < kColumns; ++c) row[c] = columns[c * samples + i];
    trace[i] = sample_of(row);
  }
  return trace;
}

}  // namespace palpate::trials
