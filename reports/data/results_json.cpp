#include "reports/data/results_json.hpp"

#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/data/placed_gate.hpp"
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

Json gate_json(const compare::Gate& gate) {
  Json out;
  out["quantity"] = gate.quantity;
  put(out, "measured", gate.measured);
  out["bound"] = gate.bound == compare::Bound::at_most ? "at most" : "at least";
  put(out, "limit", gate.limit);
  out["unit"] = gate.unit;
  out["pedigree"] = catalogue::to_string(gate.pedigree);
  out["reason"] = gate.reason;
  out["passes"] = compare::passes(gate);
  put(out, "slack", slack(gate));
  out["vacuous"] = compare::is_vacuous(gate);
  out["sentence"] = compare::sentence(gate);
  return out;
}

Json judgement_json(const compare::Judgement& judgement, const catalogue::Limit& limit) {
  Json out;
  put(out, "value", judgement.value);
  put(out, "error", judgement.error);
  out["relative"] = limit.relative;
  out["gate"] = gate_json(judgement.gate);
  return out;
}

Json study_json(const compare::OrderStudy& study) {
  Json out;
  put(out, "substep", study.substep);
  put(out, "error", study.error);
  put(out, "slope", study.order.slope);
  put(out, "standard_error", study.order.standard_error);
  out["gate"] = gate_json(study.gate);
  return out;
}

Json finding_json(const compare::Finding& finding) {
  const catalogue::Expectation& e = finding.expectation;
  Json out;
  out["quantity"] = e.quantity;
  out["unit"] = e.unit;
  put(out, "truth", e.truth);
  out["pedigree"] = catalogue::to_string(e.pedigree);
  out["source"] = e.source;
  out["reference"] = judgement_json(finding.reference, e.reference);
  if (finding.realtime.asked) out["realtime"] = judgement_json(finding.realtime, e.realtime);
  out["order_study"] = finding.study ? study_json(*finding.study) : Json(nullptr);
  return out;
}

Json curve_json(const compare::CurveData& curve) {
  if (curve.t.empty()) return nullptr;
  Json out;
  out["label"] = curve.label;
  put(out, "t", curve.t);
  put(out, "truth", curve.truth);
  put(out, "reference", curve.reference);
  put(out, "realtime", curve.realtime);
  return out;
}

Json frame_json(const compare::FrameTimes& frame) {
  Json out;
  out["frames"] = frame.frames;
  put(out, "p50", frame.p50);
  put(out, "p90", frame.p90);
  put(out, "p99", frame.p99);
  put(out, "p999", frame.p999);
  put(out, "max", frame.max);
  return out;
}

Json run_json(const compare::RunResult& run) {
  Json out;
  out["name"] = run.name;
  out["findings"] = Json::array();
  for (const compare::Finding& finding : run.findings) out["findings"].push_back(finding_json(finding));
  out["curve"] = curve_json(run.curve);
  out["realtime_frame_seconds"] = frame_json(run.realtime_frame);
  put(out, "reference_seconds", run.reference_seconds);
  put(out, "realtime_seconds", run.realtime_seconds);
  out["reference_note"] = run.reference_note;
  out["realtime_note"] = run.realtime_note;
  return out;
}

Json case_json(const compare::CaseResult& of_case) {
  Json out;
  out["id"] = of_case.id;
  out["title"] = of_case.title;
  out["level"] = of_case.level;
  out["statement"] = of_case.statement;
  out["formula"] = of_case.formula;
  out["note"] = of_case.note;
  out["runs"] = Json::array();
  for (const compare::RunResult& run : of_case.runs) out["runs"].push_back(run_json(run));
  return out;
}

Json verdict_json(const compare::SuiteResult& result) {
  const Count n = count(placed_gates(result));
  Json out;
  out["passed"] = compare::passed(result);
  out["sentence"] = verdict_sentence(result);
  out["interrupted"] = result.interrupted;
  out["gates"] = n.gates;
  out["failed"] = n.failed;
  out["vacuous"] = n.vacuous;
  return out;
}

}  // namespace

std::string results_json(const compare::SuiteResult& result) {
  Json out;
  out["format"] = "handhold results";
  out["version"] = 1;
  out["verdict"] = verdict_json(result);
  out["provenance"] = Json::object();
  for (const auto& [key, text] : result.provenance) out["provenance"][clean_utf8(key)] = text;
  put(out, "seconds", result.seconds);
  out["cases"] = Json::array();
  for (const compare::CaseResult& of_case : result.cases) out["cases"].push_back(case_json(of_case));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace handhold::reports
