#include "tests/extending/volume/volume.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/command_line/output.hpp"
#include "base/text/quantity.hpp"
#include "sim/mesh/quality.hpp"
#include "sim/mesh/read_mesh.hpp"

namespace palpate::app {
namespace {

struct VolumeOptions {
  std::string file, unit, format;
};

void run_volume(const VolumeOptions& options) {
  const sim::MeshFile read = sim::read_mesh(options.file, base::metres_per_unit(options.unit));
  const double volume = sim::measure_quality(read.mesh).volume;
  if (options.format == "json")
    print_json({{"mesh", options.file}, {"volume", volume}});
  else
    fmt::print("{}: {:.6g} cm^3\n", options.file, 1e6 * volume);
}

void add_volume(CLI::App& command) {
  auto options = std::make_shared<VolumeOptions>();
  command.add_option("file", options->file, "Mesh of tetrahedra, .msh or .vtu")->required();
  command.add_option("--unit", options->unit, "Unit of the file's coordinates")
      ->required()
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}));
  add_format(command, options->format);
  command.footer("Example:\n  palpate volume prostate.msh --unit mm");
  command.callback([options] { run_volume(*options); });
}

}  // namespace

const Command volume_command{
    .name = "volume", .summary = "How much a mesh holds", .heading = "Touch", .add = add_volume};

}  // namespace palpate::app
