#pragma once

#include "base/clock/utc.hpp"
#include "tests/trials/support/protocols.hpp"
#include "tests/trials/support/sitting.hpp"
#include "trials/export/datasets.hpp"

namespace palpate::trials::test {

/// A study with everything that an export must cope with: two sittings of one examinee, of two run modes, a
/// code with a hyphen, exposures that did not count, one that was cut off, a voided trial with an awkward
/// reason.
class ExportedStudy : public testing::Test {
 protected:
  ExportedStudy() : study_(open_study(folder_ / "study.db", protocol_, "0.1.0")) {
    {
      Session session = start_session(study_, protocol_, facts_of("P-01", RunMode::Pilot));
      session.begin_interval();
      session.end_interval(press_to(1e-3));  // too shallow: does not count
      session.begin_interval();
      session.interrupt(press_to(1e-3), "test");
      answer_all(session);
      EventRow event{.session = session.row().id, .trial = 2, .kind = "voided"};
      event.text = "the \"alarm\"\trang; \\\"twice\\\",\nand \xff a door";
      study_.add_event(event);
    }
    Session again = start_session(study_, protocol_, facts_of("P-01"));
    answer_all(again);
    again.note(event_kind::kStrategy, "the \"softer\" one,\nI think");
    Session other = start_session(study_, protocol_, facts_of("Q2"));
    answer_all(other);
    Session unfinished = start_session(study_, protocol_, facts_of("R3"));
    unfinished.begin_interval();  // killed here: nothing was measured
  }

  TemporaryFolder folder_;
  Protocol protocol_ = small_protocol(2);
  StudyFile study_;
  ExportFacts facts_{.authors = {"A. Author"}, .software_version = "0.1.0", .exported_utc = base::utc_now()};
};

}  // namespace palpate::trials::test
