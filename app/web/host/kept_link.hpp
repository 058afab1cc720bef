#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace palpate::app {

/// Where a sitting's page was served: kept beside the study file while the sitting is unfinished, so that a page
/// left open goes on by itself once the program is back.
struct KeptLink {
  std::string sitting{};  // whose it is: another's page must not come back into this one
  std::uint16_t port = 0;
  std::string token{};
};

/// The file that keeps it: STUDY.page.
std::filesystem::path kept_link_file(const std::filesystem::path& study);

/// Nothing where there is none, or one that is damaged.
std::optional<KeptLink> read_kept_link(const std::filesystem::path& file);

/// Readable by its owner alone, for whoever has the token is the examinee. Throws std::system_error that names
/// the file.
void keep_link(const std::filesystem::path& file, const KeptLink& link);

}  // namespace palpate::app
