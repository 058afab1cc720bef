#pragma once

#include <string>

namespace palpate::base {

/// This machine, for logs and beside timings: "AMD EPYC, Linux 6.1.0 x86_64, 2 processors".
std::string describe_machine();

}  // namespace palpate::base
