// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/contacts.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "cases/model/defect.hpp"
#include "cases/model/hand_model.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// Bodies of one shape share a surface.
std::vector<std::shared_ptr<const Surface>> make_surfaces(const Scene& scene, SurfaceModel model) {
  std::map<const VoxelField*, std::shared_ptr<const Surface>> made;
  std::vector<std::shared_ptr<const Surface>> surfaces;
  for (const Body& body : scene.bodies) {
    std::shared_ptr<const Surface>& surface = made[body.field.get()];
    if (!surface) surface = make_surface(body.field, model);
    surfaces.push_back(surface);
  }
  return surfaces;
}

}  // namespace

Contacts::Contacts(const Scene& scene, double accuracy, SurfaceModel model)
    : scene_(scene),
      layout_(make_layout(scene)),
      surfaces_(make_surfaces(scene, model)),
      seed_distance_(scene.patch.contact_offset),
      event_window_(event_window(accuracy)),
      phalanges_(scene.hands.size() * std::size_t(phalanx_count)),
      memory_(layout_.id.size()),
      near_(layout_.pads.size()) {
  const double shallow = std::max(10 * touch_depth, 100 * accuracy);
  for (const Pad& pad : layout_.pads) {
    const Friction& touched = scene.bodies[std::size_t(pad.body)].friction;
    const ContactParameters& law = pad.of_body() ? scene.body_contact : scene.contact;
    const Friction friction = DEFECT(reference_pair_friction_of_one, pad.of_body(), false)
                                  ? combined(scene.bodies[std::size_t(pad.carrier)].friction, touched)
                                  : touched;
    elements_.push_back({law.stiffness, law.damping, friction, shallow});
  }
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const double band = surfaces_[i]->band();
    // Beyond the band distances are clamped: a patch is dropped there at the latest.
    drop_distance_.push_back(std::min(2 * seed_distance_, 0.99 * band));
    if (!scene.hands.empty() && seed_distance_ > 0.9 * band)
      throw InputError(fmt::format(
          "contact_offset={} m: must be at most 0.9 of the voxel band of body '{}', {} m (voxelize with a wider band)",
          seed_distance_, scene.bodies[i].name, band));
  }
}

std::string Contacts::describe(int slot) const {
  const SampleId& id = layout_.id[std::size_t(slot)];
  const std::string& touched = scene_.bodies[id.body].name;
  if (id.belongs_to_body())
    return fmt::format("body '{}' sample {} on body '{}'", scene_.bodies[id.phalanx].name, int(id.sample), touched);
  return fmt::format("hand {} {} sample {} on body '{}'", int(id.hand), phalanx_name(id.phalanx), int(id.sample),
                     touched);
}

bool Contacts::present_after(int hand, double t) const {
  const std::vector<Interval>& presence = scene_.hands[std::size_t(hand)].motion->presence();
  return std::any_of(presence.begin(), presence.end(), [&](const Interval& i) { return i.begin <= t && t < i.end; });
}

bool Contacts::live(const Pad& pad, const Modes& modes) const {
  return pad.of_body() || modes.present[std::size_t(pad.hand)];
}

const Contacts::PhalanxMotion& Contacts::phalanx(const Pad& pad, double t) {
  PhalanxMotion& m = phalanges_[std::size_t(pad.hand * phalanx_count + pad.carrier)];
  if (m.t == t) return m;
  const HandMotion& hand = *scene_.hands[std::size_t(pad.hand)].motion;
  const Pose X = hand.pose(pad.carrier, t);
  const Twist V = hand.twist(pad.carrier, t);
  m = {t, X, {X.R.toRotationMatrix(), X.p, V.w, V.v}};
  return m;
}

const Motion& Contacts::carrier(const Pad& pad, double t, const Motions& motions) {
  return pad.of_body() ? motions[std::size_t(pad.carrier)] : phalanx(pad, t).motion;
}

const AnchorSurface& Contacts::surface_at(std::size_t slot, const Vector3d& anchor, const Foothold& hold,
                                          bool with_curvature) {
  SurfaceMemory& m = memory_[slot];
  // In stick the anchor has not moved by a bit.
  if (!with_curvature && m.anchor == anchor && m.hold == hold) return m.surface;
  m.anchor = anchor;
  m.hold = hold;
  m.surface = surface(layout_.id[slot].body).at(anchor, hold, with_curvature);
  return m.surface;
}

