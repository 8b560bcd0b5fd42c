// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// All bonds of a simulation, and the forces and moments of bonds on each body.

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <riprap/bond/bond.hpp>
#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/bond/divided_bond.hpp>
#include <riprap/contact/pair/excluded_pairs.hpp>
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/particle/placed_bond.hpp>

namespace riprap {

/// Live bonds in the order of (a, b, image). Those that fail are taken out.
template <BondLaw Law, class Domain>
class BondList {
 public:
  using Image = typename Domain::Image;
  using BondType = Bond<typename Law::State, Image>;

  explicit BondList(Law law) : law_(std::move(law)) {}

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] std::size_t size() const { return bonds_.size(); }
  [[nodiscard]] bool empty() const { return bonds_.empty(); }
  [[nodiscard]] const BondType& operator[](std::size_t k) const { return bonds_[k]; }
  [[nodiscard]] auto begin() const { return bonds_.begin(); }
  [[nodiscard]] auto end() const { return bonds_.end(); }
  /// The bonds of each body: pairs of the index are bonds.
  [[nodiscard]] const PairIndex& index() const { return index_; }
  /// Sum of the bond forces on each body, in the order of the bonds, and its moment.
  [[nodiscard]] std::span<const Wrench> wrenches() const { return wrenches_; }

  /// Adds bonds, without force at the present poses. Throws InvalidInput where a normal does not
  /// lead from one particle to the other.
  void add(std::span<const PlacedBond> placed, const Particles& particles, const Domain& domain) {
    for (const PlacedBond& one : placed) bonds_.push_back(made(one, particles, domain));
    std::stable_sort(bonds_.begin(), bonds_.end(), precedes);
    changed(particles.size());
  }

  /// Tractions at the present poses. Bonds that fail are moved to `failed`, in order; the others
  /// are summed over each body.
  /// @param may_fail false: all bonds hold, and their states stay as they are
  template <Execution E = Serial>
  void update(const Particles& particles, const Domain& domain, std::vector<BondType>& failed,
              const E& execution = {}, bool may_fail = true) {
    losses_.resize(std::max(losses_.size(), task_count(bonds_.size())));
    for_each_task(
        execution, bonds_.size(), [&](std::size_t task, std::size_t first, std::size_t last) {
          for (std::size_t k = first; k < last; ++k) {
            if (!may_fail)
              hold(bonds_[k], particles, domain);
            else if (const double loss = evaluate(bonds_[k], particles, domain); loss != 0)
              losses_[task].add(loss);
          }
        });
    take_out(particles.size(), failed,
             [](const BondType& bond) { return bond.failure != BondFailure::none; });
    for_each_task(execution, particles.size(),
                  [&](std::size_t, std::size_t first, std::size_t last) {
                    for (std::size_t i = first; i < last; ++i) sum(static_cast<BodyIndex>(i));
                  });
  }

  /// Moves the bonds of which `leaves(bond)` is true to `taken`.
  template <class Leaves>
  void take_out(std::size_t bodies, std::vector<BondType>& taken, Leaves&& leaves) {
    if (std::none_of(bonds_.begin(), bonds_.end(), leaves)) return;
    std::size_t left = 0;
    for (BondType& bond : bonds_) {
      if (leaves(std::as_const(bond)))
        taken.push_back(bond);
      else
        bonds_[left++] = bond;
    }
    bonds_.resize(left);
    changed(bodies);
  }

  /// Hands the bonds of a particle that has broken to its pieces; those of dust are moved to
  /// `lost`, as they were.
  /// @return whether it had any
  bool divide(const DividedBody& broken, const Particles& particles, const Domain& domain,
              std::vector<BondType>& lost) {
    divided_.clear();
    take_out(particles.size(), divided_, [&](const BondType& bond) {
      return bond.a == broken.parent || bond.b == broken.parent;
    });
    for (const BondType& bond : divided_)
      for (const auto& part : divided(bond, broken, particles)) {
        if (!part) continue;
        if (!part->piece) {
          lost.push_back(part->bond);
          continue;
        }
        bonds_.push_back(part->bond);
        add_loss(evaluate(bonds_.back(), particles, domain));
      }
    if (!divided_.empty()) std::stable_sort(bonds_.begin(), bonds_.end(), precedes);
    changed(particles.size());
    return !divided_.empty();
  }

  /// Body i, whose bonds have been taken out, was removed: those behind it have moved up.
  void remove(BodyIndex i, std::size_t bodies) {
    for (BondType& bond : bonds_) {
      if (bond.a > i) --bond.a;
      if (bond.b > i) --bond.b;
    }
    changed(bodies);
  }

  /// Bodies without bonds have come behind the others.
  void resize(std::size_t bodies) { changed(bodies); }

  /// Which pairs are bonded.
  [[nodiscard]] ExcludedPairs<Image> pairs() const {
    ExcludedPairs<Image> out;
    for (const BondType& bond : bonds_) out.add(bond.a, bond.b, bond.image);
    return out;
  }

  /// What all bonds can give back [J].
  [[nodiscard]] double stored_energy(double thickness) const {
    ExactSum energy;
    for (const BondType& bond : bonds_) energy.add(riprap::stored_energy(bond, law_, thickness));
    return energy.value();
  }
  /// Energy lost by damage of live bonds, and what `add_loss` has added [J].
  [[nodiscard]] double loss() const {
    ExactSum loss = other_loss_;
    for (const ExactSum& part : losses_) loss += part;
    return loss.value();
  }
  void add_loss(double energy) { other_loss_.add(energy); }

