// SPDX-License-Identifier: GPL-3.0-or-later
import { errorText } from '../format';
import { asksYesNo, claimValue, type Engine, type Gate, type Report, type Run } from '../model';
import type { RawClaim, RawJudgement } from '../results';
import { LimitBar, Sign, Swatch, type State } from './marks';
import { Prose } from './Prose';

function stateOf(j: RawJudgement, gate: Gate | undefined): State {
  if (!gate) return j.grade ?? 'none';
  return gate.passes ? (gate.vacuous ? 'vacuous' : 'holds') : 'fails';
}

interface RowProps {
  claim: RawClaim;
  engine: Engine;
  judgement: RawJudgement;
  gate: Gate | undefined;
  chosen: boolean;
}

function JudgementRow({ claim, engine, judgement: j, gate, chosen }: RowProps) {
  const name = <th scope="row"><Swatch engine={engine} />{engine.name}</th>;
  if (j.state !== 'judged') {
    const why = <td colSpan={4} class="why">not asked: <Prose text={j.why ?? ''} /></td>;
    return <tr class={chosen ? 'chosen' : ''}>{name}{why}</tr>;
  }
  const error = (value: number | null | undefined): string =>
    asksYesNo(claim) ? '–' : errorText(value ?? null, claim.unit, j.relative === true);
  return (
    <tr class={chosen ? 'chosen' : ''}>
      {name}
      <td class="number">{claimValue(j.value, claim)}</td>
      <td class="number">{error(j.error)}</td>
      <td class="number limit-text">{gate && !asksYesNo(claim) ? `≤ ${error(gate.limit)}` : ''}</td>
      <td class="mark" title={gate?.reason ?? ''}>
        <Sign state={stateOf(j, gate)} spoken />
        {gate ? <LimitBar gate={gate} /> : <span class="short">{j.grade ?? ''}</span>}
      </td>
    </tr>
  );
}

function ClaimRows({ report, run, claim, chosen }: { report: Report; run: Run; claim: RawClaim; chosen: string }) {
  const gates = report.gates.filter((g) => g.run === run && g.claim === claim && g.quantity === claim.quantity);
  const reasons = [...new Set(gates.map((g) => g.reason).filter(Boolean))];
  return (
    <tbody>
      <tr class="claim">
        <th scope="rowgroup" colSpan={5}>
          {claim.quantity}<span class="truth">{claimValue(claim.truth, claim)}</span>
          <span class="source">{claim.pedigree}: <Prose text={claim.source} /></span>
          {reasons.length > 0 && (
            <details class="reasons">
              <summary>why these limits</summary>
              <ul>{reasons.map((r) => (
                <li>
                  {gates.filter((g) => g.reason === r).map((g) => g.engine.name).join(', ')}: <Prose text={r} />
                </li>
              ))}</ul>
            </details>
          )}
        </th>
      </tr>
      {report.engines.flatMap((engine) => {
        const judgement = claim.judgements.find((j) => j.engine === engine.name);
        if (!judgement) return [];
        const gate = gates.find((g) => g.engine === engine);
        const row = { claim, engine, judgement, gate, chosen: engine.name === chosen };
        return [<JudgementRow {...row} />];
      })}
    </tbody>
  );
}

const HEADS: readonly (readonly [string, string])[] = [
  ['claim, truth', ''], ['value', 'number'], ['error', 'number'], ['limit', 'number'], ['error / limit', ''],
];

/** Claims of a run by engine: value, error, limit. */
export function Claims({ report, run, chosen }: { report: Report; run: Run; chosen: string }) {
  if (run.claims.length === 0) {
    return <p class="absent">This run claims nothing: there is no closed form to compare with.</p>;
  }
  return (
    <div class="scroll" role="region" aria-label="Claims of this run" tabIndex={0}>
      <table class="claims">
        <thead><tr>{HEADS.map(([head, style]) => <th scope="col" class={style}>{head}</th>)}</tr></thead>
        {run.claims.map((claim) => <ClaimRows report={report} run={run} claim={claim} chosen={chosen} />)}
      </table>
    </div>
  );
}
