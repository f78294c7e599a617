// SPDX-License-Identifier: GPL-3.0-or-later
/** What the page makes of the results: engines with a colour, gates in their place, figures of an engine. */
import { errorText, quantity, ratioText } from './format';
import type {
  GradeName, PlayTimes, RawCase, RawClaim, RawEngine, RawJudgement, RawPlay, RawRun, RawStudy, Results,
  Times,
} from './results';
import { linkTo } from './route';

export interface Engine extends RawEngine {
  /** a CSS variable */
  colour: string;
  /** of its lines in curves, so that colour is not all that tells them apart */
  dash: number[];
}

export type Play = RawPlay & Partial<PlayTimes>;

export interface Run extends RawRun {
  index: number;
  /** name and variant */
  label: string;
  plays: Play[];
}

export interface Case extends Omit<RawCase, 'runs'> {
  runs: Run[];
}

/** A gate in its place: what lists and figures are made of. */
export interface Gate {
  caseOf: Case;
  run: Run;
  claim: RawClaim;
  /** the claim's own quantity, or "order of ..." */
  quantity: string;
  unit: string;
  relative: boolean;
  engine: Engine;
  value: number | null;
  error: number | null;
  limit: number;
  reason: string;
  passes: boolean;
  vacuous: boolean;
  /** error over limit */
  ratio: number;
}

export interface Report {
  results: Results;
  times: Times;
  engines: Engine[];
  cases: Case[];
  gates: Gate[];
  /** the same by case and by engine */
  byCase: Map<Case, Gate[]>;
  byEngine: Map<Engine, Gate[]>;
}

const COLOURS = 8;
const DASHES: readonly number[][] = [[], [], [7, 3], [2, 3], [9, 3, 2, 3]];

function engineOf(raw: RawEngine, index: number): Engine {
  return { ...raw, colour: `--engine-${index % COLOURS}`, dash: DASHES[index % DASHES.length]! };
}

const keyOf = (...parts: (string | undefined)[]): string => parts.map((part) => part ?? '').join('\n');

function caseOf(raw: RawCase, costs: Map<string, PlayTimes>): Case {
  const runs = raw.runs.map((r, index): Run => ({
    ...r, index, label: [r.name, r.variant].filter(Boolean).join(', ') || `run ${index + 1}`,
    plays: (r.plays ?? []).map((p) => ({ ...costs.get(keyOf(raw.id, r.name, r.variant, p.engine)), ...p })),
  }));
  return { ...raw, runs };
}

export function ratioOf(error: number | null, limit: number): number {
  if (error === null || Number.isNaN(limit)) return Infinity;
  if (error === 0) return 0;
  return limit === 0 ? Infinity : Math.abs(error) / limit;
}

/** Judged against a limit: foreign engines are only graded. */
export const isGate = (j: RawJudgement): boolean => j.state === 'judged' && j.limit !== undefined;

/** Slack is limit over what was measured: null where that is zero, or not finite. */
function studyRatio(study: RawStudy): number {
  if (study.slope === null || study.limit === null) return Infinity;
  return study.slack ? 1 / study.slack : study.passes ? 0 : Infinity;
}

function gatesOf(caseOf: Case, run: Run, engines: Map<string, Engine>): Gate[] {
  return run.claims.flatMap((claim) => {
    const place = { caseOf, run, claim, quantity: claim.quantity, unit: claim.unit, relative: false };
    const judged = claim.judgements.filter(isGate).map((j): Gate => {
      const error = j.error ?? null;
      const limit = j.limit ?? NaN;
      return {
        ...place, relative: j.relative === true, engine: engines.get(j.engine)!, value: j.value ?? null, error, limit,
        reason: j.reason ?? '', passes: j.passes === true, vacuous: j.vacuous === true, ratio: ratioOf(error, limit),
      };
    });
    const studies = (claim.studies ?? []).map((s): Gate => {
      const ratio = studyRatio(s);
      const limit = s.limit ?? NaN;
      return {
        ...place, quantity: `order of ${claim.quantity}`, unit: '', engine: engines.get(s.engine)!, value: s.slope,
        error: s.slope === null ? null : ratio * limit, limit, reason: s.reason, passes: s.passes,
        vacuous: s.vacuous === true, ratio,
      };
    });
    return [...judged, ...studies];
  });
}

function grouped<K>(gates: readonly Gate[], key: (gate: Gate) => K): Map<K, Gate[]> {
  const out = new Map<K, Gate[]>();
  for (const gate of gates) {
    const group = out.get(key(gate));
    if (group) group.push(gate);
    else out.set(key(gate), [gate]);
  }
  return out;
}

const NO_TIMES: Times = { occasion: {}, seconds: null, plays: [] };

export function reportOf(results: Results, times: Times = NO_TIMES): Report {
  const engines = results.engines.map(engineOf);
  const named = new Map(engines.map((e) => [e.name, e]));
  const costs = new Map(times.plays.map((p) => [keyOf(p.case, p.run, p.variant, p.engine), p]));
  const cases = results.cases.map((c) => caseOf(c, costs));
  const gates = cases.flatMap((c) => c.runs.flatMap((run) => gatesOf(c, run, named)));
  const byCase = grouped(gates, (g) => g.caseOf);
  return { results, times, engines, cases, gates, byCase, byEngine: grouped(gates, (g) => g.engine) };
}

export const worst = (gates: readonly Gate[]): Gate | undefined =>
  gates.reduce<Gate | undefined>((a, b) => (a === undefined || b.ratio > a.ratio ? b : a), undefined);

/** How a gate stands, in a word or a number. */
export function useOfLimit(gate: Gate): string {
  if (gate.error === null) return 'not found';
  return gate.limit === 0 && gate.passes ? 'exact' : ratioText(gate.ratio);
}

