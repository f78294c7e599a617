// SPDX-License-Identifier: GPL-3.0-or-later
/** Reads what reports/data/packed_recording.cpp writes; decoded when a case is looked at. */
export interface Scale {
  lo: number;
  step: number;
}

/** hand (255: a body), phalanx, body, sample */
export type Track = [number, number, number, number];
/** time, kind, hand, phalanx, how many samples */
export type Event = [number, string, number, number, number];

export interface HandMeta {
  shown: number[];
  scale: Scale;
  capsules: [number, number][];
  palm: [number, number, number];
  patches: { phalanx: number; points: [number, number, number][] }[];
  present: [number, number][];
}

interface Header {
  format: string;
  version: number;
  engine: string;
  outcome: string;
  note: string;
  t: { n: number; dt: number } | { list: number[] };
  bodies: { name: string; mass: number; held_until: number; mesh: string | null }[];
  hands: HandMeta[];
  position: Scale;
  contacts: Track[];
  anchor: Scale;
  force: Scale;
  energy: Scale[];
  cost: Scale | null;
  events: Event[];
}

/** x, y, z, qw, qx, qy, qz: one column of values over the frames each. */
export type PoseTrack = Float32Array[];
export enum Mode { absent, apart, stick, slip }

export interface Contact {
  track: Track;
  /** anchor in the body's frame, then force in the world */
  columns: Float32Array[];
  mode: Uint8Array;
}

/** What one engine played of a run. */
export interface Recording extends Omit<Header, 't' | 'contacts'> {
  t: Float64Array;
  bodyPoses: PoseTrack[];
  handPoses: Map<number, PoseTrack>[];
  contacts: Contact[];
  energies: Float32Array[];
  frameTimes: Float32Array | null;
}

export interface Mesh {
  positions: Float32Array;
  indices: Uint32Array;
}

const VERSION = 1;
const UNIT: Scale = { lo: -1, step: 2 / 65535 };

/** Recordings stand behind the program, so that the verdict is painted before they are parsed. */
const parsed = new Promise<void>((resolve) => {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', () => resolve());
  else resolve();
});

async function inflate(id: string): Promise<Uint8Array> {
  const text = document.getElementById(id)?.textContent;
  if (!text) throw new Error(`this page carries no data called ${id}`);
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function inflateJson(id: string): Promise<unknown> {
  return JSON.parse(new TextDecoder().decode(await inflate(id)));
}

/** Reads columns one after another: byte planes, zigzag and differences undone, scaled. */
class ColumnReader {
  private at = 0;
  constructor(private readonly bytes: Uint8Array, private readonly total: number) {}

  integers(n: number): Uint16Array {
    const out = new Uint16Array(n);
    let value = 0;
    for (let k = 0; k < n; ++k, ++this.at) {
      const z = this.bytes[this.at]! | (this.bytes[this.total + this.at]! << 8);
      value = (value + ((z >>> 1) ^ -(z & 1))) & 0xffff;
      out[k] = value;
    }
    return out;
  }

  numbers(n: number, scale: Scale): Float32Array {
    return Float32Array.from(this.integers(n), (q) => scale.lo + scale.step * q);
  }

  pose(n: number, scale: Scale): PoseTrack {
    return Array.from({ length: 7 }, (_, i) => this.numbers(n, i < 3 ? scale : UNIT));
  }
}

interface Versioned {
  format: string;
  version: number;
}

async function open<T extends Versioned>(id: string, format: string): Promise<[T, Uint8Array]> {
  await parsed;
  const bytes = await inflate(id);
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as T;
  if (header.format !== format || header.version !== VERSION) {
    throw new Error(`this page reads ${format}s of version ${VERSION}, and ${id} is of version ${header.version}`);
  }
  return [header, bytes.subarray(4 + length)];
}

interface MeshHeader extends Versioned {
  vertices: number;
  triangles: number;
  scales: [Scale, Scale, Scale];
}

export async function decodeMesh(id: string): Promise<Mesh> {
  const [header, bytes] = await open<MeshHeader>(id, 'handhold mesh');
  const { vertices, triangles } = header;
  const reader = new ColumnReader(bytes, 3 * vertices + 6 * triangles);
  const axes = header.scales.map((s) => reader.numbers(vertices, s));
  const positions = Float32Array.from({ length: 3 * vertices }, (_, i) => axes[i % 3]![Math.floor(i / 3)]!);
  const low = reader.integers(3 * triangles);
  const high = reader.integers(3 * triangles);
  return { positions, indices: Uint32Array.from(low, (v, i) => v + 65536 * high[i]!) };
}

function timesOf(t: Header['t']): Float64Array {
  return 'list' in t ? Float64Array.from(t.list) : Float64Array.from({ length: t.n }, (_, k) => k * t.dt);
}

export async function decodeRecording(id: string): Promise<Recording> {
  const [header, bytes] = await open<Header>(id, 'handhold recording');
  const t = timesOf(header.t);
  const n = t.length;
  const poses = header.bodies.length + header.hands.reduce((sum, h) => sum + h.shown.length, 0);
  const columns = 7 * poses + 6 * header.contacts.length + header.energy.length + (header.cost ? 1 : 0);
  const reader = new ColumnReader(bytes, n * columns);
  const handPoses = header.hands.map((h) => new Map(h.shown.map((p) => [p, reader.pose(n, h.scale)])));
  const bodyPoses = header.bodies.map(() => reader.pose(n, header.position));
  const contacts = header.contacts.map((track, i): Contact => ({
    track,
    columns: Array.from({ length: 6 }, (_, c) => reader.numbers(n, c < 3 ? header.anchor : header.force)),
    mode: bytes.subarray((2 * columns + i) * n, (2 * columns + i + 1) * n),
  }));
  const energies = header.energy.map((scale) => reader.numbers(n, scale));
  const frameTimes = header.cost && reader.numbers(n, header.cost);
  return { ...header, t, handPoses, bodyPoses, contacts, energies, frameTimes };
}

/** Index of the last frame at or before `time`. */
export function frameAt(t: ArrayLike<number>, time: number): number {
  let lo = 0;
  let hi = t.length - 1;
  while (lo < hi) {
    const mid = (lo + hi + 1) >> 1;
    if (t[mid]! <= time + 1e-9) lo = mid;
    else hi = mid - 1;
  }
  return lo;
}

/** Between the frames along a straight line; NaN where either end is missing. */
export function sample(t: ArrayLike<number>, values: ArrayLike<number | null>, time: number): number {
  const k = frameAt(t, time);
  const next = Math.min(k + 1, t.length - 1);
  const span = t[next]! - t[k]!;
  const from = values[k] ?? NaN;
  if (span <= 0) return from;
  return from + ((values[next] ?? NaN) - from) * Math.min(1, Math.max(0, (time - t[k]!) / span));
}

const FINGERS = ['thumb', 'index', 'middle', 'ring', 'little'];
const BONES = ['proximal', 'interm.', 'distal'];
const OF_BODY = 255;

/** "index distal", with the hand's number where there are several; "body 2" for a sample of a body's surface. */
export function phalanxName([hand, phalanx]: Track, hands: number): string {
  if (hand === OF_BODY) return `body ${phalanx + 1}`;
  const finger = FINGERS[Math.floor(phalanx / 3)];
  const bone = finger === 'thumb' && phalanx === 0 ? 'metacarpal' : finger === 'thumb' && phalanx === 1
    ? 'proximal' : BONES[phalanx % 3];
  return `${hands > 1 ? `${hand + 1}: ` : ''}${finger ? `${finger} ${bone}` : 'palm'}`;
}
