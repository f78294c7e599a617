// SPDX-License-Identifier: GPL-3.0-or-later
import { linkToGate, useOfLimit, type Engine, type Gate, type Report } from '../model';
import { LEAST, placeOfRatio, RATIO_TICKS } from './marks';
import { useWidth } from './time';

const PITCH = 5;

interface Dot {
  gate: Gate;
  x: number;
  y: number;
}

interface Axis {
  /** left edge of the zone below the axis, and of the one for what has no ratio */
  below: number;
  beyond: number;
  x: (ratio: number) => number;
  /** highest a pile of dots may be */
  height: number;
}

/** A pile a bin of the axis, and a block each for what is below it and what has no ratio. */
function dotsOf(gates: readonly Gate[], { below, beyond, x, height }: Axis): Dot[] {
  const piles = new Map<number, number>();
  const rows = Math.floor(height / PITCH);
  const limit = x(1);
  const blocks = { below: 0, beyond: 0 };
  const inBlock = (gate: Gate, n: number, left: number): Dot => ({
    gate, x: left + PITCH * Math.floor(n / rows), y: -PITCH * (n % rows),
  });
  const binOf = (g: Gate): number => Math.floor((x(g.ratio) - limit) / PITCH);
  const inside = (g: Gate): boolean => g.ratio >= LEAST && Number.isFinite(g.ratio);
  for (const g of gates) if (inside(g)) piles.set(binOf(g), (piles.get(binOf(g)) ?? 0) + 1);
  const squeeze = Math.min(1, height / (PITCH * Math.max(...piles.values(), 1)));
  piles.clear();
  return [...gates].sort((a, b) => a.ratio - b.ratio).map((gate) => {
    if (gate.ratio < LEAST) return inBlock(gate, blocks.below++, below);
    if (!Number.isFinite(gate.ratio)) return inBlock(gate, blocks.beyond++, beyond);
    const n = piles.get(binOf(gate)) ?? 0;
    piles.set(binOf(gate), n + 1);
    return { gate, x: limit + (binOf(gate) + 0.5) * PITCH, y: -PITCH * n * squeeze };
  });
}

function Mark({ gate, x, y, colour }: Dot & { colour: string }) {
  const title = `${gate.caseOf.id} ${gate.run.label}: ${gate.quantity}, ${useOfLimit(gate)}`;
  const open = (): void => { location.hash = linkToGate(gate); };
  const cross = `M${x - 2.5} ${y - 5.5}l5 5m0 -5l-5 5`;
  return (
    <g onClick={open}>
      <title>{title}</title>
      {gate.passes
        ? <circle cx={x} cy={y - 3} r="2.1" style={{ fill: `var(${colour})` }} />
        : <path class="failed" d={cross} />}
    </g>
  );
}

interface RowProps {
  engine: Engine;
  dots: Dot[];
  narrow: boolean;
}

function EngineRow({ engine, dots, narrow }: RowProps) {
  const held = dots.filter((d) => d.gate.passes).length;
  return (
    <g>
      <text y={narrow ? -68 : -16}>
        <tspan class="row-name">{engine.name}</tspan>
        <tspan {...(narrow ? { dx: 10 } : { x: 0, dy: 16 })}>{held} of {dots.length} hold</tspan>
      </text>
      {dots.map((dot) => <Mark {...dot} colour={engine.colour} />)}
    </g>
  );
}

function Ticks({ x, bottom, from }: { x: (ratio: number) => number; bottom: number; from: number }) {
  const label = (tick: number): string => (tick === 1 ? 'limit' : tick > 1 ? `${tick} ×` : `${tick * 100} %`);
  return (
    <>
      {RATIO_TICKS.filter((tick) => tick >= from).map((tick) => (
        <g class={tick === 1 ? 'limit' : 'tick'}>
          <line x1={x(tick)} x2={x(tick)} y1="0" y2={bottom + 4} />
          <text x={x(tick)} y={bottom + 18} text-anchor="middle">{label(tick)}</text>
        </g>
      ))}
    </>
  );
}

/** Every gate as a dot by how much of its limit it uses, an engine a row. */
export function GateDots({ report }: { report: Report }) {
  const [ref, width] = useWidth<HTMLDivElement>();
  const rows = [...report.byEngine];
  const narrow = width < 700;
  const row = narrow ? 84 : 72;
  const name = narrow ? 0 : 150;
  const beyond = 60;
  const left = name + (narrow ? 56 : 84);
  const inner = Math.max(10, width - left - beyond);
  const bottom = rows.length * row;
  const x = (ratio: number): number => left + inner * placeOfRatio(ratio);
  const axis = { below: name + 4, beyond: width - beyond + 22, x, height: narrow ? 60 : 64 };
  if (rows.length === 0) return null;
  return (
    <div class="gate-dots" ref={ref} style={{ minHeight: `${bottom + 28}px` }}>
      {width > 0 && (
        <svg width={width} height={bottom + 28} role="img"
          aria-label="Every gate by the share of its limit that it uses; the tables below say the same">
          <rect class="beyond" x={x(1)} y="0" width={Math.max(0, width - x(1))} height={bottom} />
          <Ticks x={x} bottom={bottom} from={narrow ? 0.01 : 0} />
          <text x={name + 2} y={bottom + 18}>{`< ${LEAST * 100} %`}</text>
          <text x={width} y={bottom + 18} text-anchor="end">{narrow ? 'missing' : 'missing, wrong'}</text>
          {rows.map(([engine, gates], i) => (
            <g transform={`translate(0,${(i + 1) * row - 4})`}>
              <line class="base" x1={name} x2={width} y1="0.5" y2="0.5" />
              <EngineRow engine={engine} dots={dotsOf(gates, axis)} narrow={narrow} />
            </g>
          ))}
        </svg>
      )}
    </div>
  );
}
