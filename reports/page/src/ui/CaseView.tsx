// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import formulas from 'page:formulas';
import type { Clock } from '../clock';
import { ghostOf, type Case, type Engine, type Gate, type Report, type Run } from '../model';
import { linkTo, type Route } from '../route';
import { Claims } from './Claims';
import { frameBudget, FrameTimes } from './FrameTimes';
import { Sign, Swatch, type State } from './marks';
import { Orders } from './Orders';
import { Prose } from './Prose';
import { useRecordings, type Loaded } from './recordings';
import { SceneView, type SceneOptions } from './SceneView';
import { CurveStrips, EnergyStrip, ObjectStrips, type Played } from './Strips';
import { Timeline } from './Timeline';
import { Scrubber, TimeAxis, TimeStack, Transport } from './time';

/** True from the first time that the element comes near the window. */
function useNear(): [{ current: HTMLElement | null }, boolean] {
  const ref = useRef<HTMLElement>(null);
  const [near, setNear] = useState(false);
  useEffect(() => {
    const see = ([entry]: IntersectionObserverEntry[]): void => { if (entry?.isIntersecting) setNear(true); };
    const observer = new IntersectionObserver(see, { rootMargin: '300px' });
    observer.observe(ref.current!);
    return () => observer.disconnect();
  }, []);
  return [ref, near];
}

interface Option {
  name: string;
  href: string;
  on: boolean;
  state: State;
  engine?: Engine;
}

function stateOf(gates: readonly Gate[]): State {
  if (gates.length === 0) return 'none';
  return gates.every((g) => g.passes) ? 'holds' : 'fails';
}

/** Links that choose; the history keeps only where one came from. */
function Choice({ legend, options }: { legend: string; options: Option[] }) {
  const choose = (event: Event, href: string): void => {
    event.preventDefault();
    history.replaceState(null, '', href);
    dispatchEvent(new HashChangeEvent('hashchange'));
  };
  return (
    <nav class="choice" aria-label={legend}>
      {options.map((o) => (
        <a href={o.href} aria-current={o.on ? 'true' : undefined} onClick={(e) => choose(e, o.href)}>
          {o.engine ? <><Swatch engine={o.engine} />{o.name}</> : <Prose text={o.name} />}
          {o.state !== 'none' && <>{' '}<Sign state={o.state} spoken /></>}
        </a>
      ))}
    </nav>
  );
}

interface HeadProps {
  report: Report;
  c: Case;
  run: Run;
  chosen: string;
  clock: Clock;
}

function CaseHead({ report, c, run, chosen, clock }: HeadProps) {
  const { cases, engines } = report;
  const at = cases.indexOf(c);
  const previous = cases[(at + cases.length - 1) % cases.length]!;
  const next = cases[(at + 1) % cases.length]!;
  const gates = report.byCase.get(c) ?? [];
  const runs = c.runs.map((r): Option => ({
    name: r.label, href: linkTo(c.id, r.index, chosen), on: r === run, state: stateOf(gates.filter((g) => g.run === r)),
  }));
  const players = engines.filter((e) => run.plays.some((p) => p.engine === e.name && !p.why)).map((e): Option => ({
    name: e.name, href: linkTo(c.id, run.index, e.name, clock.t), on: e.name === chosen, engine: e,
    state: stateOf(gates.filter((g) => g.run === run && g.engine === e)),
  }));
  return (
    <header class="case-head">
      <div class="case-title">
        <h2 id="case-title"><b>{c.id}</b> {c.title}</h2>
        <nav aria-label="Neighbouring cases">
          <a href={linkTo(previous.id)} title="Previous case (k)" aria-label={`Previous case, ${previous.id}`}>
            ← {previous.id}
          </a>
          <a href={linkTo(next.id)} title="Next case (j)" aria-label={`Next case, ${next.id}`}>{next.id} →</a>
        </nav>
      </div>
      <div class="case-choices"><Choice legend="Run" options={runs} /><Choice legend="Engine" options={players} /></div>
    </header>
  );
}

const LEVELS: Record<string, string> = {
  L1: 'rigid Coulomb friction is the truth', L2: 'the compliant contact element is the truth',
  L3: 'the discrete law as the paper prints it is the truth',
};

