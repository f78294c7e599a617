// SPDX-License-Identifier: GPL-3.0-or-later
import { Color, Group, GridHelper, LineBasicMaterial, LineSegments, Mesh, Points, Scene, Vector3 } from 'three';
import type { Mesh as PackedMesh, Recording } from '../packed';
import { Forces, largestForce } from './forces';
import { handOf, type Phalanx } from './hand';
import { Markers, type ModeName } from './markers';
import { bodyOf, ghostOf, shapeOf, type Look } from './object';
import { instantAt, place, positionAt } from './poses';

export interface Theme extends Look {
  hand: string;
  force: string;
  grid: string;
  paper: string;
  modes: Record<ModeName, string>;
}

/** Metres. */
const GRID = 0.02;
const FINGER = 0.022;

/** What there is to see of one recording: bodies, hands, contacts, forces, and another recording as a ghost. */
export class Replay {
  readonly scene = new Scene();
  readonly centre = new Vector3();
  radius = 0.1;
  private readonly bodies: Group[];
  private readonly ghosts: Group[];
  private readonly hands: Phalanx[][];
  private readonly markers: Markers;
  private readonly forces: Forces;

  constructor(
    private readonly recording: Recording, meshes: (PackedMesh | null)[], private readonly ghost: Recording | null,
    theme: Theme,
  ) {
    const shapes = meshes.map((mesh) => mesh && shapeOf(mesh));
    this.bodies = shapes.map((shape) => (shape ? bodyOf(shape, theme) : new Group()));
    this.ghosts = ghost ? shapes.map((shape) => (shape ? ghostOf(shape, theme) : new Group())) : [];
    const inside = recording.bodyPoses[0] ? positionAt(recording.bodyPoses[0], 0) : new Vector3();
    this.hands = recording.hands.map((meta, h) => handOf(meta, recording.handPoses[h]!, inside, theme.hand));
    for (const group of [...this.bodies, ...this.ghosts]) this.scene.add(group);
    for (const { group } of this.hands.flat()) this.scene.add(group);
    this.measure();
    this.addGrid(theme.grid);
    this.markers = new Markers(this.scene, theme.modes, theme.paper);
    const largest = Math.max(largestForce(recording.contacts), ghost ? largestForce(ghost.contacts) : 0);
    this.forces = new Forces(this.scene, theme.force, this.radius, largest);
  }

  /** Poses everything as at `time`; returns how many contact points there are of each mode. */
  seek(time: number, showGhost: boolean): Record<ModeName, number> {
    const now = instantAt(this.recording.t, time);
    this.bodies.forEach((body, j) => place(body, this.recording.bodyPoses[j]!, now));
    if (this.ghost) {
      const then = instantAt(this.ghost.t, time);
      this.ghosts.forEach((ghost, j) => {
        ghost.visible = showGhost;
        place(ghost, this.ghost!.bodyPoses[j]!, then);
      });
    }
    this.hands.forEach((hand, h) => {
      const spans = this.recording.hands[h]!.present;
      const present = spans.some(([begin, end]) => time >= begin - 1e-6 && time <= end + 1e-6);
      for (const { group, track } of hand) {
        group.visible = present;
        place(group, track, now);
      }
    });
    this.scene.updateMatrixWorld();
    this.forces.set(this.recording.contacts, now.k, this.bodies);
    return this.markers.set(this.recording.contacts, now.k, this.bodies);
  }

  /** What a camera follows: the first body. */
  followed(): Vector3 {
    return this.bodies[0]?.position ?? this.centre;
  }

  dispose(): void {
    this.scene.traverse((o) => {
      if (o instanceof Mesh || o instanceof LineSegments || o instanceof Points) o.geometry.dispose();
    });
  }

  /** Looks at where hand and object are together; an object that is dropped leaves the picture. */
  private measure(): void {
    const lo = new Vector3(Infinity, Infinity, Infinity);
    const hi = lo.clone().negate();
    const add = (p: Vector3, r: number): void => {
      lo.min(p.clone().subScalar(r));
      hi.max(p.clone().addScalar(r));
    };
    const phalanges = this.hands.flat();
    const last = this.recording.t.length - 1;
    for (const share of phalanges.length ? [0, 0.25, 0.5] : [0, 0.5, 1]) {
      const k = Math.floor(share * last);
      if (share === 0 || phalanges.length === 0) {
        this.recording.bodyPoses.forEach((track, j) => add(positionAt(track, k), this.sizeOf(j)));
      }
      for (const { track } of phalanges) add(positionAt(track, k), FINGER);
    }
    if (!(lo.x <= hi.x)) return;
    this.centre.copy(lo).add(hi).multiplyScalar(0.5);
    this.radius = lo.distanceTo(hi) / 2;
  }

  private sizeOf(body: number): number {
    const geometry = (this.bodies[body]!.children[0] as Mesh | undefined)?.geometry;
    geometry?.computeBoundingSphere();
    return 0.9 * (geometry?.boundingSphere?.radius ?? 0.05);
  }

  private addGrid(colour: string): void {
    const cells = 2 * Math.ceil(this.radius / GRID);
    const grid = new GridHelper(cells * GRID, cells, new Color(colour), new Color(colour));
    const material = grid.material as LineBasicMaterial;
    grid.rotateX(Math.PI / 2);
    grid.position.copy(this.centre).setZ(this.centre.z - this.radius * 0.72);
    material.transparent = true;
    material.opacity = 0.5;
    this.scene.add(grid);
  }
}
