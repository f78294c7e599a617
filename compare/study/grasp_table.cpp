// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/grasp_table.hpp"

#include <ctime>
#include <limits>

#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

double process_seconds() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

PlacingRequest request_of(const GraspPair& pair, const GraspTableOptions& options) {
  PlacingRequest request{.trace = pair.trace.get(), .hand = pair.hand, .body = pair.body};
  request.engine = options.engine;
  request.tried = options.tried;
  request.contact_of = [&](const Placement& placement) { return options.contact_of(pair.body, placement); };
  return request;
}

/// To the end of the grasp: what the hand does afterwards is not asked.
Scene grasp_scene(const PlacingRequest& request, const TriedPlacement& best) {
  Scene scene = scene_of(request, best.placement, best.contact);
  scene.name = request.body.name;
  scene.duration = std::min(scene.duration, best.placement.until - best.placement.start);
  return scene;
}

void play(const GraspTableOptions& options, const Scene& scene, const TriedPlacement& best, GraspRow& row) {
  std::vector<Recording> recordings;
  EngineOptions settings = options.engine;
  settings.substeps = best.trial.substeps;
  for (const std::string& name : options.engines) {
    const std::unique_ptr<Engine> engine = options.make_engine(name);
    recordings.push_back(engine->play(scene, settings));
    const Recording& recording = recordings.back();
    const GraspSummary summary = summarize(scene, recording);
    row.engines.push_back({name, recording.outcome,
                           judge_grasp(scene, recording, best.placement.finger, scene.duration), summary.dropped_at,
                           summary.frame.p50});
    if (recordings.size() == 1 && options.horizon) row.horizon = options.horizon(scene, *engine, settings, recording);
  }
  if (recordings.size() > 1)
    row.difference = difference(recordings[0], recordings[1], row.horizon.value_or(scene.duration)).max_translation;
}

}  // namespace

GraspRow play_grasp(const GraspPair& pair, const GraspTableOptions& options) {
  GraspRow row{.recording = pair.recording,
               .object = pair.body.name,
               .mass = pair.body.inertia.mass,
               .mu = pair.body.friction.mu_static};
  const PlacingRequest request = request_of(pair, options);
  try {
    const double before = process_seconds();
    row.placing = place_by_trial(request, *options.make_engine("realtime"));
    row.placing_seconds = process_seconds() - before;
  } catch (const InputError& error) {
    row.refused = error.what();
    return row;
  }
  const TriedPlacement& best = row.placing->tried.front();
  play(options, grasp_scene(request, best), best, row);
  return row;
}

}  // namespace handhold::compare
