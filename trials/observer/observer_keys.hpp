#pragma once

#include <span>

#include "base/text/file_format.hpp"

namespace palpate::trials {

// The keys of a file that says what simulated examinees are like.
std::span<const base::Key> observer_keys();  // of the file's top
std::span<const base::Key> press_keys();
std::span<const base::Key> device_keys();
std::span<const base::Key> senses_keys();
std::span<const base::Key> decision_keys();

/// All of them.
base::FileFormat observer_format();

}  // namespace palpate::trials
