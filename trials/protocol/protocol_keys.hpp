#pragma once

#include <span>
#include <string_view>

#include "base/text/file_format.hpp"

namespace palpate::trials {

struct Procedure;
struct Task;

// The keys of a protocol file, apart from what tasks and procedures bring.
std::span<const base::Key> protocol_keys();  // of the file's top
std::span<const base::Key> conditions_keys();
std::span<const base::Key> condition_keys();
std::span<const base::Key> factors_keys();
std::span<const base::Key> level_keys();  // of a factor whose levels have names
std::span<const base::Key> task_keys();
std::span<const base::Key> procedure_keys();
std::span<const base::Key> order_keys();
std::span<const base::Key> exploration_keys();
std::span<const base::Key> display_keys();
std::span<const base::Key> sample_keys();
std::span<const base::Key> analysis_keys();

/// Keys of later versions, in whichever table they stand; and those of a procedure.
std::span<const std::string_view> later_keys();
std::span<const std::string_view> later_procedure_keys();

/// What task.kind and procedure.kind accept.
base::Words task_words();
base::Words procedure_words();

/// All keys, with what these tasks and procedures bring. The example file has one of each.
base::FileFormat protocol_format(std::span<const Task* const> tasks,
                                 std::span<const Procedure* const> procedures);

}  // namespace palpate::trials
