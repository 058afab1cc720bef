#include "app/commands/press/press_state.hpp"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "sim/cycle/press.hpp"
#include "sim/mesh/read_mesh.hpp"
#include "tests/app/support/palpation.hpp"
#include "tests/support/temporary_folder.hpp"

namespace palpate::app {
namespace {

constexpr double kDepth = 4e-3;  // [m]

std::string read(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The numbers of an array of a VTU file, as a row for each point or cell.
Eigen::MatrixXd array(const std::string& vtu, const std::string& name, Eigen::Index components) {
  const std::size_t tag = vtu.find("Name=\"" + name + "\"");
  EXPECT_NE(tag, std::string::npos) << name;
  if (tag == std::string::npos) return {};
  const std::size_t first = vtu.find('>', tag) + 1;
  std::istringstream text(vtu.substr(first, vtu.find('<', first) - first));
  const std::vector<double> numbers{std::istream_iterator<double>(text), {}};
  return Eigen::Map<const Eigen::MatrixXd>(numbers.data(), components, std::ssize(numbers) / components)
      .transpose();
}

class SavedState : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { save_state(model_, press_.loads, state_); }

  std::string vtu(const sim::Body& body) const { return read(state_ + "." + body.name + ".vtu"); }

  palpate::test::TemporaryFolder folder_;
  std::string state_ = (folder_ / "state").string();
  sim::Model model_ = test::palpation(GetParam(), "1 MPa");
  sim::Press press_ = sim::press(model_, kDepth, 4);
};

TEST_P(SavedState, HoldsTheMeshOfEachBody) {
  for (const sim::Body& body : model_.bodies) {
    const sim::TetMesh mesh = sim::read_mesh(state_ + "." + body.name + ".vtu", 1.0).mesh;
    EXPECT_EQ(mesh.nodes, body.mesh->nodes);
    EXPECT_EQ(mesh.tetrahedra, body.mesh->tetrahedra);
  }
}

TEST_P(SavedState, HasTheProbeAtItsDepthAndTheSupportsAtRest) {
  const sim::Probe& probe = model_.probes.front();
  const sim::Body& body = model_.bodies[probe.body];
  const Eigen::MatrixXd displacement = array(vtu(body), "displacement", 3);
  ASSERT_EQ(displacement.rows(), std::ssize(body.mesh->nodes));
  const Eigen::Index node = body.compliance->touch[probe.nodes.front()];
  // 1e-9: the condensed solution, which the depth was asked of, beside the whole body's.
  EXPECT_LT((displacement.row(node).transpose() - kDepth * probe.direction).norm(), 1e-9 * kDepth);
  for (const int fixed : body.fixed) EXPECT_TRUE(displacement.row(fixed).isZero(0.0));
}

TEST_P(SavedState, HasForcesThatSumToThoseOfProbeAndContact) {
  const sim::PressStep& last = press_.curve.back();
  for (int b = 0; b < std::ssize(model_.bodies); ++b) {
    const Eigen::MatrixXd force = array(vtu(model_.bodies[b]), "force", 3);
    sim::Vec3 expected = model_.probes.front().body == b ? sim::Vec3(-last.probe_forces.front())
                                                         : sim::Vec3(sim::Vec3::Zero());
    for (std::size_t pair = 0; pair < model_.pairs.size(); ++pair)
      for (std::size_t side = 0; side < 2; ++side)
        if (model_.pairs[pair].bodies[side] == b) expected += last.pairs[pair].force_on[side];
    EXPECT_LT((force.colwise().sum().transpose() - expected).norm(), 1e-9 * last.probe_forces.front().norm());
  }
}

// Linear tetrahedra: the strain energy f.u / 2 by the file's forces and displacements is that of its stresses, whose
// deviatoric part is von_mises^2 / (6 mu) a volume; the rest of the energy is that of the change of volume.
TEST_P(SavedState, HasStressesWhoseEnergyIsTheForcesWork) {
  for (const sim::Body& body : model_.bodies) {
    const std::string text = vtu(body);
    const Eigen::MatrixXd force = array(text, "force", 3), u = array(text, "displacement", 3);
    const Eigen::MatrixXd von_mises = array(text, "von_mises", 1);
    ASSERT_EQ(von_mises.rows(), std::ssize(body.mesh->tetrahedra));
    const double young = body.materials[0].young_modulus, poisson = body.materials[0].poisson_ratio;
    const double mu = young / 2 / (1 + poisson), bulk = young / 3 / (1 - 2 * poisson);
    double energy = 0.0;
    for (Eigen::Index t = 0; t < von_mises.rows(); ++t) {
      Eigen::Matrix3d edges, moved;  // of the tetrahedron, from its first corner
      const sim::Tetrahedron& corners = body.mesh->tetrahedra[t];
      for (int k = 0; k < 3; ++k) {
        edges.col(k) = body.mesh->nodes[corners[k + 1]] - body.mesh->nodes[corners[0]];
        moved.col(k) = u.row(corners[k + 1]) - u.row(corners[0]);
      }
      const double dilation = (moved * edges.inverse()).trace();
      energy += edges.determinant() / 6 *
                (von_mises(t, 0) * von_mises(t, 0) / (6 * mu) + bulk / 2 * dilation * dilation);
    }
    EXPECT_NEAR(energy, force.cwiseProduct(u).sum() / 2, 1e-9 * energy);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SavedState, testing::Values("none", "kuroda", "exact"),
                         [](const auto& law) { return std::string(law.param); });

TEST(SaveState, WritesAllBodiesOrNone) {
  const palpate::test::TemporaryFolder folder;
  const sim::Model model = test::palpation("none", "1 MPa");
  const sim::Press press = sim::press(model, kDepth, 1);
  const std::string state = (folder / "state").string();
  std::ofstream(state + "." + model.bodies[0].name + ".vtu") << "of yesterday";
  std::filesystem::create_directory(state + "." + model.bodies[1].name + ".vtu");
  EXPECT_THROW(save_state(model, press.loads, state), std::system_error);
  EXPECT_EQ(read(state + "." + model.bodies[0].name + ".vtu"), "of yesterday");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

}  // namespace
}  // namespace palpate::app
