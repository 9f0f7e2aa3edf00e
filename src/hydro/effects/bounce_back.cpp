#include "hydro/effects/bounce_back.hpp"

namespace shmoo::hydro {
namespace {

using base::Vec;

// What a fluid particle sees of the walls about it.
template <int D>
struct WallView {
  double inside = 0, all = 0;            // sums of V_j^2 W_ij over solids, over everything
  double steepness = 0;                  // sum of V_j^2 F_ij r_ij over solids: |grad| if all lay on one side
  Vec<D> outward = Vec<D>::Zero();       // -grad of `inside`
  Vec<D> velocity = Vec<D>::Zero();      // sum of V_j^2 W_ij v_j over solids
  Vec<D> from_nearest = Vec<D>::Zero();  // [m] from the nearest solid particle to this one
  double nearest2 = std::numeric_limits<double>::infinity();
};

// Where no solid stands nearer than this [spacings] a particle can neither touch a wall nor be inside one.
constexpr double clear = 1.5;

// The same of the eight particles of a block. Its list of near slots is that of the density sweep of this step.
template <int D>
class BlockView {
 public:
  BlockView(const State<D>& state, std::size_t b)
      : state_(state), blocks_(state.rows.blocks), block_(blocks_[b]), near_(blocks_.near(block_)) {
    for (int a = 0; a < D; ++a) own_[a] = load(blocks_.coordinate[std::size_t(a)].data() + lanes * b);
    while (solids_ > 0 && std::size_t(near_[solids_ - 1]) >= blocks_.block_slots()) --solids_;
    for (std::uint32_t k = solids_; k < block_.near; ++k)
      if (is_solid(k)) note_nearest(std::size_t(near_[k]));
  }

  // Whether particle l of the block stands near a solid.
  bool any() const { return any_below(nearest2_, limit()); }
  bool is_near(std::uint32_t l) const { return nearest2_[l] < limit(); }

  template <class Kernel>
  void look(const Kernel& kernel) {
    for (std::uint32_t k = 0; k < solids_; ++k) add_fluid(kernel, std::size_t(near_[k]));
    for (std::uint32_t k = solids_; k < block_.near; ++k)
      is_solid(k) ? add_solid(kernel, std::size_t(near_[k])) : add_fluid(kernel, std::size_t(near_[k]));
  }

  WallView<D> operator[](std::uint32_t l) const {
    WallView<D> view{inside_[l], all_[l], steepness_[l]};
    for (int a = 0; a < D; ++a) {
      view.outward[a] = outward_[a][l];
      view.velocity[a] = velocity_[a][l];
      view.from_nearest[a] = from_nearest_[a][l];
    }
    view.nearest2 = nearest2_[l];
    return view;
  }

 private:
  double limit() const { return clear * clear * state_.scales.spacing * state_.scales.spacing; }
  bool is_solid(std::uint32_t k) const {
    const std::uint32_t j = blocks_.particle(std::size_t(near_[k]));
    return state_.particles.role[j] == sph::Role::solid;
  }
  Lane separate(std::size_t slot, Lane (&x)[D]) const {
    Lane r2 = same(tiny);
    for (int a = 0; a < D; ++a) {
      x[a] = own_[a] - blocks_.coordinate[std::size_t(a)][slot];
      r2 = fma(x[a], x[a], r2);
    }
    return r2;
  }
  void note_nearest(std::size_t slot) {
    Lane x[D];
    const Lane r2 = separate(slot, x);
    for (int a = 0; a < D; ++a) from_nearest_[a] = r2 < nearest2_ ? x[a] : from_nearest_[a];
    nearest2_ = r2 < nearest2_ ? r2 : nearest2_;
  }
  template <class Kernel>
  void add_fluid(const Kernel& kernel, std::size_t slot) {
    Lane x[D];
    const Lane r2 = separate(slot, x);
    const double V = state_.volume[blocks_.particle(slot)];
    all_ += V * V * kernel.W(Lane(r2 * inverse_root(r2)));
  }
  template <class Kernel>
  void add_solid(const Kernel& kernel, std::size_t slot) {
    Lane x[D];
    const Lane r2 = separate(slot, x), r = r2 * inverse_root(r2);
    const std::uint32_t j = blocks_.particle(slot);
    const double V2 = state_.volume[j] * state_.volume[j];
    const Lane W = V2 * kernel.W(r), F = V2 * kernel.F(r);
    all_ += W;
    inside_ += W;
    steepness_ = fma(F, r, steepness_);
    for (int a = 0; a < D; ++a) {
      velocity_[a] += (*state_.wall_velocity)[j][a] * W;
      outward_[a] = fma(F, x[a], outward_[a]);
    }
  }

  const State<D>& state_;
  const Blocks<D>& blocks_;
  const Block& block_;
  const std::int32_t* near_;
  std::uint32_t solids_ = block_.near;  // of the list, from here on solids and images
  Lane own_[D], from_nearest_[D]{}, nearest2_ = same(std::numeric_limits<double>::infinity());
  Lane inside_{}, all_{}, steepness_{}, outward_[D]{}, velocity_[D]{};
};

// True where the velocity was thrown back.
template <int D>
bool throw_back(const WallView<D>& view, double spacing, Vec<D>& v) {
  if (!(view.inside > 0.0)) return false;
  const Vec<D> wall = view.velocity / view.inside, relative = v - wall;
  const double size = view.outward.norm();
  const bool has_normal = size > 1e-6 * view.steepness;
  const Vec<D> n = has_normal ? Vec<D>(view.outward / size) : Vec<D>::Zero();
  const bool crossed = view.inside >= 0.5 * view.all;
  const bool touches = has_normal && view.from_nearest.dot(n) < 0.5 * spacing && relative.dot(n) < 0.0 &&
                       view.nearest2 < spacing * spacing;
  if (!crossed && !touches) return false;
  v = wall - relative + 2.0 * std::max(0.0, relative.dot(n)) * n;
  return true;
}

// The transport velocity must not carry a particle that all but touches a wall into it.
template <int D>
void hold_back(const WallView<D>& view, double spacing, Vec<D>& shift) {
  const double size = view.outward.norm();
  if (!(size > 1e-6 * view.steepness)) return;
  const Vec<D> n = view.outward / size;
  const bool near = view.from_nearest.dot(n) < 0.75 * spacing && view.nearest2 < spacing * spacing;
  if (near || view.inside >= 0.5 * view.all) shift -= std::min(0.0, shift.dot(n)) * n;
}

}  // namespace

template <int D>
std::uint64_t BounceBack<D>::apply(State<D>& state, const sph::AnyKernel<D>& kernel) const {
  const auto& blocks = state.rows.blocks;
  std::uint64_t count = 0;
  std::visit(
      [&](const auto& k) {
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : count) if (worth_threads(blocks.fluid()))
        for (std::size_t b = 0; b < blocks.size(); ++b) {
          if (!blocks[b].at_wall) continue;
          BlockView<D> block(state, b);
          if (!block.any()) continue;
          block.look(k);
          for (std::uint32_t l = 0; l < blocks[b].size; ++l) {
            if (!block.is_near(l)) continue;
            const std::size_t i = blocks[b].first + l;
            const auto view = block[l];
            count += throw_back<D>(view, state.scales.spacing, state.velocity[i]);
            if (state.shift) hold_back<D>(view, state.scales.spacing, (*state.shift)[i]);
          }
        }
      },
      kernel);
  return count;
}

template struct BounceBack<2>;
template struct BounceBack<3>;

}  // namespace shmoo::hydro
