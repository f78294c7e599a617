#pragma once

#include <vector>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"
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

  void frame(double t, const BodyMotion& body, const Modes& modes, const Anchors& anchors, const Evaluation& evaluation,
             const Contacts& contacts, const Work& work);
  void events(double t, double window, const std::vector<Transition>& transitions, const BodyMotion& body,
              const Layout& layout);
  void frame_time(double seconds) { recording_.frame_time.push_back(seconds); }
  void end(Outcome outcome, const std::string& note);
  void provenance(const std::string& key, const std::string& value) { recording_.provenance[key] = value; }

  [[nodiscard]] Recording take() { return std::move(recording_); }

 private:
  [[nodiscard]] Energy energy(const BodyMotion& body, const Modes& modes, const Evaluation& evaluation,
                              const Contacts& contacts, const Work& work) const;

  const Scene& scene_;
  Recording recording_;
};

}  // namespace handhold::reference