Sample Contacts::place(std::size_t slot, double t, const Motions& motions, const Vector3d& p_P) {
  const Pad& pad = layout_.pads[std::size_t(layout_.pad_of[slot])];
  const Motion& from = carrier(pad, t, motions);
  const Motion& body = motions[std::size_t(pad.body)];
  Sample s;
  const Vector3d arm = from.R * p_P;
  s.p_W = from.p + arm;
  s.v_W = from.v + from.w.cross(arm);
  const Vector3d offset = s.p_W - body.p;
  s.p_O = body.R.transpose() * offset;
  s.v_O = body.R.transpose() * (s.v_W - body.v - body.w.cross(offset));
  return s;
}

/// Force and witnesses of a sample in contact.
void Contacts::respond_at(std::size_t slot, Mode mode, const Vector3d& anchor, const Foothold& hold, Sample& s) {
  const Element& element = elements_[std::size_t(layout_.pad_of[slot])];
  const Surface& surface = *surfaces_[layout_.id[slot].body];
  const Approach approach{s.p_O - anchor, s.v_O};
  if (hold.caught()) {
    const Wedge wedge = surface.wedge(hold);
    s.n_O = wedge.normal(approach.r);
    s.response = respond(element, approach, wedge);
  } else {
    const bool with_curvature = mode == Mode::slip && element.damping == 0;
    const AnchorSurface& here = surface_at(slot, anchor, hold, with_curvature);
    s.n_O = here.n;
    s.response = respond(element, mode, approach, here);
  }
  s.gap = s.response.release;
  s.friction = s.response.friction;
  s.edge = mode == Mode::slip ? surface.overrun(anchor, hold) : -1;
}

/// Action on the touched body, reaction on the carrying one, both along the line through p.
void Contacts::add_to(const Pad& pad, const Motions& motions, Sample& s, Evaluation& out) const {
  const Motion& body = motions[std::size_t(pad.body)];
  const Vector3d force = body.R * s.response.force;
  Wrench& action = out.wrench[std::size_t(pad.body)];
  action.force += force;
  action.torque += (s.p_W - body.p).cross(force);
  if (pad.of_body()) {
    Wrench& reaction = out.wrench[std::size_t(pad.carrier)];
    reaction.force -= force;
    reaction.torque -= (s.p_W - motions[std::size_t(pad.carrier)].p).cross(force);
  } else {
    out.hand_power += force.dot(s.v_W);
  }
  out.dissipation += s.response.dissipation;
  out.release = std::max(out.release, s.gap);
  out.friction = std::max(out.friction, s.friction);
  out.edge = std::max(out.edge, s.edge);
}

void Contacts::evaluate(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors,
                        Evaluation& out) {
  out.samples.resize(layout_.id.size());
  out.wrench.assign(motions.size(), Wrench());
  out.hand_power = out.dissipation = 0;
  out.singular_slot = -1;
  constexpr double none = -1e6;  // of a witness: nothing is near
  out.release = out.friction = out.edge = none;
  out.watched = false;
  for (std::size_t i = 0; i < layout_.pads.size(); ++i) {
    if (modes.touching[i] == 0) continue;
    const Pad& pad = layout_.pads[i];
    for (std::size_t slot = std::size_t(pad.first); slot < std::size_t(pad.first + pad.count); ++slot) {
      if (modes.mode[slot] == Mode::apart) continue;
      Sample& s = out.samples[slot];
      s = place(slot, t, motions, modes.p_P[slot]);
      respond_at(slot, modes.mode[slot], anchors.col(Eigen::Index(slot)), modes.hold[slot], s);
      if (s.response.singular) out.singular_slot = int(slot);
      add_to(pad, motions, s, out);
    }
  }
}

double Contacts::elastic_energy(const Modes& modes, const Evaluation& evaluation) const {
  double energy = 0;
  for (std::size_t slot = 0; slot < modes.mode.size(); ++slot) {
    if (modes.mode[slot] == Mode::apart) continue;
    const Response& r = evaluation.samples[slot].response;
    energy += 0.5 * element(int(slot)).stiffness * (r.depth * r.depth + r.lag.squaredNorm());
  }
  return energy;
}

}  // namespace handhold::reference
