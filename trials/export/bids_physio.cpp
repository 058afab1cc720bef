#include "trials/export/bids_physio.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <iterator>
#include <memory>
#include <system_error>

namespace palpate::trials {
namespace {

Column sampled(std::string name, std::string title, std::string description, std::string unit) {
  return {.name = std::move(name),
          .title = std::move(title),
          .description = std::move(description),
          .unit = std::move(unit),
          .kind = Kind::Real};
}

/// A gzip file that tells when the disk refuses; the same rows give the same bytes.
class GzipFile {
 public:
  explicit GzipFile(std::filesystem::path file)
      : name_(std::move(file)), file_(gzopen(name_.c_str(), "wbx4")) {
    if (!file_) refuse();
  }
  void write(const fmt::memory_buffer& text) {
    if (text.size() > 0 && gzwrite(file_.get(), text.data(), static_cast<unsigned>(text.size())) == 0)
      refuse();
  }
  void close() {
    if (gzclose(file_.release()) != Z_OK) refuse();
  }

 private:
  struct Close {
    void operator()(gzFile file) const { gzclose(file); }
  };
  [[noreturn]] void refuse() const {
    throw std::system_error(errno, std::generic_category(), fmt::format("{}: cannot write", name_.string()));
  }

  std::filesystem::path name_;
  std::unique_ptr<gzFile_s, Close> file_;
};

void add_rows(fmt::memory_buffer& text, const PresentationRow& p, bool counts, const Trace& trace) {
  const auto out = std::back_inserter(text);
  const std::string which =
      fmt::format("{}\t{}\t{}\t{}\t{}", p.trial, p.interval, p.draw, p.attempt, counts ? 1 : 0);
  for (const TraceSample& s : trace)
    fmt::format_to(out, "{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\n", which, s.time, s.proposed_depth, s.depth,
                   s.displacement[0], s.displacement[1], s.displacement[2], s.force[0], s.force[1],
                   s.force[2]);
}

void add_steps(std::vector<double>& steps, const Trace& trace) {
  for (std::size_t i = 1; i < trace.size(); ++i)
    steps.push_back(static_cast<double>(trace[i].time) - static_cast<double>(trace[i - 1].time));
}

/// Single-precision times say no more than six digits.
double frequency_of(std::vector<double> steps) {
  const auto middle = steps.begin() + static_cast<long>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return std::stod(fmt::format("{:.4g}", 1.0 / *middle));
}

}  // namespace

std::vector<Column> physio_columns() {
  std::vector<Column> columns{
      whole_column("trial", "Trial", "Number of the question within the sitting", 1),
      whole_column("interval", "Interval", "Number of the interval within the trial", 1),
      whole_column("draw", "Draw", "How often the trial's order had been drawn again by then", 0),
      whole_column("attempt", "Attempt", "Counts how often this interval of this draw was presented", 1),
      {.name = "counted",
       .title = "Counted",
       .description = "Whether an answer was given to this presentation",
       .kind = Kind::Whole,
       .least = 0,
       .most = 1,
       .levels = {{"0", "felt, but it did not count"}, {"1", "an answer was given to it"}}},
      sampled("time_s", "Time", "From the interval's onset: it begins anew with every presentation", "s"),
      sampled("proposed_depth_m", "Depth proposed", "How deep the hand was", "m"),
      sampled("depth_m", "Depth", "How deep the probe was driven", "m")};
  for (const char* axis : {"x", "y", "z"})
    columns.push_back(sampled(fmt::format("displacement_{}_m", axis), fmt::format("Displacement, {}", axis),
                              "Of the probe as driven, along an axis of the scene", "m"));
  for (const char* axis : {"x", "y", "z"})
    columns.push_back(sampled(fmt::format("force_{}_n", axis), fmt::format("Force, {}", axis),
                              "Delivered to the finger, after any clamp, along an axis of the scene", "N"));
  return columns;
}

std::map<std::int64_t, std::vector<Felt>> felt_by_sitting(const std::vector<AnsweredTrial>& answered,
                                                          const std::vector<Exposure>& exposures) {
  std::map<std::int64_t, std::vector<Felt>> by_sitting;
  for (const AnsweredTrial& trial : answered)
    for (const PresentationRow& interval : trial.intervals)
      by_sitting[trial.session->id].push_back({interval, true});
  for (const auto& [session, presentation] : exposures)
    by_sitting[session->id].push_back({presentation, false});
  for (auto& [session, felt] : by_sitting)
    std::ranges::sort(felt, {}, [](const Felt& one) { return one.presentation.id; });
  return by_sitting;
}

std::optional<double> write_physio(const StudyFile& study, const std::vector<Felt>& felt,
                                   const std::filesystem::path& file) {
  std::vector<double> steps;
  std::unique_ptr<GzipFile> gzip;
  for (const auto& [p, counts] : felt) {
    if (p.samples == 0) continue;
    const Trace trace = study.load_trace(p.id);
    add_steps(steps, trace);
    fmt::memory_buffer text;
    add_rows(text, p, counts, trace);
    if (!gzip) {
      std::filesystem::create_directories(file.parent_path());
      gzip = std::make_unique<GzipFile>(file);
    }
    gzip->write(text);
  }
  if (gzip) gzip->close();
  std::erase_if(steps, [](double step) { return !(step > 0); });
  if (steps.empty()) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return std::nullopt;
  }
  return frequency_of(std::move(steps));
}

}  // namespace palpate::trials
