// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/results_json.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "cases/input/text_encoding.hpp"
#include "compare/judge/verdict.hpp"
#include "reports/data/stored_json.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;

const char* not_finite(double value) { return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf"; }

void put(Json& object, const std::string& key, double value) {
  if (std::isfinite(value)) {
    object[key] = value;
    return;
  }
  object[key] = nullptr;
  object[key + "_text"] = not_finite(value);
}

void put(Json& object, const std::string& key, const std::vector<double>& values) {
  Json list = Json::array(), text = Json::object();
  for (std::size_t i = 0; i < values.size(); ++i) {
    list.push_back(std::isfinite(values[i]) ? Json(values[i]) : Json(nullptr));
    if (!std::isfinite(values[i])) text[std::to_string(i)] = not_finite(values[i]);
  }
  object[key] = std::move(list);
  if (!text.empty()) object[key + "_text"] = std::move(text);
}

/// What the gate asks, beside the numbers that the judgement or study already says.
void put_gate(Json& out, const compare::Gate& gate) {
  put(out, "limit", gate.limit);
  out["reason"] = gate.reason;
  out["passes"] = compare::passes(gate);
  put(out, "slack", compare::slack(gate));
  out["vacuous"] = compare::is_vacuous(gate);
  out["sentence"] = compare::sentence(gate);
}

Json judgement_json(const compare::Judgement& judgement) {
  Json out;
  out["engine"] = judgement.engine;
  out["state"] = judgement.why_not.empty() ? "judged" : "not asked";
  if (!judgement.why_not.empty()) {
    out["why"] = judgement.why_not;
    return out;
  }
  put(out, "value", judgement.value);
  put(out, "error", judgement.error);
  out["relative"] = judgement.relative;
  if (judgement.gate) put_gate(out, *judgement.gate);
  if (judgement.grade) out["grade"] = compare::to_string(*judgement.grade);
  return out;
}

Json study_json(const compare::OrderStudy& study) {
  Json out;
  out["engine"] = study.engine;
  put(out, "step", study.step);
  put(out, "error", study.error);
  put(out, "slope", study.order.slope);
  put(out, "standard_error", study.order.standard_error);
  put_gate(out, study.gate);
  return out;
}

template <class Item, class Make>
Json list(const std::vector<Item>& items, const Make& make) {
  Json out = Json::array();
  for (const Item& item : items) out.push_back(make(item));
  return out;
}

Json claim_json(const compare::ClaimResult& result) {
  const catalogue::Claim& claim = result.claim;
  Json out;
  out["quantity"] = claim.quantity;
  out["unit"] = claim.unit;
  put(out, "truth", claim.truth);
  out["pedigree"] = catalogue::to_string(claim.pedigree);
  out["source"] = claim.source;
  out["at"] = claim.measure.at ? Json(*claim.measure.at) : Json(nullptr);
  out["judgements"] = list(result.judgements, judgement_json);
  out["studies"] = list(result.studies, study_json);
  return out;
}

Json curve_json(const compare::CurveData& curve) {
  if (curve.t.empty()) return nullptr;
  Json out;
  out["label"] = curve.label;
  put(out, "t", curve.t);
  put(out, "truth", curve.truth);
  out["engines"] = Json::object();
  for (const auto& [engine, values] : curve.engines) put(out["engines"], engine, values);
  return out;
}

Json play_json(const compare::Play& play) {
  Json out;
  out["engine"] = play.engine;
  if (!play.why_not.empty()) out["why"] = play.why_not;
  out["note"] = play.note;
  return out;
}

Json run_json(const compare::RunResult& run) {
  Json out;
  out["name"] = run.name;
  out["variant"] = run.variant;
  out["claims"] = list(run.claims, claim_json);
  out["curve"] = curve_json(run.curve);
  out["plays"] = list(run.plays, play_json);
  return out;
}

Json case_json(const compare::CaseResult& of_case) {
  Json out;
  out["id"] = of_case.id;
  out["title"] = of_case.title;
  out["level"] = to_string(of_case.level);
  out["truth_level"] = of_case.truth_level;
  out["statement"] = of_case.statement;
  out["formula"] = of_case.formula;
  out["note"] = of_case.note;
  out["runs"] = list(of_case.runs, run_json);
  return out;
}

std::string_view to_string(compare::ErrorModel::Kind kind) {
  using Kind = compare::ErrorModel::Kind;
  return kind == Kind::controlled ? "controlled" : kind == Kind::stepped ? "stepped" : "foreign";
}

Json text_json(const std::map<std::string, std::string>& texts) {
  Json out = Json::object();
  for (const auto& [key, text] : texts) out[clean_text(key)] = text;
  return out;
}

Json change_json(const compare::Change& change) {
  Json out;
  out["case"] = change.gate.of_case;
  out["run"] = change.gate.run;
  out["quantity"] = change.gate.claim;
  out["engine"] = change.gate.engine;
  out["order"] = change.gate.order;
  out["movement"] = compare::to_string(change.movement);
  out["sentence"] = compare::sentence(change);
  return out;
}

Json engine_json(const compare::EngineInfo& engine) {
  Json out;
  out["name"] = engine.name;
  out["version"] = engine.version;
  out["levels"] = list(engine.levels, [](Level level) { return to_string(level); });
  out["error_model"] = to_string(engine.errs.kind);
  out["gated"] = engine.errs.kind != compare::ErrorModel::Kind::foreign;
  out["records"] = Json::array({"poses"});
  const compare::Records& r = engine.records;
  for (const auto& [has, name] : {std::pair{r.contacts, "contacts"}, std::pair{r.events, "events"},
                                  std::pair{r.energy, "energy"}, std::pair{r.frame_times, "frame times"}})
    if (has) out["records"].push_back(name);
  out["settings"] = text_json(engine.settings);
  return out;
}

Json frame_json(const compare::FrameTimes& frame) {
  if (frame.frames == 0) return nullptr;
  Json out;
  out["frames"] = frame.frames;
  put(out, "p50", frame.p50);
  put(out, "p90", frame.p90);
  put(out, "p99", frame.p99);
  put(out, "p999", frame.p999);
  put(out, "max", frame.max);
  return out;
}

}  // namespace

