// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useMemo, useState } from 'preact/hooks';
import licences from 'page:licences';
import { Clock } from '../clock';
import type { Report } from '../model';
import { linkTo, parseRoute, writeRoute, type Route } from '../route';
import { CaseView } from './CaseView';
import { Failures } from './Failures';
import { Matrix } from './Matrix';
import { headlineOf, Verdict } from './Verdict';
import { TimeContext } from './time';

/** The colour scheme: the reader's own unless chosen here. */
function useTheme(): [string, () => void] {
  const media = useMemo(() => matchMedia('(prefers-color-scheme: dark)'), []);
  const [dark, setDark] = useState(media.matches);
  useEffect(() => {
    const follow = (): void => setDark(media.matches);
    media.addEventListener('change', follow);
    return () => media.removeEventListener('change', follow);
  }, []);
  const theme = dark ? 'dark' : 'light';
  document.documentElement.dataset['theme'] = theme;
  return [theme, () => setDark(!dark)];
}

const showCase = (): void => document.getElementById('case')?.scrollIntoView();

/** The address decides what is shown; the clock writes its instant back, not oftener than a reader can see. */
function useRoute(report: Report, clock: Clock): Route {
  const far = report.gates.find((g) => !g.passes) ?? report.gates[0];
  const first = { caseId: far?.caseOf.id ?? '', run: far?.run.index ?? 0, engine: far?.engine.name ?? '', t: 0 };
  const [route, setRoute] = useState<Route>(() => parseRoute(location.hash) ?? first);
  useEffect(() => {
    const follow = (event: HashChangeEvent): void => {
      // The event's own address: a delayed write of the clock may have replaced the location since.
      const to = parseRoute(event.newURL ? new URL(event.newURL).hash : location.hash);
      if (!to) return;
      setRoute((from) => {
        if (from.caseId === to.caseId && from.run === to.run) clock.set(to.t);
        return to;
      });
      if (event.isTrusted) showCase();
    };
    addEventListener('hashchange', follow);
    if (parseRoute(location.hash)) requestAnimationFrame(showCase);
    return () => removeEventListener('hashchange', follow);
  }, []);
  useEffect(() => {
    let timer = 0;
    const stop = clock.listen((t) => {
      clearTimeout(timer);
      if (parseRoute(location.hash) || t > 0) timer = setTimeout(() => writeRoute({ ...route, t }), 300);
    });
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [route]);
  return route;
}

interface Toggles {
  onGhost: () => void;
  onFollow: () => void;
}

/** Keys act while the case is in sight, and leave alone what a focused control needs for itself. */
function useKeys(report: Report, clock: Clock, route: Route, { onGhost, onFollow }: Toggles): void {
  useEffect(() => {
    const { cases, engines } = report;
    const step = 1 / 90;
    const next = <T,>(all: readonly T[], at: number, by: number): T => all[(at + by + all.length) % all.length]!;
    const goCase = (by: number): void => {
      location.hash = linkTo(next(cases, cases.findIndex((c) => c.id === route.caseId), by).id, 0, route.engine);
    };
    const goEngine = (): void => {
      const plays = cases.find((c) => c.id === route.caseId)?.runs[route.run]?.plays;
      const players = engines.filter((e) => plays?.some((p) => p.engine === e.name && !p.why));
      const to = next(players, players.findIndex((e) => e.name === route.engine), 1);
      location.hash = linkTo(route.caseId, route.run, to.name, clock.t);
    };
    const keys: Record<string, () => void> = {
      ' ': () => clock.toggle(),
      ArrowLeft: () => clock.set(clock.t - step), ArrowRight: () => clock.set(clock.t + step),
      Home: () => clock.set(0), End: () => clock.set(clock.end),
      ',': () => clock.shift(-1), '.': () => clock.shift(1),
      j: () => goCase(1), k: () => goCase(-1), e: goEngine, g: onGhost, f: onFollow,
    };
    const press = (event: KeyboardEvent): void => {
      const target = event.target as HTMLElement;
      const own = target.closest('select, [role=region]')
        ?? (event.key === ' ' ? target.closest('button, a, summary') : event.key.length > 1 && target.closest('input'));
      if (event.ctrlKey || event.metaKey || event.altKey || own) return;
      const box = document.getElementById('case')!.getBoundingClientRect();
      const seen = box.top < innerHeight * 0.7 && box.bottom > innerHeight * 0.3;
      const act = keys[event.key];
      if (!act || !seen) return;
      event.preventDefault();
      act();
    };
    addEventListener('keydown', press);
    return () => removeEventListener('keydown', press);
  }, [route, onGhost, onFollow]);
}

const KEYS: readonly (readonly [string, string])[] = [
  ['space', 'play'], ['← →', 'a frame'], [', .', 'speed'], ['j k', 'case'], ['e', 'engine'], ['g', 'ghost'],
  ['f', 'follow'],
];

function Footer() {
  return (
    <footer>
      <p>{KEYS.map(([key, what]) => <span><kbd>{key}</kbd> {what} </span>)}</p>
      <details>
        <summary>Software in this page and its licences</summary>
        {licences.map(({ name, version, text }) => (
          <div class="licence"><h3>{name} {version}</h3><pre>{text}</pre></div>
        ))}
      </details>
    </footer>
  );
}

export function App({ report }: { report: Report }) {
  const clock = useMemo(() => new Clock(), []);
  const [theme, flip] = useTheme();
  const [ghostOn, onGhost] = useState(true);
  const [follow, onFollow] = useState(false);
  const route = useRoute(report, clock);
  const { passed } = report.results.verdict;
  useKeys(report, clock, route, { onGhost: () => onGhost((on) => !on), onFollow: () => onFollow((on) => !on) });
  useEffect(() => { document.title = `${passed ? '✓' : '✗'} ${headlineOf(report)} – handhold`; }, []);
  return (
    <TimeContext.Provider value={clock}>
      <header class="bar">
        <a class="mark" href="#verdict">handhold</a>
        <nav aria-label="Sections">
          {report.gates.some((g) => !g.passes) && <a href="#failed">Failed</a>}
          <a href="#engines">Engines</a>
          {report.cases.length > 0 && <a href="#case">Case</a>}
        </nav>
        <button type="button" onClick={flip}>{theme === 'dark' ? 'Light' : 'Dark'}</button>
      </header>
      <main>
        <Verdict report={report} />
        <Failures report={report} />
        <Matrix report={report} chosen={route.caseId} />
        {report.cases.some((c) => c.runs.length > 0) && (
          <CaseView {...{ report, route, clock, theme, ghostOn, follow, onGhost, onFollow }} />
        )}
      </main>
      <Footer />
    </TimeContext.Provider>
  );
}
