// SPDX-License-Identifier: GPL-3.0-or-later
import { createContext, type ComponentChildren } from 'preact';
import { useContext, useEffect, useRef, useState } from 'preact/hooks';
import { SPEEDS, type Clock } from '../clock';
import { niceStep, seconds } from '../format';
import type { Event } from '../packed';

export const TimeContext = createContext<Clock>(null!);
export const useClock = (): Clock => useContext(TimeContext);

/** Plot areas of all strips begin and end here, so that one line can cross them all. */
export const INSET = { left: 64, right: 12 } as const;

/** Text that follows the clock without rendering its parent again. */
export function Readout({ at, class: name = '' }: { at: (t: number) => string; class?: string }) {
  const clock = useClock();
  const ref = useRef<HTMLSpanElement>(null);
  useEffect(() => clock.listen((t) => { if (ref.current) ref.current.textContent = at(t); }), [clock, at]);
  return <span ref={ref} class={`readout ${name}`} />;
}

/** Width of an element, followed. */
export function useWidth<T extends HTMLElement>(): [{ current: T | null }, number] {
  const ref = useRef<T>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const observer = new ResizeObserver(([entry]) => entry && setWidth(Math.floor(entry.contentRect.width)));
    if (ref.current) observer.observe(ref.current);
    return () => observer.disconnect();
  }, []);
  return [ref, width];
}

/** Everything over one time axis: hover or drag anywhere moves the cursor. */
export function TimeStack({ children }: { children: ComponentChildren }) {
  const clock = useClock();
  const box = useRef<HTMLDivElement>(null);
  const line = useRef<HTMLDivElement>(null);
  useEffect(() => clock.listen((t) => line.current?.style.setProperty('--share', String(t / clock.end))), [clock]);
  const point = (event: PointerEvent): void => {
    const hovering = event.type === 'pointermove' && event.buttons === 0;
    if (clock.playing || (event.pointerType === 'touch' && hovering)) return;
    const area = box.current!.getBoundingClientRect();
    const share = (event.clientX - area.left - INSET.left) / (area.width - INSET.left - INSET.right);
    if (share >= -0.01 && share <= 1.01) clock.set(share * clock.end);
  };
  return (
    <div class="time-stack" ref={box} onPointerMove={point} onPointerDown={point}>
      {children}
      <div class="time-line" ref={line} aria-hidden="true" />
    </div>
  );
}

export function TimeAxis({ end }: { end: number }) {
  const [ref, width] = useWidth<HTMLDivElement>();
  const step = niceStep(end, Math.max(2, width / 90));
  const n = Math.floor(end / step + 1e-9);
  const places = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return (
    <div class="time-axis" ref={ref} aria-hidden="true">
      {Array.from({ length: n + 1 }, (_, i) => (
        <span style={{ '--share': (i * step) / end }}>{(i * step).toFixed(places)}{i === n ? ' s' : ''}</span>
      ))}
    </div>
  );
}

const EVENT_SIGNS: Record<string, string> = {
  touch: 'M-3 -3L3 0L-3 3Z', breakaway: 'M0 -4L4 0L0 4L-4 0Z', restick: 'M-3 -3H3V3H-3Z', release: 'M3 -3L-3 0L3 3Z',
};

/** The slider with the events of the run above it. */
export function Scrubber({ events, end, step }: { events: readonly Event[]; end: number; step: number }) {
  const clock = useClock();
  const input = useRef<HTMLInputElement>(null);
  const [ref, width] = useWidth<HTMLDivElement>();
  useEffect(() => clock.listen((t) => {
    if (!input.current) return;
    input.current.value = String(t);
    input.current.ariaValueText = seconds(t);
  }), [clock, end]);
  const inner = Math.max(0, width - INSET.left - INSET.right);
  return (
    <div class="scrubber" ref={ref}>
      <svg width={width} height="14" aria-hidden="true">
        {events.map(([t, kind]) => (
          <path class={`event-${kind}`} d={EVENT_SIGNS[kind] ?? ''}
            transform={`translate(${INSET.left + (t / end) * inner},7)`}>
            <title>{`${kind} at ${seconds(t)}`}</title>
          </path>
        ))}
      </svg>
      <input ref={input} type="range" min="0" max={end} step={step / 4} aria-label="Time"
        onInput={(e) => clock.set(Number(e.currentTarget.value))} />
    </div>
  );
}

const ICONS = {
  play: 'M3 1.5v13l11-6.5z', pause: 'M3 2h4v12H3zM9 2h4v12H9z', back: 'M13 2v12L5 8zM2 2h2v12H2z',
  next: 'M3 2v12l8-6zM12 2h2v12h-2z',
};

function Icon({ path }: { path: string }) {
  return <svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true"><path d={path} fill="currentColor" /></svg>;
}

interface ButtonProps {
  name: string;
  hint: string;
  icon: string;
  onClick: () => void;
  primary?: boolean;
}

function IconButton({ name, hint, icon, onClick, primary = false }: ButtonProps) {
  return (
    <button type="button" class={primary ? 'primary' : ''} title={hint} aria-label={name} onClick={onClick}>
      <Icon path={icon} />
    </button>
  );
}

export function Transport({ step }: { step: number }) {
  const clock = useClock();
  const [playing, setPlaying] = useState(false);
  const [speed, setSpeed] = useState(clock.speed);
  useEffect(() => clock.listen(() => {
    setPlaying(clock.playing);
    setSpeed(clock.speed);
  }), [clock]);
  const jump = (frames: number): void => clock.set((Math.round(clock.t / step) + frames) * step);
  const choose = (text: string): void => {
    clock.speed = Number(text);
    setSpeed(clock.speed);
  };
  return (
    <div class="transport" role="group" aria-label="Replay">
      <IconButton name="One frame back" hint="One frame back (←)" icon={ICONS.back} onClick={() => jump(-1)} />
      <IconButton primary name={playing ? 'Pause' : 'Play'} hint="Play or pause (space)"
        icon={playing ? ICONS.pause : ICONS.play} onClick={() => clock.toggle()} />
      <IconButton name="One frame on" hint="One frame on (→)" icon={ICONS.next} onClick={() => jump(1)} />
      <Readout class="now" at={seconds} />
      <label class="speed">
        speed
        <select value={speed} onChange={(e) => choose(e.currentTarget.value)}>
          {SPEEDS.map((s) => <option value={s}>{s}×</option>)}
        </select>
      </label>
    </div>
  );
}
