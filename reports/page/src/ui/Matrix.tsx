// SPDX-License-Identifier: GPL-3.0-or-later
import { quantity, ratioText, share } from '../format';
import {
  BIAS_UNITS, figuresOf, linkToGate, standing, useOfLimit, type Case, type Engine, type EngineFigures, type Report,
} from '../model';
import { linkTo } from '../route';
import { LimitBar, Sign, STATES, Swatch, type State } from './marks';

/** More engines than this, and the cells have no bars. */
const WITH_BARS = 4;

/** The case's own curve, small: what to recognise it by. */
function Sparkline({ of: c }: { of: Case }) {
  const curve = c.runs.find((r) => r.curve)?.curve;
  const truth = curve?.truth.filter((v): v is number => v !== null) ?? [];
  if (!curve || truth.length < 2) return null;
  const lo = Math.min(...truth);
  const span = Math.max(...truth) - lo || 1;
  const end = curve.t[truth.length - 1] || 1;
  const place = (v: number, k: number): string =>
    `${(1 + (70 * curve.t[k]!) / end).toFixed(1)},${(18 - (16 * (v - lo)) / span).toFixed(1)}`;
  const points = truth.map(place).join(' ');
  return <svg class="spark" width="72" height="20" aria-hidden="true"><polyline points={points} /></svg>;
}

function Cell({ report, of: c, engine }: { report: Report; of: Case; engine: Engine }) {
  const s = standing(report, c, engine);
  if (s.kind === 'not asked') return <td class="cell none" title={s.why}><Sign state="none" spoken /></td>;
  const state: State = s.kind === 'graded' ? s.grade : s.failed ? 'fails' : 'holds';
  const far = s.kind === 'gated' ? s.far : null;
  const href = far ? linkToGate(far) : linkTo(c.id, s.kind === 'graded' ? s.worst.run.index : 0, engine.name);
  const short = s.kind === 'graded' ? s.grade : s.failed ? `${s.failed} of ${s.gates.length}` : useOfLimit(s.far);
  const words = far ? `worst ${useOfLimit(far)} of its limit` : `the worst of ${s.kind === 'graded' ? s.of : 0} claims`;
  return (
    <td class={`cell ${STATES[state].style}`}>
      <a href={href} aria-label={`${c.id}, ${engine.name}: ${STATES[state].word}, ${short}, ${words}`}>
        <Sign state={state} />{far && <LimitBar gate={far} />}<span class="short">{short}</span>
      </a>
    </td>
  );
}

function biasText(f: EngineFigures, unit: string): string {
  const b = f.bias[unit];
  if (!b) return '–';
  return Math.abs(b.median) + b.scatter < 1e-7 ? '< 0.1 ppm' : `${share(b.median)} ± ${share(b.scatter)}`;
}

interface Row {
  name: string;
  at: (f: EngineFigures, engine: Engine) => string;
}

/** What stands above the columns: an engine in figures. */
const ROWS: readonly Row[] = [
  { name: 'gates that hold', at: (f) => (f.gates ? `${f.gates - f.failed} of ${f.gates}` : 'graded, not gated') },
  { name: 'median use of the limit', at: (f) => (f.medianUse === null ? '–' : ratioText(f.medianUse)) },
  ...BIAS_UNITS.map(([unit, name]): Row => ({
    name: `bias of ${name}, median ± m.a.d.`, at: (f) => biasText(f, unit),
  })),
  {
    name: 'CPU a frame, p50 · worst p99',
    at: (f) => (f.cost ? `${quantity(f.cost.p50, 's', 2)} · ${quantity(f.cost.p99, 's', 2)}` : 'not recorded'),
  },
];

const ERRS = { controlled: 'error control', stepped: 'fixed step', foreign: 'foreign' } as const;

function EngineHead({ engine }: { engine: Engine }) {
  const settings = Object.entries(engine.settings).map(([key, value]) => `${key}: ${value}`).join('\n');
  return (
    <th scope="col" title={settings}>
      <Swatch engine={engine} />{engine.name}
      <span>{[engine.version, engine.levels.join(', '), ERRS[engine.error_model]].filter(Boolean).join(' · ')}</span>
    </th>
  );
}

const LEVELS: Record<string, string> = {
  L1: 'L1, rigid Coulomb friction', L2: 'L2, compliant contact', L3: 'L3, the discrete law as printed',
};

function byLevel(cases: readonly Case[]): [string, Case[]][] {
  const out = new Map<string, Case[]>();
  for (const c of cases) {
    const level = LEVELS[c.level.slice(0, 2)] ?? c.level;
    out.set(level, [...(out.get(level) ?? []), c]);
  }
  return [...out];
}

function Intro({ report }: { report: Report }) {
  const graded = report.engines.some((e) => !e.gated);
  return (
    <p class="intro">
      A mark is the worst gate of a case, from nothing to its limit (the line) and beyond; ✓ holds, ✗ fails.
      {graded && ' Engines that nobody derived a limit for are graded: '}
      {graded && '●●● right to 0.1 %, ●●○ to 1 %, ●○○ to 5 %, ✗ wrong.'}
      {' '}Choose a cell to see the case.
    </p>
  );
}

export function Matrix({ report, chosen }: { report: Report; chosen: string }) {
  const { engines } = report;
  const figures = engines.map((e) => figuresOf(report, e));
  return (
    <section id="engines" aria-labelledby="engines-title">
      <h2 id="engines-title">Engines side by side</h2>
      <Intro report={report} />
      <div class="scroll" role="region" aria-label="Cases by engines" tabIndex={0}>
        <table class={`matrix ${engines.length > WITH_BARS ? 'many' : ''}`}>
          <thead><tr><th scope="col">case</th>{engines.map((e) => <EngineHead engine={e} />)}</tr></thead>
          <tbody>
            {ROWS.map((row) => (
              <tr class="figures">
                <th scope="row">{row.name}</th>
                {engines.map((e, i) => <td>{row.at(figures[i]!, e)}</td>)}
              </tr>
            ))}
          </tbody>
          {byLevel(report.cases).map(([level, cases]) => (
            <tbody>
              <tr class="family"><th scope="rowgroup" colSpan={1 + engines.length}>{level}</th></tr>
              {cases.map((c) => (
                <tr class={c.id === chosen ? 'chosen' : ''}>
                  <th scope="row">
                    <div><a href={linkTo(c.id)}><b>{c.id}</b><span>{c.title}</span></a><Sparkline of={c} /></div>
                  </th>
                  {engines.map((e) => <Cell report={report} of={c} engine={e} />)}
                </tr>
              ))}
            </tbody>
          ))}
        </table>
      </div>
    </section>
  );
}
