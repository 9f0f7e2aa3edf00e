#include "hydro/shell/rezone.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "hydro/shell/growth.hpp"

namespace shmoo::hydro {
namespace {

constexpr int samples = 8;  // of the wall's length, in every column

// Values of one layer at column centres k + 1/2, even or odd under reflection at both ends; cubic through the four
// nearest.
class Along {
 public:
  Along(std::vector<double> values, double parity) : values_(std::move(values)), parity_(parity) {}

  double operator()(double u) const {
    const double place = u - 0.5;
    const int k = int(std::floor(place));
    const double t = place - k;
    return value(k - 1) * (-t * (t - 1.0) * (t - 2.0) / 6.0) + value(k) * ((t + 1.0) * (t - 1.0) * (t - 2.0) / 2.0) +
           value(k + 1) * (-(t + 1.0) * t * (t - 2.0) / 2.0) + value(k + 2) * ((t + 1.0) * t * (t - 1.0) / 6.0);
  }
  double value(int k) const {
    const int n = int(values_.size());
    if (k < 0) return parity_ * values_[std::size_t(-1 - k)];
    if (k >= n) return parity_ * values_[std::size_t(2 * n - 1 - k)];
    return values_[std::size_t(k)];
  }

 private:
  std::vector<double> values_;
  double parity_;
};

template <class Of>
Along along(const Shell& shell, int layer, double parity, Of of) {
  std::vector<double> values;
  for (int k = 0; k < shell.columns; ++k) values.push_back(of(shell.at(k, layer)));
  return {std::move(values), parity};
}

struct Curve {
  Along x, y;
  Vec2 operator()(double u) const { return {x(u), y(u)}; }
};

Curve curve(const std::vector<Vec2>& points) {
  std::vector<double> x, y;
  for (const auto& point : points) {
    x.push_back(point[0]);
    y.push_back(point[1]);
  }
  return {Along(std::move(x), 1.0), Along(std::move(y), -1.0)};
}

Curve curve(const Shell& shell, int layer) {
  return {along(shell, layer, 1.0, [&](std::size_t i) { return shell.x[i][0]; }),
          along(shell, layer, -1.0, [&](std::size_t i) { return shell.x[i][1]; })};
}

// Column coordinates u in [0, columns] of the new faces and centres, which are evenly spaced along the middle of the
// wall.
struct Marks {
  std::vector<double> face, centre;
};

Marks even_marks(const Shell& shell) {
  const Curve inner = curve(shell, (shell.layers - 1) / 2), outer = curve(shell, shell.layers / 2);
  const auto middle = [&](double u) { return Vec2(0.5 * (inner(u) + outer(u))); };
  std::vector<double> length{0.0};
  for (int s = 1; s <= samples * shell.columns; ++s)
    length.push_back(length.back() + (middle(double(s) / samples) - middle(double(s - 1) / samples)).norm());
  const auto place = [&](double part) {
    const double wanted = part * length.back();
    const auto above = std::min<std::size_t>(
        std::size_t(std::upper_bound(length.begin(), length.end(), wanted) - length.begin()), length.size() - 1);
    const double t = (wanted - length[above - 1]) / (length[above] - length[above - 1]);
    return (double(above - 1) + t) / samples;
  };
  Marks marks;
  for (int k = 0; k <= shell.columns; ++k) marks.face.push_back(place(double(k) / shell.columns));
  for (int k = 0; k < shell.columns; ++k) marks.centre.push_back(place((k + 0.5) / shell.columns));
  marks.face.back() = shell.columns;
  return marks;
}

double minmod(double a, double b) { return a * b <= 0.0 ? 0.0 : std::abs(a) < std::abs(b) ? a : b; }

// The part of an amount that lies between two places of its column, from 0 to 1, where its density has this slope.
double part_between(double from, double to, double slope) {
  return (to - from) * (1.0 + 0.5 * slope * (from + to - 1.0));
}

std::vector<Take> takes(const Shell& shell, int layer, const Marks& marks) {
  const Along amount = along(shell, layer, 1.0, [&](std::size_t i) { return shell.V0[i]; });
  std::vector<Take> all;
  for (int old = 0; old < shell.columns; ++old) {
    const double own = amount.value(old);
    const double slope = minmod(amount.value(old + 1) - own, own - amount.value(old - 1)) / own;
    for (int k = 0; k < shell.columns; ++k) {
      const double from = std::max(marks.face[std::size_t(k)], double(old)) - old,
                   to = std::min(marks.face[std::size_t(k + 1)], old + 1.0) - old;
      if (to > from) all.push_back({shell.at(old, layer), shell.at(k, layer), part_between(from, to, slope)});
    }
  }
  return all;
}

// What the elastic state is without turns: the left stretch V, Fe Fe^T = V V, in the directions along and across the
// wall.
struct Stretch {
  double along = 1, across = 1, shear = 0, hoop = 1;
};

Mat2 frame(const Vec2& t) { return (Mat2() << t[0], -t[1], t[1], t[0]).finished(); }

Stretch stretch_of(const Shell& shell, const ShellEnergy& energy, std::size_t i) {
  const auto at = energy.elastic(shell, i);
  const Eigen::JacobiSVD<Mat2> svd(at.F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat2 V = svd.matrixU() * svd.singularValues().asDiagonal() * svd.matrixU().transpose(),
             Q = frame(tangent_at(shell, i)), local = Q.transpose() * V * Q;
  return {local(0, 0), local(1, 1), local(0, 1), at.hoop};
}

struct LayerState {
  Curve place;
  Along along, across, shear, hoop, growth, modulus;
};

LayerState layer_state(const Shell& shell, const std::vector<Stretch>& stretch, int l) {
  const auto of = [&](double parity, double Stretch::*part) {
    return along(shell, l, parity, [&](std::size_t i) { return stretch[i].*part; });
  };
  return {curve(shell, l),
          of(1.0, &Stretch::along),
          of(1.0, &Stretch::across),
          of(-1.0, &Stretch::shear),
          of(1.0, &Stretch::hoop),
          along(shell, l, 1.0, [&](std::size_t i) { return shell.growth[i]; }),
          along(shell, l, 1.0, [&](std::size_t i) { return shell.shear[i]; })};
}

std::vector<Stretch> stretches(const Shell& shell, const ShellEnergy& energy) {
  std::vector<Stretch> all;
  for (std::size_t i = 0; i < shell.size(); ++i) all.push_back(stretch_of(shell, energy, i));
  return all;
}

// Of a layer's moduli: cubics must not pass them, least of all below zero.
std::pair<double, double> extremes(const Shell& shell, int layer) {
  double least = shell.shear[shell.at(0, layer)], most = least;
  for (int k = 1; k < shell.columns; ++k) {
    least = std::min(least, shell.shear[shell.at(k, layer)]);
    most = std::max(most, shell.shear[shell.at(k, layer)]);
  }
  return {least, most};
}

// Sets what is interpolated; stretches still in the frame of the wall.
void lay_out(Shell& next, int layer, const LayerState& state, const Marks& marks) {
  const auto [softest, stiffest] = extremes(next, layer);
  for (int k = 0; k < next.columns; ++k) {
    const double u = marks.centre[std::size_t(k)];
    const std::size_t i = next.at(k, layer);
    next.x[i] = state.place(u);
    next.B[i] << state.along(u), state.shear(u), state.shear(u), state.across(u);
    next.b[i] = state.hoop(u);
    next.growth[i] = std::max(0.0, state.growth(u));
    next.shear[i] = std::clamp(state.modulus(u), softest, stiffest);
  }
}

}  // namespace

double largest_stretch(const Shell& shell, const ShellEnergy& energy) {
  double largest = 1.0;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto s = Eigen::JacobiSVD<Mat2>(deformation_gradient(energy.rows()[i], shell.x)).singularValues();
    largest = std::max({largest, s[0], 1.0 / s[1]});
  }
  return largest;
}

std::vector<Take> rezone(Shell& shell, const ShellEnergy& energy) {
  const Marks marks = even_marks(shell);
  const auto stretch = stretches(shell, energy);
  const Curve inside = curve(energy.cavity(shell)), outside = curve(energy.outer_surface(shell));
  Shell next = shell;
  next.V0.assign(shell.size(), 0.0);
  std::vector<Take> all;
  for (int l = 0; l < shell.layers; ++l) {
    lay_out(next, l, layer_state(shell, stretch, l), marks);
    for (const auto& take : takes(shell, l, marks)) {
      next.V0[take.to] += take.share * shell.V0[take.from];
      all.push_back(take);
    }
  }
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const Mat2 Q = frame(tangent_at(next, i));
    next.B[i] = Q * next.B[i] * Q.transpose();
  }
  for (int k = 0; k < shell.columns; ++k) {
    const double u = marks.centre[std::size_t(k)];
    next.inside[std::size_t(k)] = inside(u) - next.x[shell.at(k, 0)];
    next.outside[std::size_t(k)] = outside(u) - next.x[shell.at(k, shell.layers - 1)];
  }
  next.X = next.x;
  shell = std::move(next);
  return all;
}

}  // namespace shmoo::hydro
