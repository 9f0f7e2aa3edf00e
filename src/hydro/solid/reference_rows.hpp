#pragma once
// The neighbourhood of a solid in its reference configuration, which never changes: pairs, and kernel gradients
// corrected so that every linear field has its exact gradient on any arrangement (Bonet & Lok 1999, Comput. Methods
// Appl. Mech. Eng. 180, 97; Ganzenmueller 2015, ibid. 286, 87).
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "base/vec.hpp"

namespace shmoo::hydro {

template <int D>
struct ReferenceRows {
  using Vec = base::Vec<D>;

  std::vector<std::uint64_t> first;      // [particles + 1]
  std::vector<std::uint32_t> neighbour;  // [pairs]
  std::vector<Vec> separation;           // [pairs] [m] X_j - X_i
  std::vector<Vec> gradient;             // [pairs] [1/m] g_ij: grad f(X_i) = sum_j (f_j - f_i) g_ij
  std::vector<double> weight;            // [pairs] V_j W_ij/sum_k V_k W_ik, which add up to 1
  std::vector<double> steepness;         // [pairs] [1/m^2] V_j F_ij, so that g_ij = B_i steepness separation
  std::vector<base::Mat<D>> correction;  // [particles] B_i

  std::size_t size() const { return first.empty() ? 0 : first.size() - 1; }

  // sum_j (f_j - f_i) (x) g_ij: F where f is the position, F - I where it is the displacement (as across a periodic
  // side).
  base::Mat<D> gradient_of(std::span<const Vec> f, std::size_t i) const {
    base::Mat<D> sum = base::Mat<D>::Zero();
    for (std::uint64_t p = first[i]; p < first[i + 1]; ++p) sum += (f[neighbour[p]] - f[i]) * gradient[p].transpose();
    return sum;
  }
};

// Pairs closer than `reach` [m] of the same body; the kernel is Wendland's C2. `volume` [m^D]; `body` may be empty: all
// are one. Throws base::InputError where a particle's neighbours do not span the space (a wall one particle thick).
template <int D>
ReferenceRows<D> make_reference_rows(std::span<const base::Vec<D>> X, std::span<const double> volume,
                                     std::span<const std::uint16_t> body, const base::Box<D>& box, double reach);

extern template ReferenceRows<2> make_reference_rows(std::span<const base::Vec<2>>, std::span<const double>,
                                                     std::span<const std::uint16_t>, const base::Box<2>&, double);
extern template ReferenceRows<3> make_reference_rows(std::span<const base::Vec<3>>, std::span<const double>,
                                                     std::span<const std::uint16_t>, const base::Box<3>&, double);

}  // namespace shmoo::hydro
