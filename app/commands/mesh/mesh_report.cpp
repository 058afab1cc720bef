#include "app/commands/mesh/mesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/text/counted.hpp"
#include "sim/mesh/name_groups.hpp"

namespace palpate::app {
namespace {

std::map<std::string, int> count_regions(const sim::TetMesh& mesh) {
  std::map<std::string, int> counts;
  for (const std::string& name : mesh.region_names) counts[name] = 0;
  for (const int region : mesh.region)
    if (region >= 0) ++counts[mesh.region_names[region]];
  return counts;
}

std::string text_of_repairs(const sim::MeshRepairs& repairs) {
  std::string text;
  const auto add = [&](int count, const std::string& one, const std::string& several) {
    if (count > 0) text += fmt::format("  {}\n", base::counted(count, one, several));
  };
  add(repairs.reordered_tetrahedra, "tetrahedron of negative volume: two of its nodes exchanged",
      "tetrahedra of negative volume: two nodes of each exchanged");
  const std::string welded = fmt::format("welded (closer than {:.3g} m)", repairs.weld_tolerance);
  add(repairs.welded_nodes, "duplicate node " + welded, "duplicate nodes " + welded);
  add(repairs.unreferenced_nodes, "node in no tetrahedron left out", "nodes in no tetrahedron left out");
  return "Repairs\n" + (text.empty() ? "  none were needed\n" : text);
}

std::string text_of_groups(const sim::TetMesh& mesh) {
  std::size_t width = 8;
  for (const auto& [name, nodes] : mesh.node_groups) width = std::max(width, name.size());
  std::string text = "Groups of nodes\n";
  for (const auto& [name, nodes] : mesh.node_groups)
    text +=
        fmt::format("  {:<{}}  {:>7} {}\n", name, width, nodes.size(), nodes.size() == 1 ? "node" : "nodes");
  if (mesh.node_groups.empty()) text += fmt::format("  none: {}\n", sim::kHowToNameGroups);
  if (mesh.region_names.empty()) return text;
  text += "Regions\n";
  for (const auto& [name, count] : count_regions(mesh))
    text +=
        fmt::format("  {:<{}}  {:>7} {}\n", name, width, count, count == 1 ? "tetrahedron" : "tetrahedra");
  return text;
}

}  // namespace

MeshReport inspect_mesh(const std::string& file, double metres_per_unit) {
  MeshReport report{.file = file, .metres_per_unit = metres_per_unit};
  report.read = sim::read_mesh(file, metres_per_unit);
  try {
    sim::validate(report.read.mesh);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", file, error.what()));
  }
  report.quality = sim::measure_quality(report.read.mesh);
  return report;
}

std::string to_text(const MeshReport& report) {
  const sim::MeshQuality& q = report.quality;
  const sim::Vec3 size = 1e3 * (q.upper - q.lower);
  std::string text = fmt::format("{}, one unit of the file is {} m\n", report.file, report.metres_per_unit);
  text += fmt::format("  nodes         {} ({} on the surface)\n", q.nodes, q.surface_nodes);
  text += fmt::format("  tetrahedra    {}\n", q.tetrahedra);
  text += fmt::format("  surface       {} triangles, closed\n", q.surface_triangles);
  text += fmt::format("  pieces        {}\n", q.components);
  text += fmt::format("  size          {:.5g} x {:.5g} x {:.5g} mm\n", size.x(), size.y(), size.z());
  text += fmt::format("  volume        {:.5g} ml\n", 1e6 * q.volume);
  text += fmt::format("  edges         {:.4g} to {:.4g} mm\n", 1e3 * q.min_edge, 1e3 * q.max_edge);
  text += fmt::format("  angles        {:.4g} to {:.4g} degree between the faces of a tetrahedron\n",
                      q.min_dihedral, q.max_dihedral);
  text += fmt::format("  radius ratio  {:.3f} at worst, {:.3f} on average (1 for a regular tetrahedron)\n",
                      q.min_radius_ratio, q.mean_radius_ratio);
  text += text_of_repairs(report.read.repairs) + text_of_groups(report.read.mesh);
  if (!q.warnings.empty()) text += "Warnings\n";
  for (const std::string& warning : q.warnings) text += fmt::format("  {}\n", warning);
  return text;
}

nlohmann::ordered_json to_json(const MeshReport& report) {
  const sim::MeshQuality& q = report.quality;
  const sim::MeshRepairs& repairs = report.read.repairs;
  nlohmann::ordered_json groups = nlohmann::ordered_json::object();
  for (const auto& [name, nodes] : report.read.mesh.node_groups) groups[name] = nodes.size();
  nlohmann::ordered_json regions = nlohmann::ordered_json::object();
  for (const auto& [name, count] : count_regions(report.read.mesh)) regions[name] = count;
  return {{"file", report.file},
          {"metres_per_unit", report.metres_per_unit},
          {"units", {{"length", "m"}, {"volume", "m^3"}, {"angle", "degree"}}},
          {"nodes", q.nodes},
          {"surface_nodes", q.surface_nodes},
          {"tetrahedra", q.tetrahedra},
          {"surface_triangles", q.surface_triangles},
          {"components", q.components},
          {"lower", {q.lower.x(), q.lower.y(), q.lower.z()}},
          {"upper", {q.upper.x(), q.upper.y(), q.upper.z()}},
          {"volume", q.volume},
          {"min_edge", q.min_edge},
          {"max_edge", q.max_edge},
          {"min_dihedral", q.min_dihedral},
          {"max_dihedral", q.max_dihedral},
          {"min_radius_ratio", q.min_radius_ratio},
          {"mean_radius_ratio", q.mean_radius_ratio},
          {"repairs",
           {{"reordered_tetrahedra", repairs.reordered_tetrahedra},
            {"welded_nodes", repairs.welded_nodes},
            {"weld_tolerance", repairs.weld_tolerance},
            {"unreferenced_nodes", repairs.unreferenced_nodes}}},
          {"node_groups", groups},
          {"regions", regions},
          {"warnings", q.warnings}};
}

}  // namespace palpate::app
