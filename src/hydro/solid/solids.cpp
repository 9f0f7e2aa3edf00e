#include "hydro/solid/solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/initial_velocity.hpp"
#include "hydro/lanes.hpp"
#include "hydro/solid/hooke_jaumann.hpp"
#include "hydro/solid/total_lagrangian.hpp"

namespace shmoo::hydro {
namespace {

template <int D>
scene::Point point_of(const base::Vec<D>& x) {
  scene::Point point{};
  for (int a = 0; a < D; ++a) point[std::size_t(a)] = x[a];
  return point;
}

template <int D>
Body<D> body_of(const scene::Material& material, std::size_t index, const sph::Filling<D>& filling) {
  const scene::Elastic& elastic = *material.elastic;
  Body<D> body;
  body.name = material.name;
  body.material = static_cast<std::uint16_t>(index);
  body.law = elastic.law;
  body.density = material.density;
  body.spacing = std::pow(filling.cell, 1.0 / D);
  body.volume = filling.cell;
  body.shear = elastic.shear_modulus;
  body.softening = elastic.softening;
  body.bulk = moduli(elastic.shear_modulus, elastic.poisson_ratio).bulk;
  for (int a = 0; a < D; ++a) body.body_force[a] = elastic.body_force[std::size_t(a)];
  return body;
}

}  // namespace

template <int D>
Solids<D>::Solids(const scene::Scene& scene, const sph::Filling<D>& filling)
    : box_(filling.box), motion_(scene), depth_(D == 2 ? scene.depth : 1.0) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    if (scene.materials[m].type == scene::MaterialType::solid) add_body(scene, m, filling);
  for (std::size_t b = 0; b < bodies_.size(); ++b) laws_[b]->find_forces(bodies_[b], 0.0);
}

template <int D>
void Solids<D>::add_body(const scene::Scene& scene, std::size_t material, const sph::Filling<D>& filling) {
  const scene::Elastic& elastic = *scene.materials[material].elastic;
  Body<D> body = body_of<D>(scene.materials[material], material, filling);
  const InitialVelocity<D> initial(elastic.initial_velocity, scene.parameters);
  for (std::size_t i = 0; i < filling.voxels; ++i) {
    if (filling.particles.material[i] != material) continue;
    const Vec& x = filling.particles.position[i];
    body.id.push_back(filling.particles.id[i]);
    body.start.push_back(x);
    body.held.push_back(elastic.fixed && scene::contains(*elastic.fixed, point_of<D>(x), D));
    body.velocity.push_back(body.held.back() ? motion_.surface_velocity(material, x, 0.0) : initial(x));
  }
  if (body.size() == 0) return;
  for (auto* column : {&body.displacement, &body.force, &body.traction}) column->assign(body.size(), Vec(Vec::Zero()));
  if (elastic.law == scene::ElasticLaw::hooke_jaumann)
    laws_.push_back(std::make_unique<HookeJaumann<D>>(body, box_, elastic, scene.numerics));
  else
    laws_.push_back(std::make_unique<TotalLagrangian<D>>(body, box_));
  bodies_.push_back(std::move(body));
}

template <int D>
double Solids<D>::step_limit() const {
  double limit = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < bodies_.size(); ++b) limit = std::min(limit, laws_[b]->step_limit(bodies_[b]));
  return limit;
}

template <int D>
void Solids<D>::advance(double t, double dt) {
  const double end = t + dt;
  while (t < end) {
    const double rest = end - t, parts = std::max(1.0, std::ceil(rest / step_limit() * (1.0 - 1e-9)));
    const double step = rest / parts;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      kick(bodies_[b], 0.5 * step);
      drift(bodies_[b], t, step);
      laws_[b]->find_forces(bodies_[b], step);
      kick(bodies_[b], 0.5 * step);
    }
    t = parts == 1.0 ? end : t + step;
  }
}

template <int D>
bool Solids<D>::soften() const {
  return std::any_of(bodies_.begin(), bodies_.end(), [](const Body<D>& body) { return body.softening.has_value(); });
}

