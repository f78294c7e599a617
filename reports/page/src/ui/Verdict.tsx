// SPDX-License-Identifier: GPL-3.0-or-later
import { capital, count, list, ratioText, seconds } from '../format';
import { worst, type Report } from '../model';
import { GateDots } from './GateDots';

/** The verdict in words, for the headline and for the tab. */
export function headlineOf(report: Report): string {
  const { verdict } = report.results;
  const failed = report.gates.filter((g) => !g.passes);
  const cut = verdict.interrupted ? 'Interrupted: ' : '';
  if (report.gates.length === 0) return `${cut}no gate was asked`;
  if (failed.length === 0) {
    const of = count(report.cases.length, 'case');
    return `${cut}${cut ? 'all' : 'All'} ${count(report.gates.length, 'gate')} of ${of} hold`;
  }
  const engines = report.engines.filter((e) => failed.some((g) => g.engine === e)).map((e) => e.name);
  const where = report.engines.length > 1 ? `, ${engines.length === 1 && failed.length > 1 ? 'all ' : ''}in ` : '';
  return `${cut}${failed.length} of ${count(report.gates.length, 'gate')} fail${where && where + list(engines)}`;
}

/** How far off what fails is, and how tightly what holds does. */
function detailOf(report: Report): string {
  const failed = report.gates.filter((g) => !g.passes);
  const far = worst(failed.filter((g) => Number.isFinite(g.ratio)));
  const tight = worst(report.gates.filter((g) => g.passes));
  const missing = failed.filter((g) => g.error === null).length;
  const clean = [...report.byEngine].filter(([, gates]) => gates.every((g) => g.passes)).map(([e]) => e.name);
  const { vacuous, not_asked: notAsked } = report.results.verdict;
  const parts = [
    far && `Farthest off: ${far.caseOf.id}, ${far.quantity}, at ${ratioText(far.ratio)} its limit.`,
    missing > 0 && `${count(missing, 'claim')} could not be measured: what they name never happens in the recording.`,
    failed.length > 0 && clean.length > 0 && `${capital(list(clean))} hold${clean.length === 1 ? 's' : ''} every gate.`,
    tight && `The tightest that holds uses ${ratioText(tight.ratio)} of its limit: ${tight.caseOf.id}, ` +
      `${tight.quantity}, ${tight.engine.name}.`,
    vacuous > 0 && `${count(vacuous, 'gate')} could be a hundred times tighter and still hold.`,
    notAsked > 0 && `${count(notAsked, 'claim')} not asked of an engine, each with its reason.`,
  ];
  return parts.filter(Boolean).join(' ');
}

/** The keys of the provenance that a reader asks for first; the others are folded away. */
const FIRST = ['version', 'finished', 'compiler', 'processor', 'frame rate'];

function Provenance({ report }: { report: Report }) {
  const { occasion, seconds: took } = report.times;
  const provenance = { ...report.results.provenance, ...occasion };
  const facts = Object.entries(provenance).filter(([key]) => key !== 'command');
  const first = FIRST.flatMap((key) => (provenance[key] ? [[key, provenance[key]] as const] : []));
  const rest = facts.filter(([key]) => !FIRST.includes(key));
  const rows = (of: readonly (readonly [string, string])[]) => of.map(([key, text]) => (
    <div><dt>{key}</dt><dd>{text}</dd></div>
  ));
  return (
    <>
      <dl class="facts">
        {rows(first)}
        {took !== null && <div><dt>took</dt><dd>{took < 10 ? seconds(took) : `${took.toFixed(0)} s`}</dd></div>}
      </dl>
      {provenance['command'] && <p class="again">Run again <code>{provenance['command']}</code></p>}
      {rest.length > 0 && (
        <details class="more">
          <summary>Everything about this run</summary>
          <dl class="facts">{rows(rest)}</dl>
        </details>
      )}
    </>
  );
}

/** What differs from the baseline, folded away: its title says how much. */
function Moved({ moved }: { moved: { sentence: string }[] }) {
  if (moved.length === 0) return <p class="again">Nothing moved since the baseline.</p>;
  return (
    <details class="more" data-moved={moved.length}>
      <summary>Moved since the baseline: {count(moved.length, 'gate')}</summary>
      <ul>{moved.map((change) => <li>{change.sentence}</li>)}</ul>
    </details>
  );
}

export function Verdict({ report }: { report: Report }) {
  const { passed } = report.results.verdict;
  return (
    <section class={`verdict ${passed ? 'passed' : 'failed'}`} id="verdict" aria-labelledby="verdict-title">
      <p class="eyebrow"><span aria-hidden="true">{passed ? '✓' : '✗'}</span> {passed ? 'Passed' : 'Failed'}</p>
      <h1 id="verdict-title" data-gates={report.gates.length}>{headlineOf(report)}</h1>
      <p class="lead">{detailOf(report)}</p>
      <GateDots report={report} />
      {report.results.moved && <Moved moved={report.results.moved} />}
      <Provenance report={report} />
    </section>
  );
}
