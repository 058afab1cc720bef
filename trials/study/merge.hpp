#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "trials/study/study_file.hpp"

namespace palpate::trials {

struct MergeSource {
  std::filesystem::path file{};
  std::string site{};  // letters and digits; put before its examinees' codes, "Osaka-P01"; empty: codes stay
};

/// Joins study files of one protocol, scene and meshes into a new one; the sources are only read. Their
/// chains are kept as they are, so that verify_study() holds for the new file and for every receipt of the
/// old ones. Throws std::invalid_argument, and makes nothing: a name that is taken, fewer than two sources, a
/// source that is not whole, was itself joined, is of another protocol or on other files, or stands for the
/// same study as another; examinees of two sources whose codes are, or read, the same.
void merge_studies(const std::filesystem::path& out, const std::vector<MergeSource>& sources,
                   std::string_view software_version);

}  // namespace palpate::trials
