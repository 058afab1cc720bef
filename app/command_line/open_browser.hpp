#pragma once

#include <string>

namespace palpate::app {

/// Asks the desktop to open a link (xdg-open), and does not wait for it. False where there is no desktop or
/// no xdg-open.
bool open_browser(const std::string& link);

}  // namespace palpate::app
