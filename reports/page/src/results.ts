// SPDX-License-Identifier: GPL-3.0-or-later
/** results.json, version 2, and times.json, as the program writes them. Numbers that are not finite are null. */
export interface RawVerdict {
  passed: boolean;
  sentence: string;
  interrupted: boolean;
  gates: number;
  failed: number;
  vacuous: number;
  not_asked: number;
  graded?: number;
}

export interface RawEngine {
  name: string;
  version: string;
  levels: string[];
  error_model: 'controlled' | 'stepped' | 'foreign';
  gated: boolean;
  records: string[];
  settings: Record<string, string>;
}

export type GradeName = '0.1 %' | '1 %' | '5 %' | 'wrong' | 'right';

export interface RawJudgement {
  engine: string;
  state: 'judged' | 'not asked';
  /** not asked: why */
  why?: string;
  value?: number | null;
  error?: number | null;
  /** the error is |value / truth - 1|, else |value - truth| */
  relative?: boolean;
  /** of a gate; absent where nothing is gated, null where it is not finite */
  limit?: number | null;
  reason?: string;
  vacuous?: boolean;
  passes?: boolean;
  sentence?: string;
  grade?: GradeName | null;
}

export interface RawStudy {
  engine: string;
  step: number[];
  error: (number | null)[];
  slope: number | null;
  standard_error: number | null;
  slack?: number | null;
  vacuous?: boolean;
  passes: boolean;
  limit: number | null;
  reason: string;
  sentence: string;
}

export interface RawClaim {
  quantity: string;
  unit: string;
  truth: number | null;
  pedigree: string;
  source: string;
  /** the instant that the claim names, s */
  at?: number | null;
  judgements: RawJudgement[];
  studies?: RawStudy[];
}

export type Series = (number | null)[];

export interface RawCurve {
  label: string;
  unit?: string;
  t: number[];
  truth: Series;
  engines: Record<string, Series>;
}

export interface FrameSeconds {
  frames: number;
  p50: number | null;
  p90: number | null;
  p99: number | null;
  p999: number | null;
  max: number | null;
}

export interface RawPlay {
  engine: string;
  /** not asked, and why */
  why?: string;
  /** how it ended, when not complete */
  note: string;
}

export interface RawRun {
  name: string;
  variant?: string;
  claims: RawClaim[];
  curve?: RawCurve | null;
  plays?: RawPlay[];
}

export interface RawCase {
  id: string;
  title: string;
  level: string;
  truth_level?: string;
  statement: string;
  formula: string;
  note: string;
  runs: RawRun[];
}

export interface Results {
  format: string;
  version: number;
  verdict: RawVerdict;
  provenance: Record<string, string>;
  engines: RawEngine[];
  cases: RawCase[];
  /** What differs from the baseline; absent: compared with none. */
  moved?: { sentence: string }[];
}

/** What one engine's play of a run cost, and the recording of it that this page carries. */
export interface PlayTimes {
  case: string;
  run: string;
  variant: string;
  engine: string;
  seconds: number | null;
  frame_seconds: FrameSeconds | null;
  recording?: string;
}

export interface Times {
  occasion: Record<string, string>;
  seconds: number | null;
  plays: PlayTimes[];
}

const FORMAT = 'handhold results';
const VERSION = 2;

/** The results, or an error in words that says what to do. */
export function checked(data: unknown): Results {
  const results = data as Results;
  if (results?.format !== FORMAT) {
    throw new Error('these are no results of handhold (make the page with `handhold report`)');
  }
  if (results.version !== VERSION) {
    const same = 'make the page with the program that wrote the results';
    const reads = `this page reads results of version ${VERSION}`;
    throw new Error(`${reads}, and these are of version ${results.version} (${same})`);
  }
  return results;
}
