// SPDX-License-Identifier: GPL-3.0-or-later
type Listener = (t: number) => void;

export const SPEEDS: readonly number[] = [0.05, 0.1, 0.25, 0.5, 1];

/** The one time cursor: replay, curves, timeline and slider all listen to it. Seconds. */
export class Clock {
  t = 0;
  end = 1;
  speed = 0.25;
  playing = false;
  private before = 0;
  private readonly listeners = new Set<Listener>();

  /** Calls back at once and on every change; returns what ends it. */
  listen(listener: Listener): () => void {
    this.listeners.add(listener);
    listener(this.t);
    return () => void this.listeners.delete(listener);
  }

  set(t: number): void {
    this.t = Math.min(this.end, Math.max(0, t));
    for (const listener of this.listeners) listener(this.t);
  }

  restart(end: number, t: number): void {
    this.end = end > 0 ? end : 1;
    this.playing = false;
    this.set(t);
  }

  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.t >= this.end) this.t = 0;
    this.before = performance.now();
    if (this.playing) requestAnimationFrame(this.tick);
    this.set(this.t);
  }

  /** The next faster or slower speed. */
  shift(by: number): void {
    const at = SPEEDS.indexOf(this.speed) + by;
    this.speed = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, at))] ?? this.speed;
    this.set(this.t);
  }

  private readonly tick = (now: number): void => {
    if (!this.playing) return;
    const t = this.t + ((now - this.before) / 1000) * this.speed;
    this.before = now;
    if (t >= this.end) this.playing = false;
    else requestAnimationFrame(this.tick);
    this.set(t);
  };
}
