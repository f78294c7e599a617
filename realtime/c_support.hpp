// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <vector>

#include "cases/model/hand_frame.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/voxel_field.hpp"
#include "realtime/handhold.h"

// What the sources of the C interface share.

struct hh_field {
  std::shared_ptr<const handhold::VoxelField> field{};
  std::vector<Eigen::Vector3d> samples_O{};
};

namespace handhold::c {

static_assert(HH_PHALANGES == phalanx_count);

inline int fail(hh_error* error, int code, const char* message) {
  if (!error) return code;
  error->code = code;
  std::strncpy(error->message, message, HH_ERROR_LENGTH - 1);
  error->message[HH_ERROR_LENGTH - 1] = '\0';
  return code;
}

/// Runs `work` and turns what it throws into a code: nothing may fly through C.
template <class Work>
int guarded(hh_error* error, const Work& work) {
  try {
    work();
    return fail(error, HH_OK, "");
  } catch (const InputError& wrong) {
    return fail(error, HH_WRONG_INPUT, wrong.what());
  } catch (const std::bad_alloc&) {
    return fail(error, HH_NO_MEMORY, "no memory left");
  } catch (const std::exception& bug) {
    return fail(error, HH_BUG, bug.what());
  } catch (...) {
    return fail(error, HH_BUG, "an exception that is not a std::exception");
  }
}

inline void require(bool holds, const char* rule) {
  if (!holds) throw InputError(rule);
}

inline Eigen::Vector3d vector(const double* v) { return {v[0], v[1], v[2]}; }

inline void store(const Eigen::Vector3d& v, double* out) { std::copy_n(v.data(), 3, out); }

inline Pose pose(const hh_pose& x) {
  return {Eigen::Quaterniond(x.q[0], x.q[1], x.q[2], x.q[3]).normalized(), vector(x.p)};
}

inline bool is_unit(const hh_pose& x) { return std::abs(Eigen::Map<const Eigen::Vector4d>(x.q).norm() - 1) < 1e-3; }

/// Throws InputError for a quaternion of a hand that is there that is finite and not a unit one.
inline void read_frames(const hh_hand_frame* hands, std::vector<HandFrame>& frames) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    frames[i].present = hands[i].present != 0;
    for (int k = 0; k < phalanx_count; ++k) {
      const hh_pose& x = hands[i].phalanx[k];
      const bool finite = Eigen::Map<const Eigen::Vector4d>(x.q).allFinite();
      require(!frames[i].present || !finite || is_unit(x),
              "hand: the quaternion of a phalanx must be a unit one (w, x, y, z; present = 0 if there is no hand)");
      frames[i].X_WP[std::size_t(k)] = pose(x);
    }
  }
}

inline HandModel model_of(const hh_hand& hand) {
  HandModel model;
  for (std::size_t i = 0; i < model.capsules.size(); ++i) model.capsules[i] = {hand.half_length[i], hand.radius[i]};
  model.palm_box.half_extents = vector(hand.palm);
  validate(model, "hand");
  return model;
}

}  // namespace handhold::c
