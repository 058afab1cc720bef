#include "analysis/psychometric/shape.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

using namespace palpate::analysis;

namespace {

constexpr Shape kShapes[] = {Shape::Logistic, Shape::Gaussian, Shape::Weibull, Shape::GumbelLeft,
                             Shape::GumbelRight};

}  // namespace

TEST(Shape, AgreesWithItsFormula) {
  // R 4.2: plogis(1.3), pnorm(1.3), 1 - exp(-exp(1.3)), exp(-exp(-1.3))
  EXPECT_NEAR(shape_at(Shape::Logistic, 1.3).below, 0.785834983042559, 1e-15);
  EXPECT_NEAR(shape_at(Shape::Gaussian, 1.3).below, 0.903199515414390, 1e-15);
  EXPECT_NEAR(shape_at(Shape::GumbelLeft, 1.3).below, 1 - std::exp(-std::exp(1.3)), 1e-15);
  EXPECT_NEAR(shape_at(Shape::GumbelRight, 1.3).below, std::exp(-std::exp(-1.3)), 1e-15);
}

TEST(Shape, SkewsToTheSideThatItsNameSays) {
  // The left-skewed Gumbel leaves slowly from 0 and arrives fast at 1.
  const auto length = [](Shape shape, double from, double to) {
    return shape_quantile(shape, to) - shape_quantile(shape, from);
  };
  EXPECT_GT(length(Shape::GumbelLeft, 0.05, 0.5), length(Shape::GumbelLeft, 0.5, 0.95));
  EXPECT_LT(length(Shape::GumbelRight, 0.05, 0.5), length(Shape::GumbelRight, 0.5, 0.95));
}

TEST(Shape, QuantileUndoesIt) {
  for (const Shape shape : kShapes) {
    for (const double p : {1e-6, 0.05, 0.25, 0.5, 0.7, 0.99}) {
      const ShapeValue value = shape_at(shape, shape_quantile(shape, p));
      EXPECT_NEAR(value.below / p, 1, 1e-12) << name_of(shape) << " " << p;
      EXPECT_NEAR(value.above / (1 - p), 1, 1e-11) << name_of(shape) << " " << p;
    }
  }
}

TEST(Shape, DerivativesAreThoseOfItsValues) {
  EXPECT_TRUE(rc::check([] {
    const Shape shape = *rc::gen::elementOf(std::vector<Shape>(std::begin(kShapes), std::end(kShapes)));
    const double eta = *rc::gen::inRange(-400, 200) / 100.0, h = 1e-5;
    const ShapeValue here = shape_at(shape, eta), on = shape_at(shape, eta + h),
                     back = shape_at(shape, eta - h);
    RC_ASSERT(std::abs((on.below - back.below) / (2 * h) - here.density) < 1e-9);
    RC_ASSERT(std::abs((on.density - back.density) / (2 * h) - here.bend) < 1e-9);
    RC_ASSERT(std::abs(here.below + here.above - 1) < 1e-15);
  }));
}

TEST(Shape, KeepsSmallProbabilities) {
  // R 4.2: pnorm(-20), plogis(-40); on either side
  EXPECT_NEAR(shape_at(Shape::Gaussian, -20).below / 2.75362411860623e-89, 1, 1e-12);
  EXPECT_NEAR(shape_at(Shape::Logistic, 40).above / 4.24835425529159e-18, 1, 1e-13);
}