function CaseText({ c, run }: { c: Case; run: Run }) {
  const formula = formulas[c.id];
  const level = LEVELS[c.level.slice(0, 2)];
  const notes = run.plays.filter((p) => p.note);
  return (
    <div class="case-text">
      <p class="statement"><Prose text={c.statement} /></p>
      {formula
        ? <div class="formula" dangerouslySetInnerHTML={{ __html: formula }} />
        : c.formula && <p class="formula"><Prose text={c.formula} /></p>}
      <p class="level"><b>{c.truth_level || c.level}</b>{level && ` ${level}`}</p>
      {c.note && <p class="note"><Prose text={c.note} /></p>}
      {notes.map((p) => <p class="note">{p.engine}: <Prose text={p.note} /></p>)}
    </div>
  );
}

interface PlayedParts {
  played: Played | undefined;
  ghost: Played | undefined;
}

function partsOf(report: Report, run: Run, loaded: Loaded | null, chosen: string): PlayedParts {
  const of = (name: string | undefined): Played | undefined => loaded?.played.find((p) => p.engine.name === name);
  const played = of(chosen) ?? loaded?.played[0];
  const ghost = of(ghostOf(report, run)?.name);
  return { played, ghost: ghost === played ? undefined : ghost };
}

interface StripsProps extends PlayedParts {
  report: Report;
  run: Run;
  end: number;
  step: number;
  chosen: string;
  theme: string;
}

function Strips({ report, run, played, ghost, end, step, chosen, theme }: StripsProps) {
  const both = useMemo(() => (played ? [played, ...(ghost ? [ghost] : [])] : []), [played, ghost]);
  return (
    <TimeStack>
      <Scrubber events={played?.recording.events ?? []} end={end} step={step} />
      <TimeAxis end={end} />
      {run.curve && <CurveStrips curve={run.curve} engines={report.engines} end={end} chosen={chosen} theme={theme} />}
      {played && (
        <>
          <Timeline played={played} ghost={ghost} end={end} theme={theme} />
          <ObjectStrips played={both} end={end} theme={theme} />
          <EnergyStrip played={played} end={end} theme={theme} />
        </>
      )}
    </TimeStack>
  );
}

interface Props extends SceneOptions {
  report: Report;
  route: Route;
  clock: Clock;
  theme: string;
}

export function CaseView({ report, route, clock, theme, ...scene }: Props) {
  const c = report.cases.find((x) => x.id === route.caseId) ?? report.cases[0]!;
  const run = c.runs[route.run] ?? c.runs[0]!;
  const id = `${c.id}-${run.index}`;
  const [section, near] = useNear();
  const [loaded, failure] = useRecordings(id, report.engines, run, near);
  const current = loaded?.id === id ? loaded : null;
  const chosen = route.engine || run.plays.find((p) => p.recording)?.engine || report.engines[0]?.name || '';
  const { played, ghost } = partsOf(report, run, loaded, chosen);
  const t = played?.recording.t ?? run.curve?.t ?? [0, 1];
  const end = t[t.length - 1]!;
  const step = t[1]! - t[0]! || 1 / 90;
  useEffect(() => { if (current) clock.restart(end, route.t); }, [current]);
  const budget = frameBudget(report.engines);
  const wait = failure ? `The recordings cannot be read: ${failure}.` : 'Decoding…';
  const absent = current && !played ? 'These results carry no recording of this run.' : wait;
  return (
    <section id="case" class="case" ref={section} aria-labelledby="case-title" data-ready={current ? id : undefined}>
      <CaseHead report={report} c={c} run={run} chosen={chosen} clock={clock} />
      <div class="case-grid">
        <div class="case-left">
          {played
            ? <SceneView {...{ played, ghost, theme, ...scene }} sceneId={loaded!.id} meshes={loaded!.meshes} />
            : <div class="scene"><div class="scene-picture"><p class="absent" role="status">{absent}</p></div></div>}
          <Transport step={step} />
          <CaseText c={c} run={run} />
        </div>
        <div class="case-right">
          {near && <Strips {...{ report, run, played, ghost, end, step, chosen, theme }} />}
        </div>
      </div>
      <div class="case-below">
        <div><h3>Claims</h3><Claims report={report} run={run} chosen={chosen} /></div>
        <div>
          <h3>CPU time a frame</h3>
          <FrameTimes engines={report.engines} plays={run.plays} played={current?.played ?? []} budget={budget} />
          <h3>Error against sub-step</h3>
          <Orders report={report} run={run} />
        </div>
      </div>
    </section>
  );
}
