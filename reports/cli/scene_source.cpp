// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/scene_source.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cases/catalogue/case.hpp"
#include "cases/hand/placement.hpp"
#include "cases/input/mesh/field_cache.hpp"
#include "cases/input/scene/materials.hpp"
#include "cases/input/scene/scene_file.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/auto_contact.hpp"
#include "compare/engine/engines.hpp"
#include "compare/study/placing_trial.hpp"
#include "reports/cli/object_source.hpp"
#include "reports/data/object_text.hpp"
#include "reports/data/placing_text.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

std::string trace_remarks(const Trace& trace) {
  std::string out;
  for (const std::string& warning : trace.warnings) out += summary_line("trace warning", warning);
  return out;
}

std::string mesh_remarks(const ImportedMesh& imported) {
  return summary_line("mesh", imported.source) + repair_text(imported.repair, imported.warnings);
}

/// `build` keeps no word of repairs, so files are looked at once more for what they have to say.
std::string file_remarks(const SceneSpec& spec, const fs::path& base) {
  std::string out;
  for (const BodySpec& body : spec.bodies) {
    if (!body.mesh.empty())
      out += mesh_remarks(import_object(base / body.mesh, body.scale, {body.voxel_size, body.band}).mesh);
  }
  for (const HandSpec& hand : spec.hands) out += trace_remarks(read_trace((base / hand.trace).string()));
  return out;
}

NamedScene from_file(const std::string& file) {
  const SceneSpec spec = read_scene(file);
  const fs::path base = fs::path(file).parent_path();
  NamedScene out{spec.name, build(spec, base), ""};
  out.remarks = file_remarks(spec, base);
  return out;
}

std::string known_cases() {
  std::string out;
  for (const catalogue::Case& c : catalogue::all_cases()) out += (out.empty() ? "" : ", ") + c.id;
  return out;
}

std::vector<NamedScene> from_case(const std::string& name) {
  const std::string id = name.substr(0, name.find('/'));
  const std::string run_name = id.size() < name.size() ? name.substr(id.size() + 1) : "";
  const auto& all = catalogue::all_cases();
  const auto found = std::find_if(all.begin(), all.end(), [&](const catalogue::Case& c) { return c.id == id; });
  if (found == all.end()) throw InputError(fmt::format("case '{}': no such case (there are {})", id, known_cases()));
  std::vector<NamedScene> out;
  std::string runs;
  for (const catalogue::Run& run : found->runs) {
    runs += (runs.empty() ? "'" : ", '") + run.name + "'";
    if (!run.variant.empty() || (!run_name.empty() && run.name != run_name)) continue;
    const Problem problem = run.problem();
    if (const auto* scene = std::get_if<Scene>(&problem))
      out.push_back({id + "/" + run.name, *scene, summary_line("case", found->title)});
  }
  if (out.empty() && found->level != Level::compliant)
    throw InputError(fmt::format(
        "case '{}': is of level {}, and run plays scenes of level L2 (judge it with: handhold suite --only {})", id,
        to_string(found->level), id));
  if (out.empty()) throw InputError(fmt::format("case '{}': has no run '{}' (there are {})", id, run_name, runs));
  return out;
}

/// "mug" of "meshes/mug.obj", "shape:mug" of "shape:mug,height=0.1".
std::string short_name(const std::string& object) {
  return object.rfind("shape:", 0) == 0 ? object.substr(0, object.find(',')) : fs::path(object).stem().string();
}

Body make_body(const SceneRequest& request, const ImportedObject& object) {
  const Material& stuff = material(request.material);
  const SolidProperties solid = solid_properties(object.mesh.mesh);
  const double density = request.mass ? *request.mass / solid.volume : request.density.value_or(stuff.density);
  Body body;
  body.name = short_name(request.object);
  body.field = object.field;
  body.inertia = {density * solid.volume, solid.center, density * solid.inertia};
  body.friction = stuff.friction();
  return body;
}

compare::PlacingRequest placing_request(const SceneRequest& request, const Trace& trace, const Body& body) {
  compare::PlacingRequest placing{.trace = &trace, .hand = std::size_t(request.hand), .body = body};
  placing.tried = request.tries;
  placing.choose_substeps = !request.substeps;
  if (request.substeps) placing.engine.substeps = *request.substeps;
  placing.contact_of = [&request, body](const Placement& placement) {
    ContactParameters contact = compare::auto_contact(body, placement, PatchOptions{}.samples);
    if (request.stiffness) contact = {*request.stiffness, ContactParameters{}.damping};
    if (request.damping) contact.damping = *request.damping;
    return contact;
  };
  return placing;
}

