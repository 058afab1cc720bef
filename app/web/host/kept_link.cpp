#include "app/web/host/kept_link.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <fstream>

#include "app/web/server/access.hpp"
#include "base/files/atomic_file.hpp"

namespace palpate::app {

std::filesystem::path kept_link_file(const std::filesystem::path& study) {
  return study.string() + ".page";
}

std::optional<KeptLink> read_kept_link(const std::filesystem::path& file) {
  std::ifstream in(file);
  KeptLink link;
  if (!(in >> link.port >> link.token) || in.get() != ' ' || !std::getline(in, link.sitting))
    return std::nullopt;
  return is_token(link.token) ? std::optional(link) : std::nullopt;
}

void keep_link(const std::filesystem::path& file, const KeptLink& link) {
  base::write_atomically(file, fmt::format("{} {} {}\n", link.port, link.token, link.sitting),
                         S_IRUSR | S_IWUSR);
}

}  // namespace palpate::app
