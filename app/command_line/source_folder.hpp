#pragma once

namespace palpate::app {

/// The root of the source that the program was built from, absolute: its protocols and scenes are there.
const char* source_folder();

}  // namespace palpate::app
