// Vectors and matrices, and what of linear algebra takes long to compile: products of matrices and decompositions,
// compiled once. Products are written out as one expression each, so that their sums are taken in one order everywhere.
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
Vector apply_transposed(MatrixView const& A, VectorView const& v);    // Aᵀ v
Matrix transposed_product(MatrixView const& A, MatrixView const& B);  // Aᵀ B
// A diag(d) Bᵀ
Matrix product_of_transposed(Matrix const& A, Vector const& d, Matrix const& B);
// factor Jᵀ diag(weights) J
Matrix weighted_gram(Matrix const& J, Vector const& weights, double factor = 1.0);

struct Symmetric {
  Vector values;   // ascending
  Matrix vectors;  // of unit length, one a column
};
Symmetric symmetric_eigen(Matrix const& A);

struct Singular {
  Vector values;  // descending
  Matrix right;   // one vector a column
};
Singular singular_values(Matrix const& A);

// Of least norm among those that leave the least of A x - b.
Vector least_squares(Matrix const& A, Vector const& b);

// A x = b for a symmetric A.
Vector solve_symmetric(Matrix const& A, Vector const& b);

}  // namespace isolaw::num
