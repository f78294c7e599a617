// SPDX-License-Identifier: GPL-3.0-or-later
import { BufferAttribute, BufferGeometry, CanvasTexture, Points, PointsMaterial, SRGBColorSpace, Vector3 } from 'three';
import type { Group, Scene } from 'three';
import { Mode, type Contact } from '../packed';

/** Points that are drawn of one mode at most. */
const MOST = 1024;

export type ModeName = 'apart' | 'stick' | 'slip';
export const MODES: readonly (readonly [ModeName, Mode])[] = [
  ['apart', Mode.apart], ['stick', Mode.stick], ['slip', Mode.slip],
];

/** The outline of a mode's sign: a disc that holds, a diamond that slides, a ring that does not touch. */
function outline(c: CanvasRenderingContext2D, mode: ModeName): void {
  c.beginPath();
  if (mode !== 'slip') {
    c.arc(32, 32, mode === 'stick' ? 24 : 16, 0, 2 * Math.PI);
    return;
  }
  c.moveTo(32, 4);
  for (const [x, y] of [[60, 32], [32, 60], [4, 32]] as const) c.lineTo(x, y);
  c.closePath();
}

function sign(mode: ModeName, colour: string, paper: string): CanvasTexture {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const c = canvas.getContext('2d')!;
  outline(c, mode);
  const open = mode === 'apart';
  c.lineWidth = open ? 9 : 7;
  c.fillStyle = colour;
  c.strokeStyle = open ? colour : paper;
  if (!open) c.fill();
  c.stroke();
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

/** Where a contact's anchor lies in the world, on its body as it is posed now. */
export function anchorOf(contact: Contact, k: number, bodies: readonly Group[], out: Vector3): Vector3 {
  const c = contact.columns;
  return out.set(c[0]![k]!, c[1]![k]!, c[2]![k]!).applyMatrix4(bodies[contact.track[2]]!.matrixWorld);
}

/** Contact points, one cloud a mode, on top of everything. */
export class Markers {
  private readonly clouds = new Map<Mode, { points: Points; positions: Float32Array }>();
  private readonly anchor = new Vector3();

  constructor(scene: Scene, colours: Record<ModeName, string>, paper: string) {
    for (const [name, mode] of MODES) {
      const positions = new Float32Array(3 * MOST);
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', new BufferAttribute(positions, 3));
      const points = new Points(geometry, new PointsMaterial({
        size: 10, map: sign(name, colours[name], paper), sizeAttenuation: false, transparent: true, depthTest: false,
      }));
      points.frustumCulled = false;
      points.renderOrder = 10 + mode;
      scene.add(points);
      this.clouds.set(mode, { points, positions });
    }
  }

  /** Returns how many there are of each mode on frame k. */
  set(contacts: readonly Contact[], k: number, bodies: readonly Group[]): Record<ModeName, number> {
    const counts = { stick: 0, slip: 0, apart: 0 };
    for (const [name, mode] of MODES) {
      const { points, positions } = this.clouds.get(mode)!;
      for (const contact of contacts) {
        if (contact.mode[k] !== mode || counts[name] >= MOST) continue;
        anchorOf(contact, k, bodies, this.anchor).toArray(positions, 3 * counts[name]++);
      }
      points.geometry.setDrawRange(0, counts[name]);
      points.geometry.attributes['position']!.needsUpdate = true;
    }
    return counts;
  }
}