/// The object where the request says: its pose at the trace's beginning.
Scene placed_by_hand(const compare::PlacingRequest& placing, const SceneRequest& request) {
  Placement placement;
  placement.X_WO = parse_placement(request.place);
  placement.start = placement.held_until = placing.trace->t.front();
  return compare::scene_of(placing, placement, placing.contact_of(placement));
}

/// The object in the hand's grasp that holds it best.
NamedScene placed_by_trial(const compare::PlacingRequest& request) {
  const compare::Placing placing = compare::place_by_trial(request, *compare::make_engine("realtime"));
  const compare::TriedPlacement& best = placing.tried.front();
  NamedScene out{"", compare::scene_of(request, best.placement, best.contact), placing_text(placing, request.body)};
  out.substeps = best.trial.substeps;
  out.grasp_end = best.placement.until - best.placement.start;
  out.remarks += summary_line(
      "", fmt::format("t = 0 is {} s of the trace; a support holds the object until {} s; the grasp ends at {} s",
                      number(best.placement.start, 4), number(out.scene.bodies.front().held_until, 4),
                      number(*out.grasp_end, 4)));
  return out;
}

NamedScene from_trace(const SceneRequest& request) {
  const Trace trace = read_trace(request.trace_file, request.reading);
  if (std::size_t(request.hand) >= trace.hands.size()) {
    throw InputError(fmt::format("{}: has {} hands, no number {} (0 is the first)", request.trace_file,
                                 trace.hands.size(), request.hand));
  }
  const ImportedObject object = load_object(request.object, request.scale);
  const compare::PlacingRequest placing = placing_request(request, trace, make_body(request, object));
  NamedScene out =
      request.place == "auto" ? placed_by_trial(placing) : NamedScene{"", placed_by_hand(placing, request), ""};
  out.name = short_name(request.object) + " in " + fs::path(request.trace_file).filename().string();
  out.remarks = mesh_remarks(object.mesh) + trace_remarks(trace) + out.remarks;
  out.scene.name = out.name;
  if (request.held_until) out.scene.bodies.front().held_until = *request.held_until;
  return out;
}

std::vector<NamedScene> scenes_of(const SceneRequest& request) {
  if (!request.scene_file.empty()) return {from_file(request.scene_file)};
  if (!request.case_name.empty()) return from_case(request.case_name);
  if (!request.trace_file.empty()) return {from_trace(request)};
  throw InputError("nothing to run: a scene file, --case, or --trace with --mesh is needed (see handhold run --help)");
}

std::string body_text(const Body& body) {
  return fmt::format("{}: {:.4g} kg, mu {:.3g} static, {:.3g} dynamic, at ({:.1f}, {:.1f}, {:.1f}) mm{}", body.name,
                     body.inertia.mass, body.friction.mu_static, body.friction.mu_dynamic, 1e3 * body.X_WO.p.x(),
                     1e3 * body.X_WO.p.y(), 1e3 * body.X_WO.p.z(),
                     body.held_until > 0 ? fmt::format(", supported until {} s", number(body.held_until, 4)) : "");
}

std::string hand_text(const Hand& hand) {
  std::string present;
  for (const Interval& i : hand.motion->presence())
    present += fmt::format("{}{:.2f} to {:.2f} s", present.empty() ? "" : ", ", i.begin, i.end);
  return fmt::format("{}, tracked {}", hand.motion->side() == Side::left ? "left" : "right", present);
}

}  // namespace

std::vector<NamedScene> load_scenes(const SceneRequest& request) {
  if (request.auto_stiffness && request.trace_file.empty())
    throw InputError("--stiffness auto: suits a grip in a recorded hand (give --trace and --mesh, or a number)");
  std::vector<NamedScene> out = scenes_of(request);
  for (NamedScene& named : out) {
    if (request.stiffness) named.scene.contact.stiffness = *request.stiffness;
    if (request.damping) named.scene.contact.damping = *request.damping;
    if (request.duration) named.scene.duration = *request.duration;
    validate(named.scene);
  }
  return out;
}

Body load_body(const SceneRequest& request) { return make_body(request, load_object(request.object, request.scale)); }

std::string scene_text(const NamedScene& named) {
  std::string out = one_line(named.name) + "\n" + named.remarks;
  for (const Body& body : named.scene.bodies) out += summary_line("body", body_text(body));
  for (const Hand& hand : named.scene.hands) out += summary_line("hand", hand_text(hand));
  out += summary_line(
      "contact", fmt::format("{:.4g} N/m and {:.3g} N s/m a sample, {} samples a phalanx",
                             named.scene.contact.stiffness, named.scene.contact.damping, named.scene.patch.samples));
  return out + summary_line("duration", number(named.scene.duration, 4) + " s");
}

}  // namespace handhold::reports
