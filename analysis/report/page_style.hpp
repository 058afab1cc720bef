#pragma once

namespace palpate::analysis {

/// The style sheet of the HTML report, for screen and paper. System fonts: nothing is fetched.
extern const char* const kPageStyle;

}  // namespace palpate::analysis
