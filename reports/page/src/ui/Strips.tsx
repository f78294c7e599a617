// SPDX-License-Identifier: GPL-3.0-or-later
import { useMemo } from 'preact/hooks';
import { capital, prefixFor, quantity } from '../format';
import type { Engine } from '../model';
import { sample, type Recording } from '../packed';
import type { RawCurve, Series } from '../results';
import { Swatch } from './marks';
import { Plot, type Line } from './Plot';
import { Readout } from './time';

export interface Played {
  engine: Engine;
  recording: Recording;
}

interface Key {
  engine?: Engine;
  colour?: string;
  name: string;
  at: (t: number) => string;
}

/** Title of a strip and, beside each line's name, its value at the cursor. */
export function StripHead({ title, unit, keys }: { title: string; unit: string; keys: readonly Key[] }) {
  return (
    <div class="strip-head">
      <h3>{title}{unit && <span class="unit">, {unit}</span>}</h3>
      <ul class="keys">
        {keys.map((k) => (
          <li>
            {k.engine && <Swatch engine={k.engine} />}
            {k.colour && <i class="swatch" style={{ background: `var(${k.colour})` }} aria-hidden="true" />}
            {k.name} <Readout at={k.at} />
          </li>
        ))}
      </ul>
    </div>
  );
}

const largest = (values: Series): number => values.reduce<number>((most, v) => Math.max(most, Math.abs(v ?? 0)), 0);
const scaled = (values: Series, by: number): Series => values.map((v) => (v === null ? null : v / by));

function valueAt(t: ArrayLike<number>, values: ArrayLike<number | null>, unit: string, significant = 3) {
  return (at: number): string => {
    const v = sample(t, values, at);
    return Number.isNaN(v) ? '–' : quantity(v, unit, significant);
  };
}

/** "slip [m]" and "slip" with the unit beside it, both. */
export function labelOf(curve: RawCurve): { title: string; unit: string } {
  const [, title = curve.label, unit = ''] = /^(.*) \[(.*)\]$/.exec(curve.label) ?? [];
  return { title, unit: curve.unit ?? unit };
}

interface CurveProps {
  curve: RawCurve;
  engines: readonly Engine[];
  end: number;
  chosen: string;
  theme: string;
}

/** What the case is about: every engine against the truth, and below what is left over. */
export function CurveStrips({ curve, engines, end, chosen, theme }: CurveProps) {
  const { title, unit } = labelOf(curve);
  const drawn = useMemo(() => engines.flatMap((engine) => {
    const values = curve.engines[engine.name];
    if (!values) return [];
    const residual = values.map((v, k) => (v === null || curve.truth[k] == null ? null : v - curve.truth[k]));
    return [{ engine, values, residual }];
  }), [curve, engines]);
  const scale = prefixFor(largest(curve.truth), unit);
  const rest = prefixFor(Math.max(0, ...drawn.map((d) => largest(d.residual))), unit);
  const [above, below] = useMemo(() => {
    const lineOf = ({ engine }: { engine: Engine }, values: Series): Line => ({
      label: engine.name, colour: engine.colour, dash: engine.dash, width: engine.name === chosen ? 2.25 : 1.25, values,
    });
    const truth: Line = { label: 'truth', colour: '--truth', width: 5, values: scaled(curve.truth, scale.factor) };
    return [
      [truth, ...drawn.map((d) => lineOf(d, scaled(d.values, scale.factor)))],
      drawn.map((d) => lineOf(d, scaled(d.residual, rest.factor))),
    ];
  }, [drawn, chosen]);
  const names = drawn.map((d) => d.engine.name).join(', ');
  const keys = drawn.map((d): Key => ({ engine: d.engine, name: d.engine.name, at: valueAt(curve.t, d.values, unit) }));
  const left = drawn.map((d): Key => ({
    engine: d.engine, name: d.engine.name, at: valueAt(curve.t, d.residual, unit, 2),
  }));
  return (
    <>
      <StripHead title={capital(title)} unit={scale.unit}
        keys={[{ colour: '--truth', name: 'truth', at: valueAt(curve.t, curve.truth, unit) }, ...keys]} />
      <Plot t={curve.t} end={end} lines={above} height={190} theme={theme}
        label={`${title} against time: the truth and ${names}`} />
      <StripHead title="Engine − truth" unit={rest.unit} keys={left} />
      <Plot t={curve.t} end={end} lines={below} height={92} theme={theme} symmetric
        label={`What is left of ${title}, engine minus truth, against time`} />
    </>
  );
}

