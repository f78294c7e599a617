// SPDX-License-Identifier: GPL-3.0-or-later
/** What a link opens: #case=G05&run=1&engine=realtime&t=1.284. Run, engine and instant may be left out. */
export interface Route {
  caseId: string;
  run: number;
  engine: string;
  t: number;
}

const number = (text: string | null): number => Number(text ?? 0) || 0;

export function parseRoute(hash: string): Route | null {
  const values = new URLSearchParams(hash.replace(/^#/, ''));
  const caseId = values.get('case');
  if (!caseId) return null;
  return { caseId, run: number(values.get('run')), engine: values.get('engine') ?? '', t: number(values.get('t')) };
}

export function linkTo(caseId: string, run = 0, engine = '', t = 0): string {
  const values = new URLSearchParams({ case: caseId });
  if (run > 0) values.set('run', String(run));
  if (engine) values.set('engine', engine);
  values.set('t', String(Number(t.toFixed(4))));
  return `#${values}`;
}

/** Keeps the address in step without an entry in the history for each frame. */
export function writeRoute(route: Route): void {
  history.replaceState(null, '', linkTo(route.caseId, route.run, route.engine, route.t));
}
