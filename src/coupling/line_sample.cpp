#include "coupling/line_sample.hpp"

#include <Eigen/QR>
#include <cmath>
#include <limits>

namespace shmoo::coupling {
namespace {

// The monomials of degree 0, 1 and 2 at r.
template <int D>
Eigen::VectorXd monomials(const base::Vec<D>& r) {
  Eigen::VectorXd m(1 + D + D * (D + 1) / 2);
  m[0] = 1.0;
  Eigen::Index next = 1;
  for (int a = 0; a < D; ++a) m[next++] = r[a];
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) m[next++] = r[a] * r[b];
  return m;
}

}  // namespace

template <int D>
double sample_at(const Scatter<D>& scatter, const base::Box<D>& box, const base::Vec<D>& point, double reach) {
  std::vector<base::Vec<D>> near;  // in reaches
  std::vector<double> value;
  double closest = std::numeric_limits<double>::infinity(), fallback = 0.0;
  for (std::size_t i = 0; i < scatter.place.size(); ++i) {
    const base::Vec<D> r = box.nearest(scatter.place[i] - point) / reach;
    const double r2 = r.squaredNorm();
    if (r2 < closest) closest = r2, fallback = scatter.value[i];
    if (r2 >= 1.0) continue;
    near.push_back(r);
    value.push_back(scatter.value[i]);
  }
  const auto rows = Eigen::Index(near.size());
  for (const Eigen::Index terms : {Eigen::Index(1 + D + D * (D + 1) / 2), Eigen::Index(1 + D), Eigen::Index(1)}) {
    if (rows < terms) continue;
    Eigen::MatrixXd matrix(rows, terms);
    Eigen::VectorXd right(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const auto i = std::size_t(k);
      const double root = std::pow(1.0 - near[i].norm(), 2);  // of the weight
      matrix.row(k) = root * monomials<D>(near[i]).head(terms).transpose();
      right[k] = root * value[i];
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-3);
    solver.compute(matrix);
    if (solver.rank() == terms) return solver.solve(right)[0];
  }
  return fallback;
}

template double sample_at(const Scatter<1>&, const base::Box<1>&, const base::Vec<1>&, double);
template double sample_at(const Scatter<2>&, const base::Box<2>&, const base::Vec<2>&, double);
template double sample_at(const Scatter<3>&, const base::Box<3>&, const base::Vec<3>&, double);

}  // namespace shmoo::coupling