function height({ recording }: Played): number[] {
  const z = recording.bodyPoses[0]![2]!;
  return Array.from(z, (v) => v - z[0]!);
}

/** Degrees from the attitude at the start. */
function tilt({ recording }: Played): number[] {
  const pose = recording.bodyPoses[0]!;
  return Array.from(pose[3]!, (_, k) => {
    const dot = [3, 4, 5, 6].reduce((sum, i) => sum + pose[i]![k]! * pose[i]![0]!, 0);
    return (360 / Math.PI) * Math.acos(Math.min(1, Math.abs(dot)));
  });
}

interface ObjectRow {
  title: string;
  unit: string;
  of: (played: Played) => number[];
  /** below this, the strip would show nothing but rounding */
  least: number;
}

const OBJECT_ROWS: readonly ObjectRow[] = [
  { title: 'Object height', unit: 'm', of: height, least: 1e-6 },
  { title: 'Object tilt', unit: '°', of: tilt, least: 0.05 },
];

function ObjectStrip({ row, played, end, theme }: { row: ObjectRow; played: Played[]; end: number; theme: string }) {
  const { values, scale, lines, size } = useMemo(() => {
    const all = played.map(row.of);
    const most = Math.max(...all.map(largest));
    const by = row.unit === 'm' ? prefixFor(most, 'm') : { factor: 1, unit: '°' };
    return {
      values: all, scale: by, size: most,
      lines: played.map(({ engine }, i): Line => ({
        label: engine.name, colour: engine.colour, dash: engine.dash, values: scaled(all[i]!, by.factor),
        width: i === 0 ? 2 : 1.25,
      })),
    };
  }, [played]);
  if (size < row.least) return null;
  const keys = played.map(({ engine, recording }, i): Key => ({
    engine, name: engine.name, at: valueAt(recording.t, values[i]!, row.unit),
  }));
  // Engines that end early have fewer frames: the longest gives the instants.
  const t = played.map((p) => p.recording.t).reduce((a, b) => (b.length > a.length ? b : a));
  return (
    <>
      <StripHead title={row.title} unit={scale.unit} keys={keys} />
      <Plot t={t} end={end} lines={lines} height={84} theme={theme} label={`${row.title} against time`} />
    </>
  );
}

/** Height and tilt of the first object, chosen engine over the ghost. */
export function ObjectStrips({ played, end, theme }: { played: Played[]; end: number; theme: string }) {
  if (!played[0]?.recording.bodyPoses.length) return null;
  return <>{OBJECT_ROWS.map((row) => <ObjectStrip row={row} played={played} end={end} theme={theme} />)}</>;
}

const LEDGER = ['kinetic', 'potential', 'elastic', 'dissipated', 'work of the hand'] as const;

interface EnergyProps {
  played: Played;
  end: number;
  theme: string;
}

/** The energy ledger of the chosen engine; what does not balance is an error of the engine. */
export function EnergyStrip({ played: { engine, recording }, end, theme }: EnergyProps) {
  const { energies, t } = recording;
  const book = energies.slice(0, LEDGER.length);
  const scale = prefixFor(Math.max(0, ...book.map((c) => largest(Array.from(c)))), 'J');
  const lines = useMemo(() => book.map((values, i): Line => ({
    label: LEDGER[i]!, colour: `--energy-${i}`, values: Array.from(values, (v) => v / scale.factor),
  })), [recording]);
  if (energies.length === 0) return <p class="absent">{engine.name} records no energies.</p>;
  const keys = LEDGER.map((name, i): Key => ({
    colour: `--energy-${i}`, name, at: valueAt(t, energies[i]!, 'J', 2),
  }));
  return (
    <>
      <StripHead title={`Energy ledger, ${engine.name}`} unit={scale.unit}
        keys={[...keys, { name: 'unexplained', at: valueAt(t, energies[LEDGER.length]!, 'J', 2) }]} />
      <Plot t={t} end={end} lines={lines} height={110} theme={theme} label="Energies against time" />
    </>
  );
}
