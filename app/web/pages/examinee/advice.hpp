#pragma once

#include <string>

#include "trials/trace/trace.hpp"

namespace palpate::app {

/// What the examinee is told about an interval that comes once more; empty where it was explored enough. It
/// follows from the hand alone.
std::string advice(trials::Verdict verdict, const trials::Exploration& rule);

}  // namespace palpate::app
