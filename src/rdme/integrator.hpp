#pragma once
// What CVODE needs for one system: vectors, a linear solver, and the integrator itself.
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <string>

#include "rdme/sparse_jacobian.hpp"

namespace shmoo::rdme {

struct Integrator {
  SUNContext context = nullptr;
  N_Vector y = nullptr, allowed = nullptr;  // unknowns, absolute tolerances
  SUNMatrix matrix = nullptr;               // null: GMRES
  SUNLinearSolver linear = nullptr;
  void* memory = nullptr;
  std::string message;  // of the last error

  // Solves with factors of a matrix of this structure, or without one by GMRES.
  Integrator(std::size_t unknowns, const SparseJacobian* structure) {
    constexpr int krylov_dimension = 20, minimum_degree = 0;
    const auto size = static_cast<sunindextype>(unknowns);
    SUNContext_Create(nullptr, &context);
    y = N_VNew_Serial(size, context);
    allowed = N_VNew_Serial(size, context);
    if (structure) {
      matrix = SUNSparseMatrix(size, size, static_cast<sunindextype>(structure->row().size()), CSC_MAT, context);
      linear = SUNLinSol_KLU(y, matrix, context);
      SUNLinSol_KLUSetOrdering(linear, minimum_degree);
    } else {
      linear = SUNLinSol_SPGMR(y, SUN_PREC_NONE, krylov_dimension, context);
    }
    memory = CVodeCreate(CV_BDF, context);
  }
  ~Integrator() {
    CVodeFree(&memory);
    SUNLinSolFree(linear);
    if (matrix) SUNMatDestroy(matrix);
    N_VDestroy(allowed);
    N_VDestroy(y);
    SUNContext_Free(&context);
  }
  Integrator(const Integrator&) = delete;
  Integrator& operator=(const Integrator&) = delete;
};

inline void copy_structure(const SparseJacobian& structure, SUNMatrix matrix) {
  std::ranges::copy(structure.first(), SUNSparseMatrix_IndexPointers(matrix));
  std::ranges::copy(structure.row(), SUNSparseMatrix_IndexValues(matrix));
}

}  // namespace shmoo::rdme
