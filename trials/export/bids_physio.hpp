#pragma once

#include <filesystem>
#include <vector>

#include "trials/study/study_file.hpp"
#include "trials/tables/codebook.hpp"

namespace palpate::trials {

/// The columns of a force recording. BIDS wants no header in its file: the sidecar names them.
std::vector<Column> physio_columns();

/// Writes every trace of a sitting, one after the other, as gzip-compressed TSV. Returns the sampling
/// frequency [Hz]: one over the median step; none (and no file) where no trace has two samples.
std::optional<double> write_physio(const StudyFile& study, const SessionRow& session,
                                   const std::filesystem::path& file);

}  // namespace palpate::trials
