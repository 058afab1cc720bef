#pragma once

#include "tests/hard_cases/hard_case.hpp"

namespace palpate::hard_cases {

// The runs of the cases, in the order of the catalogue (cases.cpp).
Outcome material_bounds(Jitter& jitter);
Outcome slivers(Jitter& jitter);
Outcome inverted_tetrahedra(Jitter& jitter);
Outcome duplicate_nodes(Jitter& jitter);
Outcome unreferenced_nodes(Jitter& jitter);
Outcome non_manifold_surface(Jitter& jitter);
Outcome loose_piece(Jitter& jitter);
Outcome units(Jitter& jitter);
Outcome far_from_origin(Jitter& jitter);
Outcome permuted(Jitter& jitter);
Outcome moved_scene(Jitter& jitter);
Outcome damaged_files(Jitter& jitter);
Outcome no_fixed_node(Jitter& jitter);
Outcome few_fixed_nodes(Jitter& jitter);
Outcome stiffness_ratio(Jitter& jitter);
Outcome compliance_spd(Jitter& jitter);
Outcome damaged_cache(Jitter& jitter);
Outcome single_precision(Jitter& jitter);
Outcome denormals(Jitter& jitter);
Outcome replay(Jitter& jitter);
Outcome big_sizes(Jitter& jitter);
Outcome needle_triangle(Jitter& jitter);
Outcome redundant_contacts(Jitter& jitter);
Outcome fixed_contact(Jitter& jitter);
Outcome held_and_touched(Jitter& jitter);
Outcome node_on_corner(Jitter& jitter);
Outcome deep_overlap(Jitter& jitter);
Outcome jump_through_wall(Jitter& jitter);
Outcome grazing_contact(Jitter& jitter);
Outcome onset_of_contact(Jitter& jitter);
Outcome sliding_across(Jitter& jitter);
Outcome friction(Jitter& jitter);
Outcome iteration_cap(Jitter& jitter);
Outcome reordered_contacts(Jitter& jitter);
Outcome pinched(Jitter& jitter);
Outcome bad_device(Jitter& jitter);
Outcome gap_in_input(Jitter& jitter);
Outcome overrun(Jitter& jitter);
Outcome noisy_probe(Jitter& jitter);
Outcome device_lost(Jitter& jitter);
Outcome device_limit(Jitter& jitter);
Outcome torn_snapshot(Jitter& jitter);
Outcome closed_loops(Jitter& jitter);
Outcome million_cycles(Jitter& jitter);
Outcome touching_at_rest(Jitter& jitter);
Outcome probe_on_contact(Jitter& jitter);
Outcome through_thickness(Jitter& jitter);
Outcome sign_of_force(Jitter& jitter);
Outcome probe_on_fixed_node(Jitter& jitter);
Outcome two_probes_one_node(Jitter& jitter);
Outcome one_layer(Jitter& jitter);

}  // namespace palpate::hard_cases
