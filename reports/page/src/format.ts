// SPDX-License-Identifier: GPL-3.0-or-later
const PREFIXES: readonly (readonly [number, string])[] = [
  [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'], [1e-12, 'p'], [1e-15, 'f'],
];
const PREFIXED = new Set(['m', 's', 'N', 'J', 'rad', 'N m', 'm/s', 'rad/s']);
const NBSP = '\u00a0';

/** A factor and the unit it makes: values are shown as `value / factor` in `unit`. */
export interface Scaled {
  factor: number;
  unit: string;
}

export const minus = (text: string): string => text.replace(/-/g, '\u2212');
export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);
export const list = (words: readonly string[]): string => new Intl.ListFormat('en').format(words);
export const count = (n: number, noun: string): string =>
  `${n.toLocaleString('en')}${NBSP}${noun}${n === 1 ? '' : 's'}`;
export const seconds = (t: number): string => `${t.toFixed(3)}${NBSP}s`;

/** The SI prefix that people use for numbers as large as `size`. */
export function prefixFor(size: number, unit: string, significant = 3): Scaled {
  if (!PREFIXED.has(unit) || !(size > 0) || !Number.isFinite(size)) return { factor: 1, unit };
  const [factor, prefix] = PREFIXES.find(([f]) => Number(size.toPrecision(significant)) >= f) ?? [1e-15, 'f'];
  return { factor, unit: prefix + unit.replace(' ', NBSP) };
}

function superscript(n: number): string {
  return String(n).replace(/[-\d]/g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)] ?? ''));
}

/** So many significant digits, with a power of ten only where digits would mislead. */
export function digits(value: number, significant = 3): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6) {
    const [mantissa = '', exponent = ''] = value.toExponential(significant - 1).split('e');
    return `${minus(mantissa)}×10${superscript(Number(exponent))}`;
  }
  const text = value.toPrecision(significant);
  return minus(text.includes('e') ? String(Number(text)) : text);
}

/** 0.0121, m -> "12.1 mm". */
export function quantity(value: number | null | undefined, unit: string, significant = 3): string {
  if (value === null || value === undefined) return 'not found';
  if (unit === '') return digits(value, significant);
  const scaled = prefixFor(Math.abs(value), unit, significant);
  return `${digits(value / scaled.factor, significant)}${NBSP}${scaled.unit}`;
}

/** An error: relative ones as a share, others with their unit. */
export function errorText(value: number | null, unit: string, relative: boolean): string {
  if (value === null) return '–';
  if (value === 0) return '0';
  return relative ? share(value) : quantity(value, unit, 2);
}

/** A fraction as people write it: percent, or parts a million where percent would be all zeros. */
export function share(value: number): string {
  const size = Math.abs(value);
  if (size === 0) return '0';
  if (size < 1e-7) return `<${NBSP}0.1${NBSP}ppm`;
  return size < 1e-3 ? `${digits(value * 1e6, 2)}${NBSP}ppm` : `${digits(value * 100, 2)}${NBSP}%`;
}

/** Error over limit. */
export function ratioText(ratio: number): string {
  if (!Number.isFinite(ratio)) return 'wrong';
  if (ratio >= 1.005) return `${digits(ratio, ratio < 10 ? 2 : 3)}${NBSP}×`;
  if (ratio >= 0.995) return `${(ratio * 100).toFixed(1)}${NBSP}%`;
  return ratio >= 0.01 ? `${Math.round(ratio * 100)}${NBSP}%` : `<${NBSP}1${NBSP}%`;
}

/** Steps of an axis that people count in: 1, 2 or 5 times a power of ten. */
export function niceStep(span: number, ticks: number): number {
  const raw = span / ticks;
  const power = 10 ** Math.floor(Math.log10(raw));
  return power * ([1, 2, 5, 10].find((m) => m * power >= raw) ?? 10);
}
