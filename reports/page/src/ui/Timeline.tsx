// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useMemo, useRef } from 'preact/hooks';
import { frameAt, Mode, phalanxName, type Contact, type Recording, type Track } from '../packed';
import { patchesOf } from '../patches';
import { ModeSign } from './ModeSign';
import { cssColour } from './Plot';
import type { Played } from './Strips';
import { INSET, Readout, useWidth } from './time';

const ROW = 24;
const GAP = 6;
const GHOST = 4;

interface Modes {
  stick: number;
  slip: number;
}

/** Of a patch's samples on frame k: how many stick and how many slip. */
function countModes(patch: readonly Contact[], k: number): Modes {
  const modes = { stick: 0, slip: 0 };
  for (const c of patch) {
    if (c.mode[k] === Mode.stick) ++modes.stick;
    else if (c.mode[k] === Mode.slip) ++modes.slip;
  }
  return modes;
}

/** Stripes at 45 degrees: slip is told from stick without colour. */
function stripes(context: CanvasRenderingContext2D, colour: string, gap: string): CanvasPattern {
  const tile = document.createElement('canvas');
  tile.width = tile.height = 6;
  const c = tile.getContext('2d')!;
  c.fillStyle = colour;
  c.fillRect(0, 0, 6, 6);
  c.strokeStyle = gap;
  c.lineWidth = 1.6;
  c.beginPath();
  for (const x of [-6, 0, 6]) {
    c.moveTo(x, 6);
    c.lineTo(x + 6, 0);
  }
  c.stroke();
  return context.createPattern(tile, 'repeat')!;
}

interface Bars {
  context: CanvasRenderingContext2D;
  inner: number;
  end: number;
  stick: string;
  slip: CanvasPattern;
  empty: string;
}

/** Stick below, slip above, each as its share of the patch. Frames alike are one rectangle: singly, they show seams. */
function drawPatch(bars: Bars, t: Float64Array, patch: Contact[], y: number, h: number): void {
  const { context: c, inner, end, stick, slip, empty } = bars;
  c.fillStyle = empty;
  c.fillRect(INSET.left, y, inner, h);
  const unit = h / (patch.length || 1);
  for (let k = 0, next = 0; patch.length && k < t.length - 1; k = next) {
    const modes = countModes(patch, k);
    for (next = k + 1; next < t.length - 1; ++next) {
      const m = countModes(patch, next);
      if (m.stick !== modes.stick || m.slip !== modes.slip) break;
    }
    const x = INSET.left + (t[k]! / end) * inner;
    const w = ((t[next]! - t[k]!) / end) * inner;
    c.fillStyle = stick;
    c.fillRect(x, y + h - modes.stick * unit, w, modes.stick * unit);
    c.fillStyle = slip;
    c.fillRect(x, y + h - (modes.stick + modes.slip) * unit, w, modes.slip * unit);
  }
}

const touches = (patch: readonly Contact[]): boolean => patch.some((c) => c.mode.some((m) => m >= Mode.stick));

/** The patches that ever touch, in either recording. */
function rowsOf(recordings: readonly Recording[]): { key: string; track: Track }[] {
  const rows = new Map<string, Track>();
  for (const recording of recordings)
    for (const [key, patch] of patchesOf(recording.contacts)) if (touches(patch)) rows.set(key, patch[0]!.track);
  const all = [...rows].map(([key, track]) => ({ key, track }));
  return all.sort((a, b) => a.track[0] - b.track[0] || a.track[1] - b.track[1]);
}

interface Props {
  played: Played;
  ghost: Played | undefined;
  end: number;
  theme: string;
}

/** One row a phalanx: stick and slip of its samples; the ghost's as a thin row below. */
export function Timeline({ played: { engine, recording }, ghost, end, theme }: Props) {
  const [ref, width] = useWidth<HTMLDivElement>();
  const canvas = useRef<HTMLCanvasElement>(null);
  const recordings = ghost ? [recording, ghost.recording] : [recording];
  const rows = useMemo(() => rowsOf(recordings), [recording, ghost?.recording]);
  const height = rows.length * (ROW + GAP);
  useEffect(() => {
    const context = canvas.current?.getContext('2d');
    if (!context || width === 0) return;
    const ratio = devicePixelRatio;
    context.canvas.width = width * ratio;
    context.canvas.height = height * ratio;
    context.scale(ratio, ratio);
    const bars: Bars = {
      context, end, inner: width - INSET.left - INSET.right, stick: cssColour('--stick'), empty: cssColour('--sunken'),
      slip: stripes(context, cssColour('--slip'), cssColour('--paper')),
    };
    const patches = recordings.map((r) => patchesOf(r.contacts));
    rows.forEach(({ key }, i) => {
      const y = i * (ROW + GAP);
      drawPatch(bars, recording.t, patches[0]!.get(key) ?? [], y, ghost ? ROW - GHOST - 2 : ROW);
      if (ghost) drawPatch(bars, ghost.recording.t, patches[1]!.get(key) ?? [], y + ROW - GHOST, GHOST);
    });
  }, [rows, width, height, end, theme]);
  if (recording.contacts.length === 0) return <p class="absent">{engine.name} records no contacts.</p>;
  const total = (t: number): Modes => countModes(recording.contacts, frameAt(recording.t, t));
  return (
    <>
      <div class="strip-head">
        <h3>Stick and slip<span class="unit">, samples of a patch</span></h3>
        <ul class="keys">
          <li><ModeSign mode="stick" />stick <Readout at={(t) => String(total(t).stick)} /></li>
          <li><ModeSign mode="slip" />slip, striped <Readout at={(t) => String(total(t).slip)} /></li>
          {ghost && <li>thick: {engine.name}; thin: {ghost.engine.name}</li>}
        </ul>
      </div>
      <div class="timeline" ref={ref} style={{ height: `${height}px` }}>
        <canvas ref={canvas} style={{ width: `${width}px`, height: `${height}px` }} role="img"
          aria-label={`Stick and slip of ${rows.length} phalanges against time`} />
        {rows.map(({ track }, i) => (
          <div class="timeline-label" style={{ top: `${i * (ROW + GAP)}px` }}>
            {phalanxName(track, recording.hands.length)}
          </div>
        ))}
      </div>
    </>
  );
}
