/** results.json, version 2, as the program writes it. Numbers that are not finite are null with a key `..._text`. */
export interface RawVerdict {
  passed: boolean;
  sentence: string;
  interrupted: boolean;
  gates: number;
  failed: number;
  vacuous: number;
  not_asked: number;
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
  why?: string;
  value: number | null;
  error: number | null;
  limit: number | null;
  reason: string;
  vacuous: boolean;
  passes: boolean;
  sentence: string;
  grade?: GradeName | null;
}

export interface RawStudy {
  engine: string;
  substep: number[];
  error: (number | null)[];
  slope: number | null;
  standard_error: number | null;
  passes: boolean;
  limit: number;
  reason: string;
  sentence: string;
}

export interface RawClaim {
  quantity: string;
  unit: string;
  truth: number | null;
  pedigree: string;
  source: string;
  relative: boolean;
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
  outcome: string;
  note: string;
  seconds: number | null;
  frame_seconds?: FrameSeconds | null;
  recording?: string | null;
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
  seconds: number | null;
  engines: RawEngine[];
  cases: RawCase[];
}

const FORMAT = 'handhold results';
const VERSION = 2;

/** The results, or an error in words that says what to do. */
export function checked(data: unknown): Results {
  const results = data as Results;
  if (results?.format !== FORMAT) throw new Error('these are no results of handhold (make the page with `handhold report`)');
  if (results.version !== VERSION) {
    const same = 'make the page with the program that wrote the results';
    throw new Error(`this page reads results of version ${VERSION}, and these are of version ${results.version} (${same})`);
  }
  return results;
}