std::string results_json(const compare::SuiteResult& result) {
  Json out;
  out["format"] = "handhold results";
  out["version"] = 2;
  out["verdict"] = verdict_json(compare::standing(result));
  if (result.shard) out["shard"] = {{"index", result.shard->index}, {"of", result.shard->of}, {"runs", result.runs}};
  out["provenance"] = text_json(result.provenance);
  out["engines"] = list(result.engines, engine_json);
  out["cases"] = list(result.cases, case_json);
  if (result.moved) out["moved"] = list(*result.moved, change_json);
  return file_text(out);
}

std::string times_json(const compare::SuiteResult& result, const RecordingNames& recordings) {
  Json out;
  out["format"] = "handhold times";
  out["version"] = 1;
  out["occasion"] = text_json(result.occasion);
  put(out, "seconds", result.seconds);
  out["plays"] = Json::array();
  for (const compare::CaseResult& of_case : result.cases)
    for (const compare::RunResult& run : of_case.runs)
      for (const compare::Play& play : run.plays) {
        if (!play.why_not.empty()) continue;
        Json row;
        row["case"] = of_case.id;
        row["run"] = run.name;
        row["variant"] = run.variant;
        row["engine"] = play.engine;
        put(row, "seconds", play.seconds);
        row["frame_seconds"] = frame_json(play.frame);
        if (const auto kept = recordings.find(&play); kept != recordings.end()) row["recording"] = kept->second;
        out["plays"].push_back(std::move(row));
      }
  return file_text(out);
}

}  // namespace handhold::reports