/** How far an engine is right, where nothing is gated: best first. */
const ORDER: readonly GradeName[] = ['right', '0.1 %', '1 %', '5 %', 'wrong'];

export type Standing =
  | { kind: 'gated'; gates: Gate[]; failed: number; far: Gate }
  | { kind: 'graded'; grade: GradeName; of: number; worst: { run: Run; claim: RawClaim } }
  | { kind: 'not asked'; why: string };

/** How an engine stands on a case: its worst gate, its worst grade, or why it was not asked. */
export function standing(report: Report, c: Case, engine: Engine): Standing {
  const gates = (report.byCase.get(c) ?? []).filter((g) => g.engine === engine);
  const far = worst(gates);
  if (far) return { kind: 'gated', gates, failed: gates.filter((g) => !g.passes).length, far };
  const all = c.runs.flatMap((run) => run.claims.flatMap((claim) =>
    claim.judgements.filter((j) => j.engine === engine.name).map((j) => ({ run, claim, j }))));
  const graded = all.filter(({ j }) => j.state === 'judged' && j.grade)
    .sort((a, b) => ORDER.indexOf(b.j.grade!) - ORDER.indexOf(a.j.grade!));
  if (graded[0]) return { kind: 'graded', grade: graded[0].j.grade!, of: graded.length, worst: graded[0] };
  return { kind: 'not asked', why: all.find(({ j }) => j.why)?.j.why ?? 'not asked' };
}

/** A claim that something holds: its truth is 0 or 1, without a unit. */
export const asksYesNo = (c: RawClaim): boolean => c.unit === '' && (c.truth === 0 || c.truth === 1);

/** A claim that something holds is answered with yes or no. */
export function claimValue(value: number | null | undefined, claim: RawClaim): string {
  return typeof value === 'number' && asksYesNo(claim) ? (value ? 'yes' : 'no') : quantity(value, claim.unit, 5);
}

export function gateError(value: number | null, g: Gate): string {
  return g.claim.quantity === g.quantity && asksYesNo(g.claim) ? '–' : errorText(value, g.unit, g.relative);
}

/** Where an engine first parts from the truth by a tenth of the most that it ever does. */
function parting(run: Run, engine: Engine): number {
  const values = run.curve?.engines[engine.name];
  if (!run.curve || !values) return 0;
  const apart = values.map((v, k) => Math.abs((v ?? NaN) - (run.curve!.truth[k] ?? NaN)) || 0);
  const most = Math.max(...apart);
  return run.curve.t[apart.findIndex((d) => d > 0.1 * most)] ?? 0;
}

/** The instant to look at: the one that the claim names, that of the event, or where engine and truth part. */
export function instantOf({ claim, run, engine }: Gate): number {
  return claim.at ?? (claim.unit === 's' && claim.truth !== null ? claim.truth : parting(run, engine));
}

export const linkToGate = (g: Gate): string => linkTo(g.caseOf.id, g.run.index, g.engine.name, instantOf(g));

/** The engine to draw as a ghost over another: one that controls its error, if it played the run. */
export function ghostOf(report: Report, run: Run): Engine | undefined {
  return report.engines.find((e) => e.error_model === 'controlled' &&
    run.plays.some((p) => p.engine === e.name && p.recording));
}

export interface Bias {
  median: number;
  /** median absolute deviation */
  scatter: number;
  claims: number;
}

export interface EngineFigures {
  gates: number;
  failed: number;
  medianUse: number | null;
  bias: Record<string, Bias>;
  /** s: median of the runs' medians, and the largest 99th percentile */
  cost: { p50: number; p99: number } | null;
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  const k = sorted.length >> 1;
  return sorted.length % 2 ? sorted[k]! : (sorted[k - 1]! + sorted[k]!) / 2;
}

/** Of the values that the claims with this unit ask for, relative to the truth. */
function biasOf(report: Report, engine: Engine, unit: string): Bias | null {
  const relative = report.cases.flatMap((c) => c.runs.flatMap((r) => r.claims.flatMap((claim) => {
    const j = claim.judgements.find((x) => x.engine === engine.name && x.state === 'judged');
    return claim.unit === unit && claim.truth && j && typeof j.value === 'number' ? [j.value / claim.truth - 1] : [];
  })));
  if (relative.length < 3) return null;
  const middle = median(relative);
  return { median: middle, scatter: median(relative.map((r) => Math.abs(r - middle))), claims: relative.length };
}

export const BIAS_UNITS: readonly (readonly [string, string])[] = [['s', 'times'], ['m', 'lengths'], ['m/s', 'speeds']];

/** What stands above an engine's column. */
export function figuresOf(report: Report, engine: Engine): EngineFigures {
  const gates = report.byEngine.get(engine) ?? [];
  const plays = report.cases.flatMap((c) => c.runs.flatMap((r) => r.plays));
  const times = plays.filter((p) => p.engine === engine.name).flatMap((p) => p.frame_seconds ?? []);
  const measured = times.filter((f) => f.frames > 0 && f.p50 !== null && f.p99 !== null);
  const bias = BIAS_UNITS.flatMap(([unit]) => {
    const b = biasOf(report, engine, unit);
    return b ? [[unit, b] as const] : [];
  });
  return {
    gates: gates.length,
    failed: gates.filter((g) => !g.passes).length,
    medianUse: gates.length ? median(gates.map((g) => Math.min(g.ratio, 1e9))) : null,
    bias: Object.fromEntries(bias),
    cost: measured.length
      ? { p50: median(measured.map((f) => f.p50!)), p99: Math.max(...measured.map((f) => f.p99!)) } : null,
  };
}
