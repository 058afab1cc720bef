#pragma once

#include <SQLiteCpp/Database.h>

#include <filesystem>
#include <functional>
#include <string>

namespace palpate::trials {

/// 128 bits from the operating system, whatever the seed of the study: two studies are never the same one.
std::string fresh_uuid();

/// Makes a study file aside and whole, then gives it its name; what stands under the name is never replaced.
/// `fill` writes into the empty tables, in one transaction; `inspect` may still refuse the finished file.
void write_new_study(const std::filesystem::path& path, const std::function<void(SQLite::Database&)>& fill,
                     const std::function<void(const std::filesystem::path& aside)>& inspect = {});

}  // namespace palpate::trials
