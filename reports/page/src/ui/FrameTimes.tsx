// SPDX-License-Identifier: GPL-3.0-or-later
import { quantity } from '../format';
import type { Engine, Play } from '../model';
import type { Played } from './Strips';
import { useWidth } from './time';

const LOW = -6;
const HIGH = -0.9;
const BINS = 40;
const TICKS = [1e-6, 1e-5, 1e-4, 1e-3, 1e-1] as const;

interface Row {
  engine: Engine;
  p50: number;
  p99: number;
  /** s, of every frame; empty without a recording */
  times: number[];
}

function rowsOf(engines: readonly Engine[], plays: readonly Play[], played: readonly Played[]): Row[] {
  return engines.flatMap((engine) => {
    const of = plays.find((p) => p.engine === engine.name)?.frame_seconds;
    const recording = played.find((p) => p.engine === engine)?.recording;
    if (!of || of.frames === 0 || of.p50 === null || of.p99 === null) return [];
    return [{ engine, p50: of.p50, p99: of.p99, times: Array.from(recording?.frameTimes?.slice(1) ?? []) }];
  });
}

/** s a frame, as an engine's settings say it ("frame rate": "90 Hz"). */
export function frameBudget(engines: readonly Engine[]): number {
  const rates = engines.map((e) => Number.parseFloat(e.settings['frame rate'] ?? '')).filter((hertz) => hertz > 0);
  return 1 / (rates[0] ?? 90);
}

interface Layout {
  left: number;
  inner: number;
  most: number;
  x: (seconds: number) => number;
}

function Histogram({ times, base, colour, layout }: { times: number[]; base: number; colour: string; layout: Layout }) {
  const { left, inner, most, x } = layout;
  const bins = new Array<number>(BINS).fill(0);
  const binOf = (s: number): number => Math.min(BINS - 1, Math.max(0, Math.floor(((x(s) - left) / inner) * BINS)));
  for (const s of times) ++bins[binOf(s)]!;
  const peak = Math.max(...bins, 1);
  const w = inner / BINS;
  return (
    <g style={{ fill: `var(${colour})` }}>
      {bins.map((n, b) => n > 0 && (
        <rect x={left + b * w + 0.5} width={w - 1} y={base - (n / peak) * most} height={(n / peak) * most} />
      ))}
    </g>
  );
}

interface Props {
  engines: readonly Engine[];
  plays: readonly Play[];
  played: readonly Played[];
  budget: number;
}

/** CPU time of the frames on a log axis, an engine a row, against the budget of a frame. */
export function FrameTimes({ engines, plays, played, budget }: Props) {
  const [ref, width] = useWidth<HTMLDivElement>();
  const rows = rowsOf(engines, plays, played);
  if (rows.length === 0) return <p class="absent">No engine of this run recorded what its frames cost.</p>;
  const narrow = width < 480;
  const left = narrow ? 4 : 168;
  const row = narrow ? 76 : 54;
  const inner = Math.max(1, width - left - 24);
  const bottom = rows.length * row;
  const x = (s: number): number => left + ((Math.log10(Math.max(s, 1e-6)) - LOW) / (HIGH - LOW)) * inner;
  const layout: Layout = { left, inner, most: row - (narrow ? 34 : 16), x };
  const text = (s: number): string => quantity(s, 's', 2);
  return (
    <div class="frame-times" ref={ref} style={{ minHeight: `${bottom + 24}px` }}>
      {width > 0 && (
        <svg width={width} height={bottom + 24} role="img"
          aria-label={`CPU time a frame: ${rows.map((r) => `${r.engine.name} median ${text(r.p50)}`).join('; ')}`}>
          {TICKS.map((tick) => (
            <g class="tick">
              <line x1={x(tick)} x2={x(tick)} y1="0" y2={bottom} />
              <text x={x(tick)} y={bottom + 16} text-anchor="middle">{quantity(tick, 's', 1)}</text>
            </g>
          ))}
          <g class="limit">
            <line x1={x(budget)} x2={x(budget)} y1="0" y2={bottom} />
            <text x={x(budget)} y={bottom + 16} text-anchor="middle">
              {`${narrow ? '' : 'budget '}${quantity(budget, 's', 3)}`}
            </text>
          </g>
          {rows.map(({ engine, p50, p99, times }, i) => {
            const base = (i + 1) * row - 4;
            const name = narrow ? base - layout.most - 10 : base - 16;
            return (
              <g>
                <text class="row-name" x="0" y={name}>{engine.name}</text>
                <text class="row-note" x={narrow ? 124 : 0} y={narrow ? name : base}>
                  {`p50 ${text(p50)}, p99 ${text(p99)}`}
                </text>
                <Histogram times={times} base={base} colour={engine.colour} layout={layout} />
                {[p50, p99].map((s, k) => (
                  <line class={`quantile q${k}`} x1={x(s)} x2={x(s)} y1={base - layout.most} y2={base} />
                ))}
                <line class="base" x1={left} x2={left + inner} y1={base} y2={base} />
              </g>
            );
          })}
        </svg>
      )}
    </div>
  );
}
