// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/symmetric_factors.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <utility>
#include <vector>

#include <riprap/core/random.hpp>
#include <support/near.hpp>

using namespace riprap;

namespace {

// Symmetric and definite; its condition is that of a random matrix.
Eigen::MatrixXd random_matrix(Eigen::Index size, Random& random) {
  Eigen::MatrixXd root(size, size);
  for (Eigen::Index i = 0; i < root.size(); ++i) root.data()[i] = random.uniform(-1, 1);
  return root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
}

}  // namespace

TEST_CASE("the solution solves the equations") {
  Random random(17);
  // Below and above a panel of 8 columns, a block of 16 and 128 columns.
  for (const Eigen::Index size : {1, 2, 3, 7, 8, 9, 16, 33, 127, 130, 150}) {
    const Eigen::MatrixXd matrix = random_matrix(size, random);
    const SymmetricFactors factors({matrix.data(), matrix.data() + matrix.size()},
                                   static_cast<std::size_t>(size));
    Eigen::VectorXd right_side(size);
    for (Eigen::Index i = 0; i < size; ++i) right_side[i] = random.uniform(-1, 1);
    Eigen::VectorXd solution = right_side;
    factors.solve(solution.data());
    // Backward stable: a few units of round-off of the terms.
    const double terms = matrix.cwiseAbs().rowwise().sum().maxCoeff() * solution.norm();
    CHECK((matrix * solution - right_side).norm() <= 1e-13 * terms);
  }
}

TEST_CASE("only the lower triangle is read, and pivots bring the largest diagonal first") {
  // By columns; without pivots the first division would be by zero.
  const SymmetricFactors factors({0, 2, 99, 3}, 2);  // [[0, 2], [2, 3]]
  std::vector<double> x{2, 5};
  factors.solve(x.data());
  CHECK(x[0] == test::near(1, 1e-15));
  CHECK(x[1] == test::near(1, 1e-15));
}

TEST_CASE("sums have the same order for every number of rows") {
  Random random(18);
  const std::size_t columns = 131;
  const std::size_t rows = 37;
  std::vector<double> a(rows * columns);
  std::vector<double> x(columns);
  for (double& value : a) value = random.uniform(-1, 1);
  for (double& value : x) value = random.uniform(-1, 1);
  std::vector<double> all(rows, 0.5);
  internal::subtract_product(rows, columns, a.data(), rows, x.data(), all.data());
  for (std::size_t i = 0; i < rows; ++i) {
    double one = 0.5;
    internal::subtract_product(1, columns, a.data() + i, rows, x.data(), &one);
    CHECK(one == all[i]);
  }
}
