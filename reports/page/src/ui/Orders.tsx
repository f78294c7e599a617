// SPDX-License-Identifier: GPL-3.0-or-later
import { digits, quantity } from '../format';
import type { Report, Run } from '../model';
import type { RawClaim, RawStudy } from '../results';
import { Sign } from './marks';

const W = 300;
const H = 170;
const LEFT = 58;
const BOTTOM = 34;

interface Point {
  substep: number;
  x: number;
  y: number;
}

/** Log-log places of the errors that are known and not zero. */
function pointsOf(study: RawStudy): Point[] {
  return study.step.flatMap((substep, i) => {
    const error = study.error[i];
    return error ? [{ substep, x: Math.log10(substep), y: Math.log10(Math.abs(error)) }] : [];
  });
}

function OrderPlot({ study, claim, colour }: { study: RawStudy; claim: RawClaim; colour: string }) {
  const points = pointsOf(study);
  if (points.length < 2) return <p class="absent">{claim.quantity}: too few errors to tell an order from.</p>;
  const xs = points.map((p) => p.x);
  const ys = points.map((p) => p.y);
  const [x0, x1] = [Math.min(...xs) - 0.15, Math.max(...xs) + 0.15];
  const [y0, y1] = [Math.min(...ys) - 0.2, Math.max(...ys) + 0.2];
  const x = (v: number): number => LEFT + ((v - x0) / (x1 - x0)) * (W - LEFT - 10);
  const y = (v: number): number => 8 + ((y1 - v) / (y1 - y0)) * (H - BOTTOM - 8);
  const decades = Array.from({ length: Math.max(0, Math.floor(y1) - Math.ceil(y0) + 1) }, (_, i) => Math.ceil(y0) + i);
  const rows = decades.length >= 2 ? decades : [Math.max(...ys), Math.min(...ys)];
  const first = points[0]!;
  const guide = [first.x, xs.at(-1)!].map((v) => `${x(v)},${y(first.y + (v - first.x))}`).join(' ');
  const slope = study.slope === null ? 'not found' : study.slope.toFixed(3);
  return (
    <figure class="order">
      <svg viewBox={`0 0 ${W} ${H}`} role="img"
        aria-label={`${claim.quantity}: error against sub-step, slope ${slope}`}>
        {rows.map((d) => (
          <g class="tick">
            <line x1={LEFT} x2={W - 10} y1={y(d)} y2={y(d)} />
            <text x={LEFT - 6} y={y(d) + 4} text-anchor="end">{quantity(10 ** d, claim.unit, 2)}</text>
          </g>
        ))}
        {points.map((p, i) => (
          <g class="tick">
            <line x1={x(p.x)} x2={x(p.x)} y1="8" y2={H - BOTTOM} />
            <text x={x(p.x)} y={H - BOTTOM + 15} text-anchor="middle">{i % 2 ? '' : quantity(p.substep, 's', 2)}</text>
          </g>
        ))}
        <polyline class="guide" points={guide} />
        {points.map((p) => <circle cx={x(p.x)} cy={y(p.y)} r="4" style={{ fill: `var(${colour})` }} />)}
        <text class="axis" x={(LEFT + W - 10) / 2} y={H - 2} text-anchor="middle">sub-step</text>
      </svg>
      <figcaption>
        <Sign state={study.passes ? 'holds' : 'fails'} spoken />{claim.quantity}, {study.engine}: order <b>{slope}</b>
        {study.standard_error !== null && ` ± ${digits(study.standard_error, 1)}`}; dashed: order 1
      </figcaption>
    </figure>
  );
}

/** Error against sub-step, log-log, with a line of slope one to compare. */
export function Orders({ report, run }: { report: Report; run: Run }) {
  const studies = run.claims.flatMap((claim) => (claim.studies ?? []).map((study) => ({ claim, study })));
  if (studies.length === 0) return <p class="absent">No study of the order for this run.</p>;
  return (
    <div class="orders">
      {studies.map(({ claim, study }) => {
        const colour = report.engines.find((e) => e.name === study.engine)?.colour ?? '--ink';
        return <OrderPlot claim={claim} study={study} colour={colour} />;
      })}
    </div>
  );
}