  /// Adds the work that the deformation of a periodic cell does in a time [s] through the bonds
  /// whose body a is one of `first` to `last`.
  void add_image_work(BodyIndex first, BodyIndex last, const Domain& domain, double time,
                      ExactSum& work) const {
    if constexpr (Domain::periodic)
      for (BodyIndex i = first; i < last; ++i)
        for (const PairSide side : index_.of(i)) {
          const BondType& bond = bonds_[side.pair()];
          if (!side.is_b() && bond.image != Image{})
            work.add(-time * bond.force_on_b().dot(domain.velocity(bond.image)));
        }
  }
  /// Power of the forces of all bonds on both bodies of each [W].
  [[nodiscard]] double power(const Particles& particles, const Domain& domain) const {
    ExactSum sum;
    for (const BondType& bond : bonds_)
      for (std::size_t g = 0; g < 2; ++g) {
        Vec2 velocity = particles.body(bond.b).velocity_at(bond.arms_b[g]) -
                        particles.body(bond.a).velocity_at(bond.arms_a[g]);
        if constexpr (Domain::periodic) velocity += domain.velocity(bond.image);
        sum.add(bond.forces[g].dot(velocity));
      }
    return sum.value();
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("law", self.law_);
    visit("bonds", self.bonds_);
    visit("losses", self.losses_);
    visit("other_loss", self.other_loss_);
  }
  /// After the fields have been written: tractions and forces at the poses of the particles. States
  /// stay as they are: bonds may have been held.
  void restore(const Particles& particles, const Domain& domain) {
    for (BondType& bond : bonds_) hold(bond, particles, domain);
    changed(particles.size());
  }

 private:
  [[nodiscard]] static bool precedes(const BondType& p, const BondType& q) {
    return std::tie(p.a, p.b, p.image) < std::tie(q.a, q.b, q.image);
  }

  [[nodiscard]] BondType made(const PlacedBond& placed, const Particles& particles,
                              const Domain& domain) const {
    BondType bond;
    bond.a = static_cast<BodyIndex>(placed.a);
    bond.b = static_cast<BodyIndex>(placed.b);
    std::array<Vec2, 2> ends = placed.ends;
    if constexpr (Domain::periodic) bond.image = placed.image;
    if (bond.a > bond.b) {
      for (Vec2& end : ends) end -= bond_offset(bond, domain);
      std::swap(bond.a, bond.b);
      if constexpr (Domain::periodic) bond.image = -bond.image;
    }
    const Body& a = particles.body(bond.a);
    const Body& b = particles.body(bond.b);
    const Vec2 offset = bond_offset(bond, domain);
    bond.material_a = particles.material(bond.a);
    bond.material_b = particles.material(bond.b);
    const Vec2 edge = ends[1] - ends[0];
    bond.length = edge.norm();
    Vec2 normal = -perpendicular(edge) / bond.length;
    const double towards = normal.dot(b.position + offset - a.position);
    require(towards != 0,
            "bond of " + particle_text(particles.ancestry(bond.a).id) + " and " +
                particle_text(particles.ancestry(bond.b).id) +
                ": distance of the centroids across the edge [m]",
            towards, "must not be zero");
    if (towards < 0) {
      normal = -normal;
      std::swap(ends[0], ends[1]);
    }
    const auto on = [&](const Body& body, const Vec2& at) {
      BondedEdge out;
      for (std::size_t k = 0; k < 2; ++k)
        out.ends[k] = body.rotation.inverse_times(ends[k] - at - body.position);
      out.normal = body.rotation.inverse_times(normal);
      return out;
    };
    bond.on_a = on(a, Vec2{0, 0});
    bond.on_b = on(b, offset);
    find_displacements(bond, a, b, offset);
    return bond;
  }

  // Returns the energy lost [J].
  double evaluate(BondType& bond, const Particles& particles, const Domain& domain) const {
    find_displacements(bond, particles.body(bond.a), particles.body(bond.b),
                       bond_offset(bond, domain));
    return find_tractions(bond, law_, particles.thickness());
  }
  // Tractions; the bond does not fail, and its states stay as they are.
  void hold(BondType& bond, const Particles& particles, const Domain& domain) const {
    const auto states = bond.view.states;
    (void)evaluate(bond, particles, domain);
    bond.view.states = states;
    bond.failure = BondFailure::none;
  }
  void changed(std::size_t bodies) {
    index_.build(bonds_, bodies);
    wrenches_.resize(bodies);
    for (std::size_t i = 0; i < bodies; ++i) sum(static_cast<BodyIndex>(i));
  }
  void sum(BodyIndex i) {
    Wrench total;
    for (const PairSide side : index_.of(i)) {
      const BondType& bond = bonds_[side.pair()];
      for (std::size_t g = 0; g < 2; ++g)
        if (side.is_b())
          total.add(bond.forces[g], cross(bond.arms_b[g], bond.forces[g]));
        else
          total.subtract(bond.forces[g], cross(bond.arms_a[g], bond.forces[g]));
    }
    wrenches_[i] = total;
  }

  Law law_;
  std::vector<BondType> bonds_;
  std::vector<BondType> divided_;  // workspace of `divide`
  PairIndex index_;
  std::vector<Wrench> wrenches_;  // on each body
  std::vector<ExactSum> losses_;  // of the tasks, by damage
  ExactSum other_loss_;
};

}  // namespace riprap
