#include "app/commands/commands.hpp"

#include <array>

#include "app/commands/check/check.hpp"
#include "app/commands/cost/cost.hpp"
#include "app/commands/demo/demo.hpp"
#include "app/commands/export/export.hpp"
#include "app/commands/merge/merge.hpp"
#include "app/commands/mesh/mesh.hpp"
#include "app/commands/new_study/new_study.hpp"
#include "app/commands/plan/plan.hpp"
#include "app/commands/press/press.hpp"
#include "app/commands/procedure/procedure.hpp"
#include "app/commands/render/render.hpp"
#include "app/commands/report/report.hpp"
#include "app/commands/run/run.hpp"
#include "app/commands/simulate/simulate.hpp"
#include "app/commands/stats/stats.hpp"
#include "app/commands/verify/verify.hpp"

namespace palpate::app {

std::span<const Command* const> commands() {
  static constexpr std::array all{
      &demo_command,       //
      &new_command,        //
      &press_command,      //
      &render_command,     //
      &cost_command,       //
      &mesh_command,       //
      &check_command,      //
      &plan_command,       //
      &procedure_command,  //
      &run_command,        //
      &simulate_command,   //
      &report_command,     //
      &export_command,     //
      &verify_command,     //
      &merge_command,      //
      &stats_command,      //
  };
  return all;
}

}  // namespace palpate::app
