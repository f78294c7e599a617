#include "realtime/world.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/error.hpp"
#include "cases/hand/patch.hpp"
#include "realtime/surface.hpp"

namespace handhold::realtime {
namespace {

Eigen::Vector3d tangential(const Eigen::Vector3d& v, const Eigen::Vector3d& n) { return v - v.dot(n) * n; }

EventKind kind_of(Mode from, Mode to) {
  if (from == Mode::apart) return EventKind::touch;
  if (to == Mode::apart) return EventKind::release;
  return to == Mode::slip ? EventKind::breakaway : EventKind::restick;
}

}  // namespace

void validate(const Options& options) {
  if (options.substeps < 1 || options.substeps > 1000)
    throw InputError("substeps " + std::to_string(options.substeps) + ": must be 1 to 1000");
}

World::World(const Scene& scene, const Options& options)
    : scene_(scene), options_(options), contacts_(make_contacts(scene)) {
  validate(options);
  if (scene.bodies.size() != 1)
    throw InputError("scene '" + scene.name + "' has " + std::to_string(scene.bodies.size()) +
                     " bodies: the real-time path simulates exactly one (leave the others out)");
  body_ = make_rigid_body(scene.bodies.front());
  const std::size_t slots = contacts_.size();
  paths_.resize(scene.hands.size());
  now_.resize(scene.hands.size());
  next_.resize(scene.hands.size());
  for (const PatchSlot& patch : contacts_.patches)
    proximity_.emplace_back(scene.hands[patch.hand].motion->model().shape(patch.phalanx));
  samples_.resize(slots);
  slots_.reserve(slots);
  patch_of_slot_.resize(slots);
  for (std::size_t p = 0; p < contacts_.patches.size(); ++p)
    for (int i = 0; i < contacts_.patches[p].count; ++i) patch_of_slot_[contacts_.patches[p].slot(i)] = int(p);
  events_.reserve(slots * std::size_t(options.substeps));
  start_height_ = -scene.gravity.dot(body_.center());
}

const VoxelField& World::field() const { return *scene_.bodies.front().field; }

/// Puts a sample's anchor at the foot of `from_O`; false, and the sample is far, if there is none.
bool World::place_anchor(std::size_t slot, const Eigen::Vector3d& p_O, const Eigen::Vector3d& from_O) {
  Anchor anchor;
  contacts_.near[slot] = foot(field(), from_O, anchor);
  if (!contacts_.near[slot]) return false;
  contacts_.C_O.set(slot, anchor.C_O);
  contacts_.n_O.set(slot, anchor.n_O);
  contacts_.depth[slot] = -(p_O - anchor.C_O).dot(anchor.n_O);
  contacts_.lag_O.set(slot, tangential(p_O - anchor.C_O, anchor.n_O));
  return true;
}

void World::observe(double dt, const std::vector<HandFrame>& hands) {
  for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(dt, hands[i]);
}

void World::start(double dt, const std::vector<HandFrame>& hands) {
  observe(dt, hands);
  place_hands(1);
  now_ = next_;
  for (const PatchSlot& patch : contacts_.patches) {
    if (!patch.given) continue;
    const HandFrame& hand = now_[patch.hand];
    if (!hand.present) continue;
    const Hand& source = scene_.hands[patch.hand];
    const auto given = std::find_if(source.given.begin(), source.given.end(),
                                    [&](const GivenPatch& g) { return g.phalanx == patch.phalanx; });
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      const SampleStart begin = given->start.empty() ? SampleStart{} : given->start[i];
      const Eigen::Vector3d p_O = body_.X_WO.inverse() * (hand.X_WP[patch.phalanx] * contacts_.p_P[slot]);
      const bool near = place_anchor(slot, p_O, p_O - body_.X_WO.R.conjugate() * begin.lag_W);
      if (near && contacts_.depth[slot] > 0)
        contacts_.mode[slot] = begin.slipping ? Mode::slip : Mode::stick;
      else
        place_anchor(slot, p_O, p_O);  // outside: nothing to lag behind
    }
  }
  detect(0);
}

void World::advance(double dt, const std::vector<HandFrame>& hands) {
  events_.clear();
  observe(dt, hands);
  const double h = dt / options_.substeps;
  const double begin = t_;
  for (int i = 1; i <= options_.substeps; ++i) {
    std::swap(now_, next_);
    place_hands(double(i) / options_.substeps);
    substep(h);
    t_ = begin + dt * i / options_.substeps;
  }
}

void World::place_hands(double fraction) {
  for (std::size_t hand = 0; hand < paths_.size(); ++hand) {
    next_[hand].present = paths_[hand].present();
    if (!next_[hand].present) continue;
    for (int i = 0; i < phalanx_count; ++i) next_[hand].X_WP[i] = paths_[hand].pose(i, fraction);
    if (!now_[hand].present) now_[hand] = next_[hand];
  }
}

