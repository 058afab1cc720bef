#include "sim/elasticity/supported_stiffness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "sim/elasticity/cholmod.hpp"
#include "sim/elasticity/supports.hpp"

namespace palpate::sim {
namespace {

// CHOLMOD's long interface throughout: the factor of a large body passes 2^31 entries.
using Index = SuiteSparse_long;
using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

struct Common {
  Common() {
    cholmod().start(&settings);
    settings.print = 0;
    settings.error_handler = nullptr;
    settings.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Common() { cholmod().finish(&settings); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;

  void require_success() const {
    if (settings.status == CHOLMOD_OUT_OF_MEMORY || settings.status == CHOLMOD_TOO_LARGE)
      throw std::runtime_error(
          "this machine's memory is too small to factorise the body's stiffness: use a coarser mesh");
    if (settings.status < CHOLMOD_OK)
      throw std::runtime_error(fmt::format("CHOLMOD failed with status {}", settings.status));
  }

  cholmod_common settings{};
};

/// A borrowed view of the lower triangle of a symmetric matrix.
cholmod_sparse view(const Matrix& lower, int values) {
  cholmod_sparse sparse{};
  sparse.nrow = lower.rows();
  sparse.ncol = lower.cols();
  sparse.nzmax = lower.nonZeros();
  sparse.p = const_cast<Index*>(lower.outerIndexPtr());
  sparse.i = const_cast<Index*>(lower.innerIndexPtr());
  sparse.x = values == CHOLMOD_PATTERN ? nullptr : const_cast<double*>(lower.valuePtr());
  sparse.stype = -1;
  sparse.itype = CHOLMOD_LONG;
  sparse.xtype = values;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = 1;
  sparse.packed = 1;
  return sparse;
}

/// The nodes marked as inner, in an order that keeps the factor sparse and is a postorder of its elimination
/// tree, as supernodes need. Whole nodes are ordered, not unknowns: a third of the size, a ninth of the work.
std::vector<int> fill_reducing_order(const NodeGraph& graph, const std::vector<char>& inner) {
  std::vector<int> nodes;
  std::vector<Index> number(inner.size(), -1);
  for (std::size_t node = 0; node < inner.size(); ++node)
    if (inner[node]) {
      number[node] = static_cast<Index>(nodes.size());
      nodes.push_back(static_cast<int>(node));
    }
  if (nodes.empty()) return nodes;
  Matrix pattern(static_cast<Index>(nodes.size()), static_cast<Index>(nodes.size()));
  for (std::size_t column = 0; column < nodes.size(); ++column) {
    pattern.startVec(static_cast<Index>(column));
    pattern.insertBackByOuterInner(static_cast<Index>(column), static_cast<Index>(column)) = 1.0;
    const std::size_t node = nodes[column];
    for (int k = graph.begin[node]; k < graph.begin[node + 1]; ++k) {
      const Index row = number[graph.neighbour[k]];
      if (row > static_cast<Index>(column))
        pattern.insertBackByOuterInner(static_cast<Index>(column), row) = 1.0;
    }
  }
  pattern.finalize();

  Common common;
  common.settings.nmethods = 2;  // the sparser factor of the two
  common.settings.method[0].ordering = CHOLMOD_AMD;
  common.settings.method[1].ordering = CHOLMOD_METIS;
  cholmod_sparse sparse = view(pattern, CHOLMOD_PATTERN);
  // METIS draws from the C library's one random sequence: alone, so that the same mesh gives the same order.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  cholmod_factor* symbolic = cholmod().analyze(&sparse, &common.settings);
  common.require_success();
  const auto* permutation = static_cast<const Index*>(symbolic->Perm);
  std::vector<int> order(nodes.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = nodes[permutation[k]];
  cholmod().free_factor(&symbolic, &common.settings);
  return order;
}

/// Lower triangle of K with rows and columns in the given order of nodes; what has no place is struck out.
Matrix reordered_lower(const Eigen::SparseMatrix<double>& K, const std::vector<int>& order,
                       const std::vector<int>& place_of) {
  const auto unknowns = static_cast<Index>(3 * order.size());
  Matrix lower(unknowns, unknowns);
  lower.reserve(static_cast<Index>(K.nonZeros() / 2 + K.cols()));
  std::vector<std::pair<Index, double>> entries;
  for (Index column = 0; column < unknowns; ++column) {
    const int source = 3 * order[column / 3] + static_cast<int>(column % 3);
    entries.clear();
    for (Eigen::SparseMatrix<double>::InnerIterator entry(K, source); entry; ++entry) {
      const Index place = place_of[entry.row() / 3];
      const Index row = 3 * place + static_cast<Index>(entry.row() % 3);
      if (place >= 0 && row >= column) entries.emplace_back(row, entry.value());
    }
    std::ranges::sort(entries);
    lower.startVec(column);
    for (const auto& [row, value] : entries) lower.insertBackByOuterInner(column, row) = value;
  }
  lower.finalize();
  return lower;
}

[[noreturn]] void refuse_singular() {
  throw std::invalid_argument(
      "supports leave 1 of 6 rigid motions or more free: the stiffness is singular although every piece has "
      "three fixed nodes or more; they lie on one line, or a part of the body hangs on a single node or "
      "edge");
}

}  // namespace

struct SupportedStiffness::Factor {
  ~Factor() { cholmod().free_factor(&L, &common.settings); }

  void factorise() {
    common.settings.nmethods = 1;
    common.settings.method[0].ordering = CHOLMOD_NATURAL;
    common.settings.postorder = 0;  // a postorder would move the `last` nodes away from the end
    cholmod_sparse sparse = view(A, CHOLMOD_REAL);
    L = cholmod().analyze(&sparse, &common.settings);
    common.require_success();
    cholmod().factorize(&sparse, L, &common.settings);
    common.require_success();
    if (common.settings.status == CHOLMOD_NOT_POSDEF) refuse_singular();
    assert(L->is_super && L->is_ll);
  }

  Eigen::MatrixXd solve(int system, const Eigen::MatrixXd& b) const {
    assert(b.rows() == A.rows());
    if (b.size() == 0) return b;
    cholmod_dense right{};
    right.nrow = right.d = b.rows();
    right.ncol = b.cols();
    right.nzmax = b.size();
    right.x = const_cast<double*>(b.data());
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    // A setting of its own for each call: CHOLMOD keeps workspace there, and threads may share the factor.
    Common mine;
    cholmod_dense* x = cholmod().solve(system, L, &right, &mine.settings);
    mine.require_success();
    Eigen::MatrixXd result =
        Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), b.rows(), b.cols());
    cholmod().free_dense(&x, &mine.settings);
    return result;
  }

