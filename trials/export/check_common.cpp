#include "trials/export/check_common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "base/files/read_file.hpp"

namespace palpate::trials {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Parses, and refuses a key that stands twice in one object (the library would keep the last one).
json parse_strictly(const std::string& text) {
  std::vector<std::set<std::string>> keys;
  return json::parse(text, [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
      throw std::invalid_argument(fmt::format("the key {} stands twice", parsed.dump()));
    return true;
  });
}

}  // namespace

std::string read_text(const fs::path& root, const fs::path& file, Problems& problems) {
  try {
    return base::read_file(root / file);
  } catch (const std::exception&) {
    problems.push_back(fmt::format("{}: is missing or cannot be read", file.string()));
    return {};
  }
}

json read_object(const fs::path& root, const fs::path& file, Problems& problems) {
  const std::string text = read_text(root, file, problems);
  if (text.empty()) return json::object();
  if (text.starts_with("\xEF\xBB\xBF"))
    problems.push_back(fmt::format("{}: begins with a byte-order mark", file.string()));
  try {
    json parsed = parse_strictly(text);
    if (parsed.is_object()) return parsed;
    problems.push_back(fmt::format("{}: is no JSON object", file.string()));
  } catch (const std::exception& error) {
    problems.push_back(fmt::format("{}: {}", file.string(), error.what()));
  }
  return json::object();
}

std::string required_text(const json& object, const char* key, std::string_view where, Problems& problems) {
  const auto found = object.find(key);
  if (found != object.end() && found->is_string() && !found->get<std::string>().empty())
    return found->get<std::string>();
  problems.push_back(fmt::format("{}: {} is missing or no text", where, key));
  return {};
}

std::vector<fs::path> files_below(const fs::path& root) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (!entry.is_directory()) files.push_back(entry.path().lexically_relative(root));
  std::ranges::sort(files);
  return files;
}

}  // namespace palpate::trials
