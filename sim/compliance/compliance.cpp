#include "sim/compliance/compliance.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "sim/elasticity/supported_stiffness.hpp"

namespace palpate::sim {
namespace {

/// Refuses before anything is computed what would not fit: L_TT and C_TT side by side with the factor's own
/// trailing block, and C_DT.
void require_memory(std::size_t touch, std::size_t drawn) {
  const double t = 3.0 * static_cast<double>(touch), d = 3.0 * static_cast<double>(drawn);
  const double needed = 3 * t * t * sizeof(double) + d * t * sizeof(float);
  const double machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (needed > machine / 2)
    throw std::invalid_argument(fmt::format(
        "the compliance of {} touchable and {} drawn nodes needs {:.1f} GB, more than half of this machine's "
        "{:.1f} GB: name a smaller touchable group",
        touch, drawn, needed / 1e9, machine / 1e9));
}

/// L <- L^-1 in place, L lower triangular: halves, so that nearly all work is products of large blocks and
/// the zeros cost nothing (n^3/3 operations).
void invert_lower(Eigen::Ref<Eigen::MatrixXd> L) {
  const Eigen::Index n = L.rows(), half = n / 2;
  if (n <= 64) {
    const Eigen::MatrixXd inverse = L.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
    L = inverse;
    return;
  }
  auto upper = L.topLeftCorner(half, half), lower = L.bottomRightCorner(n - half, n - half);
  auto below = L.bottomLeftCorner(n - half, half);
  invert_lower(upper);
  invert_lower(lower);
  const Eigen::MatrixXd product = below * upper.triangularView<Eigen::Lower>();
  below.noalias() = -(lower.triangularView<Eigen::Lower>() * product);
}

/// C = L^-T L^-1 from L^-1, symmetric to the last bit. Row block k of L^-1 ends at its diagonal.
Eigen::MatrixXd gram(const Eigen::MatrixXd& inverse) {
  constexpr Eigen::Index kRows = 192;
  const Eigen::Index n = inverse.rows();
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index first = 0; first < n; first += kRows) {
    const Eigen::Index rows = std::min(kRows, n - first), columns = first + rows;
    C.topLeftCorner(columns, columns)
        .selfadjointView<Eigen::Lower>()
        .rankUpdate(inverse.block(first, 0, rows, columns).transpose());
  }
  C.triangularView<Eigen::StrictlyUpper>() = C.transpose();
  return C;
}

/// Where the touchable nodes meet the factor.
struct Border {
  const SupportedStiffness& stiffness;
  const Eigen::MatrixXd& inverse_factor;  // L_TT^-1
};

/// Rows of the nodes `wanted` of K^-1, columns of T, by back substitution from the columns of T: the solution
/// of L X = E_T is zero but for L_TT^-1 at its end, so that only L^T X = [0; L_TT^-1] is left to solve.
Eigen::MatrixXf by_columns(const Border& border, std::span<const int> wanted) {
  constexpr Eigen::Index kColumns = 96;
  const Eigen::MatrixXd& inverse = border.inverse_factor;
  const Eigen::Index t = inverse.cols();
  const auto n = static_cast<Eigen::Index>(3 * border.stiffness.order().size());
  Eigen::MatrixXf result(static_cast<Eigen::Index>(3 * wanted.size()), t);
  for (Eigen::Index first = 0; first < t; first += kColumns) {
    const Eigen::Index columns = std::min(kColumns, t - first);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, columns);
    right.bottomRows(t) = inverse.middleCols(first, columns);
    const Eigen::MatrixXd x = border.stiffness.solve_transposed(right);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const int place = border.stiffness.place_of()[wanted[k]];
      result.block(static_cast<Eigen::Index>(3 * k), first, 3, columns) =
          x.middleRows(3 * place, 3).cast<float>();
    }
  }
  return result;
}

/// The same by rows, for fewer rows than half the columns: K^-1 is symmetric.
Eigen::MatrixXf by_rows(const Border& border, std::span<const int> wanted) {
  constexpr std::size_t kNodes = 32;
  const Eigen::Index t = border.inverse_factor.cols();
  const auto n = static_cast<Eigen::Index>(3 * border.stiffness.order().size());
  Eigen::MatrixXf result(static_cast<Eigen::Index>(3 * wanted.size()), t);
  for (std::size_t first = 0; first < wanted.size(); first += kNodes) {
    const std::size_t nodes = std::min(kNodes, wanted.size() - first);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(3 * nodes));
    for (std::size_t k = 0; k < nodes; ++k) {
      const int place = border.stiffness.place_of()[wanted[first + k]];
      right.block<3, 3>(3 * place, static_cast<Eigen::Index>(3 * k)).setIdentity();
    }
    result.middleRows(static_cast<Eigen::Index>(3 * first), static_cast<Eigen::Index>(3 * nodes)) =
        border.stiffness.solve(right).bottomRows(t).transpose().cast<float>();
  }
  return result;
}

Eigen::MatrixXf drawn_rows(const Border& border, const Compliance& compliance) {
  std::vector<int> untouched;
  std::set_difference(compliance.drawn.begin(), compliance.drawn.end(), compliance.touch.begin(),
                      compliance.touch.end(), std::back_inserter(untouched));
  const Eigen::MatrixXf rows = 2 * untouched.size() < compliance.touch.size() ? by_rows(border, untouched)
                                                                              : by_columns(border, untouched);
  const Eigen::MatrixXd& C_TT = compliance.touch_touch;
  Eigen::MatrixXf C_DT(static_cast<Eigen::Index>(3 * compliance.drawn.size()), C_TT.cols());
  Eigen::Index next = 0;
  for (std::size_t d = 0; d < compliance.drawn.size(); ++d) {
    const auto touch = std::ranges::lower_bound(compliance.touch, compliance.drawn[d]);
    auto target = C_DT.middleRows(static_cast<Eigen::Index>(3 * d), 3);
    if (touch != compliance.touch.end() && *touch == compliance.drawn[d]) {
      target = C_TT.middleRows(3 * (touch - compliance.touch.begin()), 3).cast<float>();
    } else {
      target = rows.middleRows(next, 3);
      next += 3;
    }
  }
  return C_DT;
}

}  // namespace

Compliance condense(const Eigen::SparseMatrix<double>& K, std::span<const int> fixed,
                    std::span<const int> touch, std::span<const int> drawn) {
  require_memory(touch.size(), drawn.size());
  const SupportedStiffness stiffness(K, fixed, touch);
  Eigen::MatrixXd inverse = stiffness.trailing_factor();
  invert_lower(inverse);
  Compliance compliance{.touch = {touch.begin(), touch.end()},
                        .drawn = {drawn.begin(), drawn.end()},
                        .touch_touch = gram(inverse),
                        .drawn_touch = {}};
  compliance.drawn_touch = drawn_rows({.stiffness = stiffness, .inverse_factor = inverse}, compliance);
  return compliance;
}

}  // namespace palpate::sim
