// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>

#include "cases/model/recording.hpp"

namespace handhold::testing {

/// 64-bit FNV-1a (Fowler, Noll, Vo) over the bits of what it is given: one bit more or less, another number. Tells −0
/// from 0, unlike ==.
class Digest {
 public:
  void put(double value) {
    std::uint64_t raw;
    std::memcpy(&raw, &value, sizeof raw);
    put(raw);
  }
  void put(std::integral auto value) {
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ (std::uint64_t(value) >> 8 * byte & 0xff)) * 0x100000001b3;
    }
  }
  void put(const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) put(v[i]);
  }
  void put(const Pose& X) {
    put(X.p);
    put(Eigen::Vector3d(X.R.vec()));
    put(X.R.w());
  }
  void put(const ContactState& c) {
    put(SampleId::key(c.id));
    put(int(c.mode));
    put(c.depth);
    for (const Eigen::Vector3d& v : {c.p_W, c.C_W, c.n_W, c.f_W}) put(v);
  }
  void put(const Event& e) {
    for (const double x : {e.t, e.window}) put(x);
    put(int(e.kind));
    put(SampleId::key(e.id));
    put(e.body.X_WO);
  }
  void put(const Energy& e) {
    for (const double x : {e.kinetic, e.potential, e.elastic, e.dissipated, e.hand_work}) put(x);
  }

  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_{0xcbf29ce484222325};
};

}  // namespace handhold::testing
