// SPDX-License-Identifier: GPL-3.0-or-later
import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import type { Scene } from 'three';
import { Mode, type Contact } from '../packed';
import { patchesOf } from '../patches';
import { anchorOf } from './markers';

const UP = new Vector3(0, 1, 0);
/** Length of the head, in shaft radii. */
const HEAD = 9;

interface Arrow {
  group: Group;
  shaft: Mesh;
  head: Mesh;
}

function sumOf(patch: readonly Contact[], k: number): Vector3 {
  const out = new Vector3();
  for (const c of patch) {
    if (c.mode[k]! < Mode.stick) continue;
    out.x += c.columns[3]![k]!;
    out.y += c.columns[4]![k]!;
    out.z += c.columns[5]![k]!;
  }
  return out;
}

/** The largest force of a patch in all of the contacts, N. */
export function largestForce(contacts: readonly Contact[]): number {
  let most = 0;
  for (const patch of patchesOf(contacts).values()) {
    const frames = patch[0]!.mode.length;
    for (let k = 0; k < frames; ++k) most = Math.max(most, sumOf(patch, k).length());
  }
  return most;
}

/** One arrow a phalanx: the sum of its samples' forces on the object, pushing on the middle of the patch. */
export class Forces {
  private readonly arrows = new Map<string, Arrow>();
  private readonly material: MeshBasicMaterial;
  private readonly thick: number;
  private readonly metresPerNewton: number;

  constructor(private readonly scene: Scene, colour: string, radius: number, largest: number) {
    this.metresPerNewton = (0.5 * radius) / (largest || 1);
    this.thick = 0.012 * radius;
    this.material = new MeshBasicMaterial({ color: colour, depthTest: false, transparent: true });
  }

  set(contacts: readonly Contact[], k: number, bodies: readonly Group[]): void {
    for (const { group } of this.arrows.values()) group.visible = false;
    for (const [key, patch] of patchesOf(contacts)) {
      const live = patch.filter((c) => c.mode[k]! >= Mode.stick);
      const force = sumOf(live, k);
      const length = force.length() * this.metresPerNewton;
      if (live.length === 0 || length < 1e-4) continue;
      const middle = new Vector3();
      const anchor = new Vector3();
      for (const c of live) middle.add(anchorOf(c, k, bodies, anchor));
      this.point(this.arrow(key), middle.divideScalar(live.length), force.normalize(), length);
    }
  }

  private arrow(key: string): Arrow {
    const known = this.arrows.get(key);
    if (known) return known;
    const { thick, material } = this;
    const shaft = new Mesh(new CylinderGeometry(thick, thick, 1, 10).translate(0, -0.5, 0), material);
    const cone = new ConeGeometry(3.2 * thick, HEAD * thick, 14).translate(0, (-HEAD / 2) * thick, 0);
    const head = new Mesh(cone, material);
    const group = new Group();
    group.add(shaft, head);
    shaft.renderOrder = head.renderOrder = 9;
    this.scene.add(group);
    this.arrows.set(key, { group, shaft, head });
    return { group, shaft, head };
  }

  /** A short force keeps the shape of an arrow. */
  private point({ group, shaft, head }: Arrow, tip: Vector3, direction: Vector3, length: number): void {
    const small = Math.min(1, length / (1.5 * HEAD * this.thick));
    group.visible = true;
    group.position.copy(tip);
    group.quaternion.setFromUnitVectors(UP, direction);
    head.scale.setScalar(small);
    const covered = 0.6 * HEAD * this.thick * small;
    shaft.scale.set(small, Math.max(1e-6, length - covered), small);
    shaft.position.y = -covered;
  }
}