void World::substep(double h) {
  const bool held = body_.held(t_ + h);
  const Eigen::Vector3d gravity = held ? Eigen::Vector3d::Zero() : scene_.gravity;
  const double drag = held ? 1 / support_time : 0;
  gather(h, gravity);
  const SolverReport report =
      solve_velocity(body_, external_force(body_, gravity), drag, h, scene_.bodies.front().friction, samples_,
                     slots_.size(), options_.solver, velocity_);
  if (!report.converged) ++unconverged_;
  if (body_.moves()) move(body_, velocity_, h);
  if (!body_.X_WO.p.allFinite()) return;  // diverged: the pose says so, and no query of the surface has an answer
  scatter(h);
  if (held && body_.moves()) {  // the oil takes, the carrier of the weight gives
    dissipated_ += h * drag * velocity_.dot(mass_matrix(body_) * velocity_);
    hand_work_ -= h * body_.mass * scene_.gravity.dot(body_.v);
  }
  detect(h);
}

/// Packs every sample in contact, and those that would be inside at the end of the step if nothing held the body back:
/// k d + c d' > 0 alone would let a damper push before the surface is reached.
void World::gather(double h, const Eigen::Vector3d& gravity) {
  slots_.clear();
  const Eigen::Vector3d center = body_.center();
  const Eigen::Vector3d v_free = body_.moves() ? Eigen::Vector3d(body_.v + h * gravity) : Eigen::Vector3d::Zero();
  const Eigen::Vector3d w_free = body_.moves() ? body_.w : Eigen::Vector3d::Zero();
  for (const PatchSlot& patch : contacts_.patches) {
    if (!patch.active || !next_[patch.hand].present) continue;
    const Pose& X_WP0 = now_[patch.hand].X_WP[patch.phalanx];
    const Pose& X_WP1 = next_[patch.hand].X_WP[patch.phalanx];
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      if (contacts_.mode[slot] == Mode::apart && !contacts_.near[slot]) continue;
      const Eigen::Vector3d p0 = X_WP0 * contacts_.p_P[slot];
      const Eigen::Vector3d p1 = X_WP1 * contacts_.p_P[slot];
      const Eigen::Vector3d C = body_.X_WO * contacts_.C_O[slot];
      const Eigen::Vector3d n = body_.X_WO.R * contacts_.n_O[slot];
      const Eigen::Vector3d C_free = C + h * (v_free + w_free.cross(C - center));
      if (contacts_.mode[slot] == Mode::apart && (p1 - C_free).dot(n) >= 0) continue;
      StepSample& s = samples_[slots_.size()];
      s.element = {scene_.contact.stiffness, scene_.contact.damping, h, n, p1 - C, (p1 - p0) / h};
      s.arm = C - center;
      s.sliding = contacts_.mode[slot] == Mode::slip;
      slots_.push_back(slot);
    }
  }
}

/// Writes forces, modes and anchors back, and keeps the energy book.
void World::scatter(double h) {
  for (std::size_t i = 0; i < slots_.size(); ++i) update_anchor(slots_[i], samples_[i], h);
  // Samples that are apart, or whose hand left.
  for (const PatchSlot& patch : contacts_.patches) {
    if (!patch.active) continue;
    const bool gone = !next_[patch.hand].present;
    for (int i = 0; i < patch.count; ++i) {
      const std::size_t slot = patch.slot(i);
      if (gone) {
        if (contacts_.mode[slot] != Mode::apart) dissipated_ += stored(slot);
        set_mode(slot, Mode::apart, h);
        contacts_.near[slot] = false;
      } else if (contacts_.mode[slot] == Mode::apart) {
        const Eigen::Vector3d p_O =
            body_.X_WO.inverse() * (next_[patch.hand].X_WP[patch.phalanx] * contacts_.p_P[slot]);
        place_anchor(slot, p_O, p_O);
      }
    }
  }
}

void World::update_anchor(std::size_t slot, const StepSample& s, double h) {
  contacts_.f_W.set(slot, s.f);
  const PatchSlot& patch = contacts_.patches[patch_of_slot_[slot]];
  if (s.trial.N <= 0) {
    if (contacts_.mode[slot] != Mode::apart) dissipated_ += stored(slot);  // a spring that lets go keeps nothing
    return set_mode(slot, Mode::apart, h);
  }
  const double mu_d = scene_.bodies.front().friction.mu_dynamic;
  const bool slides = s.sliding && s.trial.t_norm > mu_d * s.trial.N;
  const Eigen::Quaterniond R_OW = body_.X_WO.R.conjugate();
  Anchor anchor{contacts_.C_O[slot], contacts_.n_O[slot]};
  const Eigen::Vector3d before = s.trial.lag - h * s.trial.v_t;  // in W: the damper sees the lag's rate in W
  Eigen::Vector3d step = Eigen::Vector3d::Zero();                // of the anchor, as far as the surface let it
  Eigen::Vector3d stretch = s.trial.v_t;                         // rate of the lag
  if (slides) {
    const Eigen::Vector3d lag = lag_after_sliding(s.element, s.tangent, before);
    slide(field(), R_OW * (s.trial.lag - lag), anchor);
    stretch = (lag - before) / h;
    step = body_.X_WO.R * (anchor.C_O - contacts_.C_O[slot]);
    contacts_.C_O.set(slot, anchor.C_O);
    contacts_.n_O.set(slot, anchor.n_O);
  }
  const Eigen::Vector3d p_O = body_.X_WO.inverse() * (next_[patch.hand].X_WP[patch.phalanx] * contacts_.p_P[slot]);
  contacts_.depth[slot] = -(p_O - anchor.C_O).dot(anchor.n_O);
  contacts_.lag_O.set(slot, tangential(p_O - anchor.C_O, anchor.n_O));

  const Eigen::Vector3d v_C = velocity_.head<3>() + velocity_.tail<3>().cross(s.arm);
  const Eigen::Vector3d v = s.element.v_p - v_C;
  const double closing = -v.dot(s.element.n);
  hand_work_ += h * s.f.dot(s.element.v_p);
  dissipated_ += s.tangent.dot(step) + h * s.element.damping * (closing * closing + stretch.squaredNorm());
  set_mode(slot, slides ? Mode::slip : Mode::stick, h);
}

