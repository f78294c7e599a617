// SPDX-License-Identifier: GPL-3.0-or-later
import type { Engine, Gate } from '../model';
import type { GradeName } from '../results';
import { useOfLimit } from '../model';

/** Every state has a sign, a colour and a word. */
export type State = 'holds' | 'fails' | 'none' | 'vacuous' | GradeName;
export const STATES: Record<State, { sign: string; word: string; style: string }> = {
  holds: { sign: '✓', word: 'holds', style: 'holds' },
  fails: { sign: '✗', word: 'fails', style: 'fails' },
  vacuous: { sign: '○', word: 'holds, but its limit guards nothing', style: 'vacuous' },
  none: { sign: '–', word: 'not asked', style: 'none' },
  right: { sign: '✓', word: 'right', style: 'holds' },
  '0.1 %': { sign: '●●●', word: 'right to 0.1 %', style: 'holds' },
  '1 %': { sign: '●●○', word: 'right to 1 %', style: 'fair' },
  '5 %': { sign: '●○○', word: 'right to 5 %', style: 'poor' },
  wrong: { sign: '✗', word: 'wrong', style: 'fails' },
};

export function Sign({ state, spoken = false }: { state: State; spoken?: boolean }) {
  const { sign, word, style } = STATES[state];
  return (
    <>
      <span class={`sign-of sign-${style}`} aria-hidden="true">{sign}</span>
      {spoken && <span class="visually-hidden">{word}</span>}
    </>
  );
}

/** An engine's line as in the curves: colour and dash. */
export function Swatch({ engine }: { engine: Engine }) {
  const [on = 0, off = 0] = engine.dash;
  const dash = engine.dash.length
    ? `repeating-linear-gradient(90deg, var(${engine.colour}) 0 ${on}px, transparent ${on}px ${on + off}px)` : '';
  return <i class="swatch" style={{ background: dash || `var(${engine.colour})` }} aria-hidden="true" />;
}

const LOW = -4;
const HIGH = 1.5;
/** Share of a limit below which a log axis does not tell; such gates have a zone of their own. */
export const LEAST = 10 ** LOW;
export const RATIO_TICKS = [1e-3, 1e-2, 1e-1, 1, 10] as const;

/** Place of error / limit on a log axis from 1/10000 to 30: 0 to 1. */
export function placeOfRatio(ratio: number): number {
  return Math.min(1, Math.max(0, (Math.log10(Math.max(ratio, 1e-12)) - LOW) / (HIGH - LOW)));
}

const LIMIT_AT = 0.64;
const MOST = 30;

/** Place on a bar: linear up to the limit, logarithmic beyond it. */
function placeOnBar(ratio: number): number {
  if (ratio <= 1) return LIMIT_AT * ratio;
  return LIMIT_AT + (1 - LIMIT_AT) * Math.min(1, 0.12 + (0.88 * Math.log(ratio)) / Math.log(MOST));
}

/** Error over limit as a bar from zero; the limit is a line across it, what lies beyond ends in a cross. */
export function LimitBar({ gate, width = 112 }: { gate: Gate; width?: number }) {
  const inner = width - 8;
  const end = 1 + inner * placeOnBar(gate.ratio);
  const limit = 1 + inner * LIMIT_AT;
  const missing = gate.error === null;
  return (
    <span class="limit-bar">
      <svg class={gate.passes ? '' : 'failed'} width={width} height="16" aria-hidden="true">
        <rect class="track" x="1" width={inner * LIMIT_AT} y="5" height="6" />
        <rect class="beyond" x={limit} width={inner - limit + 5} y="5" height="6" />
        {missing
          ? <line class="missing" x1="1" x2={end} y1="8" y2="8" />
          : <rect class="reach" x="1" width={Math.max(1.5, end - 1)} y="5" height="6" />}
        <line class="limit" x1={limit} x2={limit} y1="1" y2="15" />
        {!gate.passes && <path d={`M${end - 3.5} 4.5l7 7m0 -7l-7 7`} />}
      </svg>
      <span class="ratio">{useOfLimit(gate)}</span>
    </span>
  );
}
