// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "reference/contacts.hpp"
#include "reference/reference.hpp"

namespace handhold::reference {

/// The two integrals of the energy book, states of the integration [J].
struct Work {
  double dissipated{};
  double hand{};
};

/// Writes a run down.
class Recorder {
 public:
  Recorder(const Scene& scene, const Options& options);

  /// Samples of bodies are written down while they are nearer than the contact offset, as the patches of phalanges are:
  /// far ones would fill the memory.
  void frame(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors,
             const Evaluation& evaluation, Contacts& contacts, const Work& work);
  void events(double t, double window, const std::vector<Transition>& transitions, const Motions& motions,
              const Layout& layout);
  void undecided(double t, const std::vector<Undecided>& found, const Layout& layout);
  void frame_time(double seconds) { recording_.frame_time.push_back(seconds); }
  void end(Outcome outcome, const std::string& note);
  void provenance(const std::string& key, const std::string& value) { recording_.provenance[key] = value; }

  [[nodiscard]] Recording take() { return std::move(recording_); }

 private:
  [[nodiscard]] Energy energy(const Motions& motions, const Modes& modes, const Evaluation& evaluation,
                              const Contacts& contacts, const Work& work) const;

  const Scene& scene_;
  Recording recording_;
};

}  // namespace handhold::reference