void World::set_mode(std::size_t slot, Mode mode, double h) {
  const Mode from = contacts_.mode[slot];
  if (mode == Mode::apart) contacts_.f_W.set(slot, Eigen::Vector3d::Zero());
  if (from == mode) return;
  contacts_.mode[slot] = mode;
  events_.push_back({t_ + h, h, kind_of(from, mode), contacts_.id[slot], body_.state()});
}

/// Seeds patches of phalanges that come near, drops those that went away.
void World::detect(double h) {
  const Pose X_OW = body_.X_WO.inverse();
  for (std::size_t i = 0; i < contacts_.patches.size(); ++i) {
    PatchSlot& patch = contacts_.patches[i];
    if (patch.given) continue;
    const HandFrame& hand = next_[patch.hand];
    if (!hand.present) {
      if (patch.active) drop(patch);
      continue;
    }
    if (patch.active) {  // a patch with any sample in contact stays
      const auto first = contacts_.mode.begin() + patch.first;
      if (std::any_of(first, first + patch.count, [](Mode m) { return m != Mode::apart; })) continue;
    }
    const Pose X_OP = X_OW * hand.X_WP[patch.phalanx];
    // What may come nearer during the next step is seeded now.
    const double step = h > 0 ? (hand.X_WP[patch.phalanx].p - now_[patch.hand].X_WP[patch.phalanx].p).norm() : 0;
    const double offset = scene_.patch.contact_offset + step + h * body_.v.norm();
    switch (proximity_[i].update(field(), X_OP, patch.active, offset)) {
      case Proximity::Verdict::near:
        seed(patch, X_OP, proximity_[i].place());
        break;
      case Proximity::Verdict::far:
        drop(patch);
        break;
      case Proximity::Verdict::same:
        break;
    }
  }
}

void World::seed(PatchSlot& patch, const Pose& X_OP, const Nearest& place) {
  const Patch points = seed_patch(patch.phalanx, X_OP, place, scene_.patch);
  patch.active = true;
  for (int i = 0; i < patch.count; ++i) {
    const std::size_t slot = patch.slot(i);
    contacts_.p_P.set(slot, points.p_P[i]);
    contacts_.mode[slot] = Mode::apart;
    const Eigen::Vector3d p_O = X_OP * points.p_P[i];
    place_anchor(slot, p_O, p_O);
    contacts_.f_W.set(slot, Eigen::Vector3d::Zero());
  }
}

void World::drop(PatchSlot& patch) {
  patch.active = false;
  for (int i = 0; i < patch.count; ++i) {
    contacts_.mode[patch.slot(i)] = Mode::apart;
    contacts_.near[patch.slot(i)] = false;
  }
}

ContactState World::contact(std::size_t slot) const {
  const PatchSlot& patch = contacts_.patches[patch_of_slot_[slot]];
  ContactState state;
  state.id = contacts_.id[slot];
  state.mode = contacts_.mode[slot];
  state.depth = contacts_.depth[slot];
  state.p_W = next_[patch.hand].X_WP[patch.phalanx] * contacts_.p_P[slot];
  state.C_W = body_.X_WO * contacts_.C_O[slot];
  state.n_W = body_.X_WO.R * contacts_.n_O[slot];
  state.f_W = contacts_.f_W[slot];
  return state;
}

/// Energy in the springs of a sample in contact.
double World::stored(std::size_t slot) const {
  const double depth = contacts_.depth[slot];
  return 0.5 * scene_.contact.stiffness * (depth * depth + contacts_.lag_O[slot].squaredNorm());
}

Energy World::energy() const {
  Energy e;
  e.kinetic = 0.5 * body_.mass * body_.v.squaredNorm() + 0.5 * body_.w.dot(body_.inertia() * body_.w);
  e.potential = body_.mass * (-scene_.gravity.dot(body_.center()) - start_height_);
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    if (contacts_.mode[i] != Mode::apart) e.elastic += stored(i);
  }
  e.dissipated = dissipated_;
  e.hand_work = hand_work_;
  return e;
}

}  // namespace handhold::realtime
