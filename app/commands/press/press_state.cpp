#include "app/commands/press/press_state.hpp"

#include <fmt/format.h>

#include <vector>

#include "base/files/atomic_file.hpp"
#include "sim/elasticity/stress.hpp"
#include "sim/mesh/write_vtu.hpp"

namespace palpate::app {

void save_state(const sim::Model& model, const sim::Loads& loads, const std::string& state) {
  const std::vector<sim::WholeBody> wholes = sim::whole_bodies(model, loads);
  std::vector<base::FileText> files;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const sim::Body& body = model.bodies[i];
    const sim::WholeBody& whole = wholes[i];
    sim::VtuFields fields;
    fields.point_vectors = {{"displacement", whole.displacement}, {"force", whole.force}};
    fields.cell_scalars = {{"von_mises", sim::von_mises(*body.mesh, body.materials, whole.displacement)}};
    files.push_back({fmt::format("{}.{}.vtu", state, body.name), sim::vtu_text(*body.mesh, fields)});
  }
  base::write_together(files);
  for (const base::FileText& written : files) fmt::print(stderr, "wrote {}\n", written.file.string());
}

}  // namespace palpate::app
