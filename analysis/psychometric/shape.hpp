#pragma once

#include <string_view>

namespace palpate::analysis {

/// The form F of a psychometric function psi(x) = guess + (1 - guess - lapse) F(x). Every form is a standard
/// distribution function of eta = beta (u - alpha), where u is the level x, or log x for the Weibull
/// function.
enum class Shape {
  Logistic,    // F = 1/(1 + exp(-eta))
  Gaussian,    // F = Phi(eta), the cumulative Gaussian
  Weibull,     // F = 1 - exp(-(x/a)^beta), a = exp(alpha); levels > 0
  GumbelLeft,  // F = 1 - exp(-exp(eta)), its density skewed to the left: the log-Weibull function
  GumbelRight  // F = exp(-exp(-eta)), its density skewed to the right
};

/// "logistic", "gaussian", "weibull", "gumbel-left", "gumbel-right"; else a std::invalid_argument lists them.
Shape shape_from_name(std::string_view name);
std::string_view name_of(Shape shape);

/// "F(x) = 1/(1 + exp(-beta (x - alpha)))"
std::string_view formula_of(Shape shape);

bool on_log_levels(Shape shape);
double to_scale(Shape shape, double level);    // u of x
double from_scale(Shape shape, double place);  // x of u

/// eta at which F = p, 0 < p < 1.
double shape_quantile(Shape shape, double p);

/// F, 1 - F (each to its own relative accuracy), dF/deta and its derivative.
struct ShapeValue {
  double below = 0.0;    // F
  double above = 0.0;    // 1 - F
  double density = 0.0;  // F'
  double bend = 0.0;     // F''
};
ShapeValue shape_at(Shape shape, double eta);

}  // namespace palpate::analysis
