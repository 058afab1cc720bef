// The catalogue: one line a case. Each run stands in a file of its own, or beside that of a case close to it.
#include "tests/hard_cases/runs.hpp"

namespace palpate::hard_cases {
namespace {

constexpr const char* kAll = "all";
constexpr const char* kExactOnly = "exact";
constexpr const char* kNoContact = "-";

const HardCase kCases[] = {
    // Meshes
    {2, "MaterialBounds", "nu ≥ 0.5 or ≤ -1, E ≤ 0, no number", "refused, key named", "", kNoContact,
     material_bounds},
    {3, "Slivers", "slivers, dihedral below 1°", "reported; residual of K u = f ≤ 1e-9", "‖K u − f‖ / ‖f‖",
     kNoContact, slivers},
    {4, "InvertedTetrahedra", "inverted tetrahedra", "reordered and counted; else refused with their ids", "",
     kNoContact, inverted_tetrahedra},
    {5, "DuplicateNodes", "duplicate nodes", "welded within 1e-9 of the diagonal, counted; beyond it kept",
     "", kNoContact, duplicate_nodes},
    {6, "UnreferencedNodes", "unreferenced nodes", "left out, counted", "", kNoContact, unreferenced_nodes},
    {7, "NonManifoldSurface", "surface that meets itself", "refused, the edge, node or face named", "",
     kNoContact, non_manifold_surface},
    {8, "LoosePiece", "several pieces, one without support", "refused, the piece named", "", kNoContact,
     loose_piece},
    {9, "Units", "millimetres, or read as metres", "unit asked for, odd sizes warned of; same force",
     "difference of force in mm and m", kNoContact, units},
    {10, "FarFromOrigin", "1e4 m from the origin", "force differs by the file's rounding: ≤ 1e-6",
     "difference of force", kExactOnly, far_from_origin},
    {11, "Permuted", "nodes and elements permuted", "same force to 1e-10", "difference of force", kExactOnly,
     permuted},
    {12, "MovedScene", "scene rotated, mirrored, translated", "same force, moved along, to 1e-10",
     "difference of force", kAll, moved_scene},
    {13, "DamagedFiles", "mesh files damaged or claiming 1e9 elements",
     "line named, no crash; no memory before the claim is checked", "taken while refusing [B]", kNoContact,
     damaged_files},
    // Algebra
    {14, "NoFixedNode", "no fixed node", "refused, 6 of 6 rigid motions named", "", kNoContact,
     no_fixed_node},
    {15, "FewFixedNodes", "1, 2, 3 fixed nodes; 3 on a line", "rank that is missing named; 3 suffice", "",
     kNoContact, few_fixed_nodes},
    {16, "StiffnessRatio", "moduli in ratios 1e6 and 1e-6",
     "from K: total force to 1e-6, nodal to 1e-4, no stall", "error of total force", kExactOnly,
     stiffness_ratio},
    {17, "ComplianceSpd", "compliance of an irregular body", "symmetric to 1e-12, positive definite",
     "asymmetry / largest entry", kNoContact, compliance_spd},
    {18, "DamagedCache", "cache stale, cut, flipped, of another version, written twice at once",
     "found, made anew", "", kNoContact, damaged_cache},
    {19, "SinglePrecision", "compliance in single precision",
     "error within the bound that is told, to 1e-6; same contacts closed", "error of force / its bound",
     kExactOnly, single_precision},
    {20, "Denormals", "displacements of 1e-99 to 1e-310 m",
     "p99 as at rest or in a press (2 times: the clock)", "p99 / usual p99", kAll, denormals},
    {21, "Replay", "poses replayed, on 1 to 4 threads; reached by another way",
     "same bits; by another way same force to 1e-9", "difference by another way", kAll, replay},
    {22, "BigSizes", "more than 2^31 entries", "refused before memory is taken", "", kNoContact, big_sizes},
    // Contact
    {23, "NeedleTriangle", "contact triangle of no area",
     "refused with its id; a needle of 1e-6: force to 1 %", "difference of force by a needle", kExactOnly,
     needle_triangle},
    {24, "RedundantContacts", "each contact twice, W singular", "one net force to 1e-9; no push above it",
     "difference of net force", kExactOnly, redundant_contacts},
    {25, "FixedContact", "contact surfaces with fixed nodes of both", "no row with W_nn = 0, no Inf",
     "least W_nn / largest", kExactOnly, fixed_contact},
    {26, "HeldAndTouched", "node held by a probe and in contact", "action = reaction to 1e-9",
     "‖f_A + f_B‖ / ‖f_A‖", kExactOnly, held_and_touched},
    {27, "NodeOnCorner", "nodes on edges and corners of polygons",
     "one polygon a node; 1e-12 m beside: same to 1e-6", "difference of force by 1e-12 m", kExactOnly,
     node_on_corner},
    {28, "DeepOverlap", "bodies deep in each other at rest",
     "refused, contact.overlap named; if declared, no force", "force at 1 nm / at 1 mm", kAll, deep_overlap},
    {29, "JumpThroughWall", "probe jumps through the wall in one cycle",
     "same force as the slow way, to 1e-9", "difference of force", kAll, jump_through_wall},
    {30, "GrazingContact", "gap exactly 0, grazing", "‖F‖ ≤ L ‖d‖", "‖F‖ / (L ‖d‖)", kExactOnly,
     grazing_contact},
    {31, "OnsetOfContact", "onset of contact, steps of 1 µm", "‖dF‖ ≤ L ‖dx‖", "largest ‖dF‖ / (L ‖dx‖)",
     kExactOnly, onset_of_contact},
    {32, "SlidingAcross", "sliding across nodes, edges, corners, steps of 1 µm", "‖dF‖ ≤ L ‖dx‖",
     "largest ‖dF‖ / (L ‖dx‖)", kExactOnly, sliding_across},
    {33, "Friction", "mu = 0, 0.3, 1.5, stick and slip", "in the cone to 1e-8; mu = 0 is exact; one solution",
     "excess over the cone", "exact with friction", friction},
    {34, "IterationCap", "cap of iterations reached",
     "feasible forces, error bounded; flagged, counted in the trial", "error of force / its bound",
     kExactOnly, iteration_cap},
    {35, "ReorderedContacts", "contacts in another order", "same force to 1e-9", "difference of force",
     kExactOnly, reordered_contacts},
    {36, "Pinched", "thin organ pinched from both sides", "no force changes its sign",
     "least force / largest", kAll, pinched},
    // Loop and device
    {42, "BadDevice", "NaN, Inf, 1e30 from the device", "zero within 20 ms, never up, latched",
     "time to zero [ms]", kNoContact, bad_device},
    {43, "GapInInput", "gap of 500 ms", "no kick: force ramps", "largest rise / that of the ramp", kNoContact,
     gap_in_input},
    {44, "Overrun", "overrun of the loop", "counted; the last safe force decays",
     "force left by 20 ms late / force", kNoContact, overrun},
    {45, "NoisyProbe", "probe noisy by 10 µm at 1 kHz", "rms of force ≤ L × rms of place",
     "rms F / (L rms x)", kExactOnly, noisy_probe},
    {46, "DeviceLost", "device lost", "motors off within 20 ms of the loss being known", "time to zero [ms]",
     kNoContact, device_lost},
    {47, "DeviceLimit", "force above the device's limit", "clamped, and recorded as clamped", "force / limit",
     kNoContact, device_limit},
    {48, "TornSnapshot", "state between threads", "never torn (and clean under TSan in CI)", "torn reads",
     kNoContact, torn_snapshot},
    {49, "ClosedLoops", "closed loops in space, footprint held", "work ≤ 1e-6 of the stored energy; F = −∇V",
     "‖work‖ / largest stored energy", kExactOnly, closed_loops},
    {50, "MillionCycles", "a million random cycles, in and out of the workspace", "finite; ‖F‖ ≤ L ‖d‖",
     "largest ‖F‖ / (L ‖d‖)", kExactOnly, million_cycles},
    // Found in use
    {51, "TouchingAtRest", "bodies that touch exactly at rest",
     "as 1e-12 m apart: same contacts, force to 1e-7", "difference of force", kAll, touching_at_rest},
    {52, "ProbeOnContact", "probe on the surface in contact", "‖dF‖ ≤ L ‖dx‖", "largest ‖dF‖ / (L ‖dx‖)",
     kExactOnly, probe_on_contact},
    {53, "ThroughThickness", "slab pressed through its own thickness", "no contact lost, force keeps rising",
     "least rise / mean rise", kAll, through_thickness},
    {54, "SignOfForce", "single press, all depths", "force never pulls the finger in",
     "least force / largest", kAll, sign_of_force},
    {55, "ProbeOnFixedNode", "probe on a fixed node", "refused, key named", "", kNoContact,
     probe_on_fixed_node},
    {56, "TwoProbesOneNode", "two probes in one node", "refused, key named", "", kNoContact,
     two_probes_one_node},
    {57, "OneLayer", "body of one layer of tetrahedra", "finite; residual of contact from K ≤ 1e-8",
     "residual of contact", kExactOnly, one_layer},
};

const OpenCase kOpen[] = {
    {1, "nu → 0.5: linear tetrahedra lock", "force to 5 % of a mixed or refined reference",
     "no near-incompressible elements yet"},
    {37, "element rotated by 180°", "continuous", "small strain only so far"},
    {38, "collapsed or inverted element", "finite, recovers", "small strain only so far"},
    {39, "Newton stalls", "line search, status", "small strain only so far"},
    {40, "rigid rotation", "gives no force", "small strain only so far"},
    {41, "energy with viscosity", "never grows without work", "no viscosity yet"},
};

}  // namespace

std::span<const HardCase> hard_cases() {
  return kCases;
}
std::span<const OpenCase> open_cases() {
  return kOpen;
}

}  // namespace palpate::hard_cases
