#include "app/commands/mesh/mesh.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command_line/output.hpp"
#include "app/commands/mesh/mesh_report.hpp"
#include "base/files/folder_of.hpp"
#include "base/text/quantity.hpp"
#include "sim/mesh/write_msh.hpp"
#include "sim/mesh/write_vtu.hpp"

namespace palpate::app {
namespace {

struct MeshOptions {
  std::string file;
  std::string unit;
  std::string out;
  std::string format;
};

std::string check_ending(const std::string& out) {
  const std::string ending = std::filesystem::path(out).extension();
  return ending == ".msh" || ending == ".vtu" ? "" : out + ": .msh and .vtu are accepted";
}

void run_mesh(const MeshOptions& options) {
  std::error_code none;
  if (!options.out.empty() && std::filesystem::equivalent(options.out, options.file, none))
    throw std::invalid_argument(fmt::format(
        "--out {}: is the mesh itself, whose unit would change; accepted: another name", options.out));
  if (!options.out.empty()) base::require_folder_of(options.out);
  const MeshReport report = inspect_mesh(options.file, base::metres_per_unit(options.unit));
  if (!options.out.empty()) {
    if (std::filesystem::path(options.out).extension() == ".msh")
      sim::write_msh(options.out, report.read.mesh);
    else
      sim::write_vtu(options.out, report.read.mesh, {});
    fmt::print(stderr, "wrote {} in metres (length_unit = \"m\")\n", options.out);
  }
  if (options.format == "json")
    print_json(to_json(report));
  else
    fmt::print("{}", to_text(report));
}

void add_mesh(CLI::App& command) {
  auto options = std::make_shared<MeshOptions>();
  command
      .add_option(
          "file", options->file,
          "Gmsh MSH 2.2 or 4.1 (text or binary) or VTU; what else the installed gmsh reads (MSH 1, VTK, "
          "UNV, MED, Medit, Abaqus INP, Nastran)")
      ->required();
  command.add_option("--unit", options->unit, "Unit of the file's coordinates")
      ->required()
      ->check(CLI::IsMember({"m", "cm", "mm", "um"}));
  command.add_option("--out", options->out, "Write the mended mesh, in metres, as .msh (4.1) or .vtu")
      ->check(CLI::Validator(check_ending, "FILE.msh|FILE.vtu"));
  add_format(command, options->format);
  command.footer("Example:\n  palpate mesh prostate.msh --unit mm --out prostate.vtu");
  command.callback([options] { run_mesh(*options); });
}

}  // namespace

const Command mesh_command{.name = "mesh",
                           .summary = "Reads, checks and converts a tetrahedral mesh",
                           .heading = "Touch",
                           .add = add_mesh};

}  // namespace palpate::app
