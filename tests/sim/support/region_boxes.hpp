#pragma once

#include <filesystem>
#include <string>

namespace palpate::sim::test {

/// A small box, "upper", 0.2 mm over a larger one, "lower", as a scene on disk: body tables (body_table.hpp), the contact
/// table and those of the probes as a test wants them. Groups: x_min .. z_max of each.
std::filesystem::path write_region_boxes(const std::string& upper, const std::string& lower,
                                         const std::string& contact, const std::string& probes);

/// The table of a body that no fixed node holds.
std::string without_fixed(std::string body_table);

/// The table of a probe that holds a group of a body as one and goes down.
/// @param reach  how far it takes a body that nothing else holds: "20 mm"; empty: it does not
std::string region_table(const std::string& name, const std::string& body, const std::string& group,
                         const std::string& reach = "");

}  // namespace palpate::sim::test
