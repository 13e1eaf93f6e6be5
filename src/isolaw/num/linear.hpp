// Linear algebra on Eigen's vectors and matrices. Products and decompositions take long to compile, so only linear.cpp
// compiles them. All callers therefore also get the same order of summation in a product, and so the same rounding.
#pragma once

#include <Eigen/Core>

namespace isolaw::num {

using Eigen::Index;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using MatrixView = Eigen::Ref<Matrix const>;
using VectorView = Eigen::Ref<Vector const>;

Vector apply(MatrixView const& A, VectorView const& v);
Matrix product(MatrixView const& A, MatrixView const& B);
Matrix transposed_product(MatrixView const& A, MatrixView const& B);                // Aᵀ B
Matrix product_of_transposed(Matrix const& A, Vector const& d, Matrix const& B);    // A diag(d) Bᵀ
Matrix weighted_gram(Matrix const& J, Vector const& weights, double factor = 1.0);  // factor Jᵀ diag(weights) J

struct Symmetric {
  Vector values;   // the eigenvalues in ascending order
  Matrix vectors;  // one eigenvector of unit length in each column
};
Symmetric symmetric_eigen(Matrix const& A);

struct Singular {
  Vector values;  // the singular values in descending order
  Matrix right;   // one right singular vector in each column
};
Singular singular_values(Matrix const& A);

Vector least_squares(Matrix const& A, Vector const& b);    // the shortest x that minimises |A x - b|
Vector solve_symmetric(Matrix const& A, Vector const& b);  // the solution of A x = b for a symmetric A

}  // namespace isolaw::num
