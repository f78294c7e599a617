// SPDX-License-Identifier: GPL-3.0-or-later
import { seconds } from '../format';
import { claimValue, gateError, instantOf, linkToGate, type Gate, type Report } from '../model';
import { LimitBar, Swatch } from './marks';
import { Prose } from './Prose';

function Failure({ gate: g }: { gate: Gate }) {
  const asked = g.quantity === g.claim.quantity;  // else an order, whose truth is in its reason
  return (
    <tr>
      <th scope="row"><b>{g.caseOf.id}</b> <Prose text={g.run.label} /></th>
      <td class="what">{g.quantity}</td>
      <td class="engine"><Swatch engine={g.engine} />{g.engine.name}</td>
      <td class="measure"><LimitBar gate={g} width={150} /></td>
      <td class="number" data-label="error">{gateError(g.error, g)}</td>
      <td class="number" data-label="limit">{gateError(g.limit, g)}</td>
      <td class="number" data-label="truth">{asked ? claimValue(g.claim.truth, g.claim) : ''}</td>
      <td class="go"><a href={linkToGate(g)}>see {seconds(instantOf(g))}</a></td>
      <td class="why"><details><summary>why this limit</summary><Prose text={g.reason} /></details></td>
    </tr>
  );
}

const HEADS: readonly (readonly [string, string])[] = [
  ['case', ''], ['quantity', ''], ['engine', ''], ['error / limit', ''], ['error', 'number'], ['limit', 'number'],
  ['truth', 'number'], ['replay', ''], ['reason', ''],
];

/** Failed gates, farthest off first; what was not found at all before everything else. */
export function Failures({ report }: { report: Report }) {
  const failed = report.gates.filter((g) => !g.passes);
  if (failed.length === 0) return null;
  failed.sort((a, b) => (b.ratio === a.ratio ? 0 : b.ratio - a.ratio));
  return (
    <section id="failed" aria-labelledby="failed-title">
      <h2 id="failed-title">Failed gates</h2>
      <p class="intro">
        Farthest off first. The line across each track is the limit; the link opens the case at the instant to look at.
      </p>
      <table class="failures">
        <thead><tr>{HEADS.map(([head, style]) => <th scope="col" class={style}>{head}</th>)}</tr></thead>
        <tbody>{failed.map((g) => <Failure gate={g} />)}</tbody>
      </table>
    </section>
  );
}
