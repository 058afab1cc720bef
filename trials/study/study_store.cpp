#include "trials/study/study_store.hpp"

#include <stdexcept>

namespace palpate::trials {

void StudyStore::add(const StudyRow& study) {
  Query(
      database_,
      "INSERT INTO study (id, uuid, created_utc, protocol_name, protocol_text, protocol_sha256, scene_text, "
      "software_version) VALUES (1, ?, ?, ?, ?, ?, ?, ?)",
      study.uuid, study.created_utc, study.protocol_name, study.protocol_text, study.protocol_sha256,
      study.scene_text, study.software_version)
      .run();
  int position = 0;
  for (const FileHash& file : study.files)
    Query(database_, "INSERT INTO study_file (position, name, file, sha256) VALUES (?, ?, ?, ?)", ++position,
          file.name, file.file.filename().string(), file.sha256)
        .run();
}

StudyRow StudyStore::get() const {
  Query row(database_,
            "SELECT uuid, created_utc, protocol_name, protocol_text, protocol_sha256, scene_text, "
            "software_version FROM study");
  if (!row.next()) throw std::invalid_argument("the study file is damaged: it holds no study");
  StudyRow study{.uuid = row.text(0),
                 .created_utc = row.text(1),
                 .protocol_name = row.text(2),
                 .protocol_text = row.text(3),
                 .protocol_sha256 = row.text(4),
                 .scene_text = row.text(5),
                 .files = {},
                 .software_version = row.text(6)};
  Query files(database_, "SELECT name, file, sha256 FROM study_file ORDER BY position");
  while (files.next()) study.files.push_back({files.text(0), files.text(1), files.text(2)});
  return study;
}

}  // namespace palpate::trials
