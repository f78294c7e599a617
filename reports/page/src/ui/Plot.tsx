// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useRef } from 'preact/hooks';
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { minus, niceStep } from '../format';
import { INSET, useWidth } from './time';

export interface Line {
  label: string;
  /** a CSS variable */
  colour: string;
  values: (number | null)[];
  width?: number;
  dash?: number[];
}

interface Props {
  t: ArrayLike<number>;
  end: number;
  lines: Line[];
  height: number;
  label: string;
  theme: string;
  /** about zero, with a tick either side: residuals */
  symmetric?: boolean;
}

export const cssColour = (name: string): string =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function rangeOf(lo: number | null, hi: number | null, symmetric: boolean): [number, number] {
  const from = lo ?? 0;
  const to = hi ?? 0;
  if (symmetric) {
    const most = Math.max(Math.abs(from), Math.abs(to)) * 1.1 || 1;
    return [-most, most];
  }
  const pad = (to - from) * 0.07 || Math.abs(to) * 0.1 || 1;
  return [from - pad, to + pad];
}

/** -s, 0, s */
function symmetricSplits(most: number): number[] {
  const step = niceStep(most, 1) > most ? niceStep(most, 2) : niceStep(most, 1);
  return [-step, 0, step];
}

function timeSplits(end: number, width: number): number[] {
  const step = niceStep(end, Math.max(2, width / 90));
  return Array.from({ length: Math.floor(end / step + 1e-9) + 1 }, (_, i) => i * step);
}

function optionsOf({ end, lines, height, symmetric = false }: Props, width: number): uPlot.Options {
  const grid = { stroke: cssColour('--line'), width: 1 };
  return {
    width, height, padding: [6, INSET.right, 6, 0], legend: { show: false }, cursor: { show: false },
    scales: { x: { time: false, range: [0, end] }, y: { range: (_, lo, hi) => rangeOf(lo, hi, symmetric) } },
    axes: [
      { size: 0, grid, ticks: { show: false }, splits: () => timeSplits(end, width), values: () => [] },
      {
        size: INSET.left, gap: 6, font: '12px Inter, sans-serif', stroke: cssColour('--ink-3'), grid,
        ticks: { show: false }, space: 26,
        ...(symmetric ? { splits: (_: uPlot, __: number, ___: number, hi: number) => symmetricSplits(hi) } : {}),
        values: (_, splits) => splits.map((v) => minus(String(Number(v.toPrecision(6))))),
      },
    ],
    series: [{}, ...lines.map((line): uPlot.Series => ({
      stroke: cssColour(line.colour), width: line.width ?? 1.5, points: { show: false }, spanGaps: false,
      ...(line.dash?.length ? { dash: line.dash } : {}),
    }))],
  };
}

/** One strip of curves over the shared time axis. uPlot draws; the cursor is the stack's. */
export function Plot(props: Props) {
  const { t, end, lines, height, label, theme } = props;
  const [ref, width] = useWidth<HTMLDivElement>();
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (width === 0) return;
    const data = [Array.from(t), ...lines.map((line) => line.values)] as uPlot.AlignedData;
    const plot = new uPlot(optionsOf(props, width), data, host.current!);
    return () => plot.destroy();
  }, [t, end, lines, width, height, theme]);
  return (
    <div class="plot" ref={ref} style={{ height: `${height}px` }} role="img" aria-label={label}><div ref={host} /></div>
  );
}
