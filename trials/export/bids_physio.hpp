#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "trials/study/answered_trials.hpp"
#include "trials/tables/codebook.hpp"

namespace palpate::trials {

/// The columns of a force recording. BIDS wants no header in its file: the sidecar names them.
std::vector<Column> physio_columns();

/// A presentation, and whether an answer was given to it.
struct Felt {
  PresentationRow presentation{};
  bool counted = false;
};

/// All that was felt, by the sitting's id; in the order of time.
std::map<std::int64_t, std::vector<Felt>> felt_by_sitting(const std::vector<AnsweredTrial>& answered,
                                                          const std::vector<Exposure>& exposures);

/// Writes every trace of a sitting, one after the other, as gzip-compressed TSV. Returns the sampling
/// frequency [Hz]: one over the median step; none (and no file) where no trace has two samples.
std::optional<double> write_physio(const StudyFile& study, const std::vector<Felt>& felt,
                                   const std::filesystem::path& file);

}  // namespace palpate::trials
