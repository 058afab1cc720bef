#pragma once

#include "trials/task/task.hpp"

namespace palpate::tasks {

/// Three-interval forced choice, "3IFC": one interval presents the condition that [task] calls correct, the
/// two others present another; which interval was it?
extern const trials::Task kThreeInterval;

}  // namespace palpate::tasks
