// 21: the same poses again, on several threads, and in another order.
#include <algorithm>
#include <thread>

#include "sim/contact/laws.hpp"
#include "tests/hard_cases/runs.hpp"
#include "tests/hard_cases/scenes.hpp"

namespace palpate::hard_cases {
namespace {

std::vector<Vec3> random_poses(Jitter& jitter, int count) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> depth(-0.5e-3, 3e-3), slant(-0.7e-3, 0.7e-3);
  std::vector<Vec3> poses;
  for (int i = 0; i < count; ++i)
    poses.push_back(jitter.of(Vec3(slant(random), slant(random), -depth(random))));
  return poses;
}

std::vector<Vec3> forces_along(const sim::Model& model, const std::vector<Vec3>& poses) {
  sim::Simulation simulation(model);
  std::vector<Vec3> forces;
  for (const Vec3& pose : poses) forces.emplace_back(step_to(simulation, pose).probe_forces.front());
  return forces;
}

}  // namespace

Outcome replay(Jitter& jitter) {
  const auto scene = write_scene(two_boxes(jitter));
  const std::vector<Vec3> poses = random_poses(jitter, 60);
  return of_all_laws(1e-9, [&](std::string_view law, Outcome& outcome) {
    const sim::Model model = compiled(scene, law);
    const std::vector<Vec3> alone = forces_along(model, poses);
    for (int threads = 1; threads <= 4; ++threads) {
      std::vector<std::vector<Vec3>> forces(static_cast<std::size_t>(threads));
      std::vector<std::thread> running;
      for (auto& of_thread : forces) running.emplace_back([&] { of_thread = forces_along(model, poses); });
      for (std::thread& thread : running) thread.join();
      for (const auto& of_thread : forces) outcome.expect(of_thread == alone, "a replay has other bits");
    }
    const std::vector<Vec3> back = forces_along(model, {poses.rbegin(), poses.rend()});
    double farthest = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      farthest = std::max(farthest, (back[poses.size() - 1 - i] - alone[i]).norm());
      largest = std::max(largest, alone[i].norm());
    }
    return farthest / largest;
  });
}

}  // namespace palpate::hard_cases
