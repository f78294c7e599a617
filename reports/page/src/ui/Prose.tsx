// SPDX-License-Identifier: GPL-3.0-or-later
const LETTERS = /\b(mu_s|mu_d|mu|th0|th1|th|[A-Z]_[a-z]|[a-z]_[a-z])\b/;

/** ASCII mathematics of the catalogue as people print it. */
function printed(text: string): string {
  return text
    .replace(/\^2\b/g, '²').replace(/\^3\b/g, '³')
    .replace(/\bsqrt\(/g, '√(').replace(/\bpi\b/g, 'π').replace(/ \* /g, ' · ')
    .replace(/>=/g, '≥').replace(/<=/g, '≤')
    .replace(/(\d)e-(\d)\b/g, (_, a: string, b: string) => `${a} × 10⁻${'⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(b)]}`)
    .replace(/\b(\d) x (\d)/g, '$1 × $2')
    .replace(/\+-/g, '±').replace(/-(?=\d)/g, '−');
}

function Letter({ name }: { name: string }) {
  const greek = name.replace(/^mu/, 'μ').replace(/^th(\d)?/, (_, d?: string) => (d ? `θ_${d}` : 'θ'));
  const [letter, index] = greek.split('_');
  return <><var>{letter}</var>{index && <sub>{index}</sub>}</>;
}

/** A sentence with its mathematics: mu_s as a Greek letter with an index, ^2, sqrt, th. */
export function Prose({ text }: { text: string }) {
  const parts = printed(text).split(LETTERS);
  return <>{parts.map((part, i) => (i % 2 ? <Letter name={part} /> : part))}</>;
}
