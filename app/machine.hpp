#pragma once

#include <string>

namespace palpate::app {

/// System, kernel, architecture and processors, as stored with every session. Names no person and no host.
std::string describe_machine();

}  // namespace palpate::app