template <int D>
void Solids<D>::soften(const std::function<double(int, std::uint32_t)>& concentration) {
  for (Body<D>& body : bodies_) {
    if (!body.softening) continue;
    body.softness.resize(body.size());
    for (std::size_t i = 0; i < body.size(); ++i)
      body.softness[i] = softened(1.0, *body.softening, concentration(body.softening->species, body.id[i]));
  }
}

template <int D>
void Solids<D>::push(double dt) {
  for (Body<D>& body : bodies_) {
    const double factor = dt / body.mass();
    for (std::size_t i = 0; i < body.size(); ++i)
      if (!body.held[i]) body.velocity[i] += factor * body.traction[i];
  }
}

template <int D>
void Solids<D>::kick(Body<D>& body, double dt) {
  const double factor = dt / body.mass();
  const Vec from_body_force = dt * body.body_force;
#pragma omp parallel for schedule(static) if (worth_threads(body.size() / 4))
  for (std::size_t i = 0; i < body.size(); ++i)
    if (!body.held[i]) body.velocity[i] += factor * body.force[i] + from_body_force;
}

template <int D>
void Solids<D>::drift(Body<D>& body, double t, double dt) {
#pragma omp parallel for schedule(static) if (worth_threads(body.size() / 4))
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (!body.held[i]) {
      body.displacement[i] += dt * body.velocity[i];
    } else if (motion_.moves(body.material)) {
      const Vec x = body.start[i] + body.displacement[i], next = motion_.carry(body.material, x, t, dt);
      body.displacement[i] += next - x;
      body.velocity[i] = motion_.surface_velocity(body.material, next, t + dt);
    }
  }
}

template <int D>
base::Vec<D> Solids<D>::position(const Body<D>& body, std::size_t particle) const {
  return box_.wrap(body.start[particle] + body.displacement[particle]);
}

template <int D>
double Solids<D>::density(const Body<D>& body, std::size_t particle) const {
  return law(body).density(body, particle);
}

template <int D>
double Solids<D>::pressure(const Body<D>& body, std::size_t particle) const {
  const Stress<D> stress = law(body).stress(body, particle);
  return -(stress.P.trace() + stress.hoop) / 3.0;
}

template <int D>
double Solids<D>::max_speed() const {
  double largest = 0.0;
  for (const Body<D>& body : bodies_)
    for (const Vec& v : body.velocity) largest = std::max(largest, v.squaredNorm());
  return std::sqrt(largest);
}

template <int D>
double Solids<D>::volume() const {
  double sum = 0.0;
  for (const Body<D>& body : bodies_)
    for (std::size_t i = 0; i < body.size(); ++i) sum += body.mass() / density(body, i);
  return sum;
}

template <int D>
double Solids<D>::kinetic_energy() const {
  double sum = 0.0;
  for (const Body<D>& body : bodies_)
    for (const Vec& v : body.velocity) sum += 0.5 * body.mass() * v.squaredNorm();
  return depth_ * sum;
}

template <int D>
double Solids<D>::elastic_energy() const {
  double sum = 0.0;
  for (const Body<D>& body : bodies_) sum += law(body).energy(body);
  return depth_ * sum;
}

template <int D>
base::Vec<D> Solids<D>::momentum() const {
  Vec sum = Vec::Zero();
  for (const Body<D>& body : bodies_)
    for (std::size_t i = 0; i < body.size(); ++i)
      if (!body.held[i]) sum += body.mass() * body.velocity[i];
  return depth_ * sum;
}

template <int D>
void Solids<D>::describe(std::vector<Derived>& list) const {
  for (const Body<D>& body : bodies_) {
    list.push_back({"wave speed of " + body.name, body.wave_speed(), "m/s", "sqrt((K + 4/3 G)/density), of pressure"});
    list.push_back({"step limit, elastic waves of " + body.name, law(body).step_limit(body), "s",
                    "a part of spacing/wave speed; shorter while the body is strongly deformed"});
  }
}

template class Solids<2>;
template class Solids<3>;

}  // namespace shmoo::hydro
