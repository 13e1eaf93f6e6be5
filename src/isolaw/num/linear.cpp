#include "isolaw/num/linear.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace isolaw::num {

Vector apply(MatrixView const& A, VectorView const& v) {
  return A * v;
}

Matrix product(MatrixView const& A, MatrixView const& B) {
  return A * B;
}

Matrix transposed_product(MatrixView const& A, MatrixView const& B) {
  return A.transpose() * B;
}

Matrix product_of_transposed(Matrix const& A, Vector const& d, Matrix const& B) {
  return A * d.asDiagonal() * B.transpose();
}

Matrix weighted_gram(Matrix const& J, Vector const& weights, double factor) {
  return factor * (J.transpose() * weights.asDiagonal() * J);
}

Symmetric symmetric_eigen(Matrix const& A) {
  Eigen::SelfAdjointEigenSolver<Matrix> const solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Singular singular_values(Matrix const& A) {
  // BDCSVD is not used: up to fifteen columns it only calls JacobiSVD, and it takes four times as long to compile.
  Eigen::JacobiSVD<Matrix> const svd(A, Eigen::ComputeThinV);
  return {svd.singularValues(), svd.matrixV()};
}

Vector least_squares(Matrix const& A, Vector const& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

Vector solve_symmetric(Matrix const& A, Vector const& b) {
  return A.ldlt().solve(b);
}

}  // namespace isolaw::num
