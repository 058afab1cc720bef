#include "app/command_line/data_folder.hpp"

#include "app/command_line/source_folder.hpp"
#include "base/machine/environment.hpp"

namespace palpate::app {

std::filesystem::path data_folder() {
  return base::environment("PALPATE_DATA").value_or(source_folder());
}

}  // namespace palpate::app
