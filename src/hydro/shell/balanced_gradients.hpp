#pragma once
// Gradients g_ij that are exact for linear displacements leave forces where the stress is the same everywhere, since
//   sum_j V_j g_ji + V_i e_y/Y_i = d(volume between the wall's surfaces)/dx_i
// does not hold: by a few per cent everywhere, and by half on the columns next to the axis, where V has a kink. Here
// the g_ij are changed by as little as makes it hold, within what linear displacements do not see:
//   g_ij += V_i (N_i mu)_j,   sum_i V_i^2 N_i mu = what is missing,
// N_i the form of what a row's gradient does not see. Trial and test share the operator, so the tangent stays
// symmetric. After Chen, Hillman & Rueter 2013 (Int. J. Numer. Meth. Eng. 95, 387), who change test functions only;
// least changes of all coefficients as in Kwan-yu Chiu, Wang, Hu & Jameson 2012 (SIAM J. Sci. Comput. 34, A2896).
#include <Eigen/Core>

#include "hydro/shell/stencil.hpp"

namespace shmoo::hydro {

// Of the row of particle i: sum_j w_ij |x_ij - F_i X_ij|^2/|X_ij|^2 as a form in the row's places [1/m^2].
Eigen::MatrixXd unseen(const Shell& shell, const Row& row, std::size_t i);

// `forms` are the rows' unseen.
void balance_gradients(const Shell& shell, const std::vector<Eigen::MatrixXd>& forms, std::vector<Row>& rows);

}  // namespace shmoo::hydro