  /// A motion without energy survives rounding as a tiny positive pivot, and the factorisation goes through.
  /// Two inverse iterations find it: the energy of z against that of its entries one by one, z.Az / z.Dz with
  /// D = diag A, is then rounding (1e-16), and above 1e-12 for any body that is held, however slender.
  void refuse_motion_without_energy() const {
    const Eigen::VectorXd D = A.diagonal();
    Eigen::VectorXd z = Eigen::VectorXd::LinSpaced(A.rows(), 0.5, 1.5);
    for (Eigen::Index i = 0; i < z.size(); ++i)
      if (i % 3 == 1 || i % 7 == 3) z[i] = -z[i];
    for (int iteration = 0; iteration < 2; ++iteration) {
      z = solve(CHOLMOD_A, D.cwiseProduct(z)).col(0);
      z /= z.cwiseAbs().maxCoeff();
    }
    const double energy = z.dot(A.selfadjointView<Eigen::Lower>() * z);
    if (!(energy > 1e-13 * z.dot(D.cwiseProduct(z)))) refuse_singular();
  }

  std::vector<int> order, place_of;
  Eigen::Index trailing = 0;  // unknowns of the `last` nodes
  Matrix A;                   // lower triangle
  Common common{};
  cholmod_factor* L = nullptr;
};

SupportedStiffness::SupportedStiffness(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                                       std::span<const int> last)
    : factor_(std::make_unique<Factor>()) {
  const NodeGraph graph = node_graph(K);
  require_supports(graph, fixed);
  std::vector<char> inner(graph.nodes(), 1);
  for (const int node : fixed) inner[node] = 0;
  for (const int node : last) inner[node] = 0;
  factor_->order = fill_reducing_order(graph, inner);
  factor_->order.insert(factor_->order.end(), last.begin(), last.end());
  factor_->place_of.assign(inner.size(), -1);
  for (std::size_t place = 0; place < factor_->order.size(); ++place)
    factor_->place_of[factor_->order[place]] = static_cast<int>(place);
  factor_->trailing = static_cast<Eigen::Index>(3 * last.size());
  factor_->A = reordered_lower(K, factor_->order, factor_->place_of);
  if (factor_->order.empty()) return;
  factor_->factorise();
  factor_->refuse_motion_without_energy();
}

SupportedStiffness::~SupportedStiffness() = default;

const std::vector<int>& SupportedStiffness::order() const {
  return factor_->order;
}
const std::vector<int>& SupportedStiffness::place_of() const {
  return factor_->place_of;
}

Eigen::MatrixXd SupportedStiffness::solve(const Eigen::MatrixXd& b) const {
  return factor_->solve(CHOLMOD_A, b);
}

Eigen::MatrixXd SupportedStiffness::solve_transposed(const Eigen::MatrixXd& b) const {
  return factor_->solve(CHOLMOD_Lt, b);
}

Eigen::MatrixXd SupportedStiffness::trailing_factor() const {
  const Eigen::Index first = factor_->A.rows() - factor_->trailing;
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(factor_->trailing, factor_->trailing);
  if (factor_->trailing == 0) return block;
  const cholmod_factor& L = *factor_->L;
  const auto* super = static_cast<const Index*>(L.super);  // first column of each supernode
  const auto* rows_at = static_cast<const Index*>(L.pi);   // where its row numbers begin
  const auto* values_at = static_cast<const Index*>(L.px);
  const auto* row = static_cast<const Index*>(L.s);
  const auto* value = static_cast<const double*>(L.x);
  for (std::size_t s = 0; s < L.nsuper; ++s)
    for (Index column = std::max(super[s], first); column < super[s + 1]; ++column) {
      const Index rows = rows_at[s + 1] - rows_at[s];
      const double* entry = value + values_at[s] + (column - super[s]) * rows;
      for (Index k = column - super[s]; k < rows; ++k)
        block(row[rows_at[s] + k] - first, column - first) = entry[k];
    }
  return block;
}

}  // namespace palpate::sim
