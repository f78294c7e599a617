// SPDX-License-Identifier: GPL-3.0-or-later
import {
  CapsuleGeometry, GreaterDepth, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, Quaternion, Vector3,
} from 'three';
import type { BufferGeometry, Material } from 'three';
import { RoundedBoxGeometry } from 'three/examples/jsm/geometries/RoundedBoxGeometry.js';
import type { HandMeta, PoseTrack } from '../packed';
import { positionAt, rotationAt } from './poses';

const PALM = 15;
const Y = new Vector3(0, 1, 0);
const Z = new Vector3(0, 0, 1);

/** Where a shape lies in its phalanx's frame. */
interface Offset {
  position: Vector3;
  rotation: Quaternion;
}

export interface Phalanx {
  group: Group;
  track: PoseTrack;
}

/** A translucent hand: depth first, colour after, so that overlapping capsules read as one skin. */
function skinOf(colour: string): Material[] {
  return [
    new MeshBasicMaterial({
      color: colour, transparent: true, opacity: 0.2, depthFunc: GreaterDepth, depthWrite: false,
    }),
    new MeshBasicMaterial({ colorWrite: false, transparent: true }),
    new MeshStandardMaterial({ color: colour, roughness: 0.85, transparent: true, opacity: 0.62 }),
  ];
}

function shapeOf(meta: HandMeta, phalanx: number): BufferGeometry {
  if (phalanx === PALM) {
    const [x, y, z] = meta.palm;
    return new RoundedBoxGeometry(2 * x, 2 * y, 2 * z, 5, 0.7 * Math.min(x, y, z));
  }
  const [half, radius] = meta.capsules[phalanx]!;
  return new CapsuleGeometry(radius, 2 * half, 8, 28).rotateX(Math.PI / 2);
}

/** Unit normal of the plane or the line through the points, away from `inside`. */
function outward(points: readonly Vector3[], middle: Vector3, inside: Vector3): Vector3 {
  const away = middle.clone().sub(inside);
  let normal = new Vector3();
  for (const a of points) {
    for (const b of points) {
      const cross = a.clone().sub(middle).cross(b.clone().sub(middle));
      if (cross.length() > normal.length()) normal = cross;
    }
  }
  const spokes = points.map((p) => p.clone().sub(middle));
  const span = spokes.reduce((a, b) => (b.length() > a.length() ? b : a), new Vector3());
  if (normal.length() < 1e-3 * span.lengthSq() || normal.length() === 0) {  // one point, or points on a line
    normal = span.length() > 0 ? away.clone().projectOnPlane(span.normalize()) : away.clone();
  }
  return normal.normalize().multiplyScalar(normal.dot(away) < 0 ? -1 : 1);
}

/** A case that prescribes a patch says nothing of the finger behind it: it is drawn with its pad on the patch. */
function behindPatch(meta: HandMeta, phalanx: number, points: readonly Vector3[], X: Offset, inside: Vector3): Offset {
  const world = points.map((p) => p.clone().applyQuaternion(X.rotation).add(X.position));
  const middle = world.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(world.length);
  const normal = outward(world, middle, inside);
  const back = X.rotation.clone().invert();
  const into = (position: Vector3, rotation: Quaternion): Offset => ({
    position: position.sub(X.position).applyQuaternion(back), rotation: back.clone().multiply(rotation),
  });
  if (phalanx === PALM) {
    const centre = middle.addScaledVector(normal, meta.palm[1]);
    return into(centre, new Quaternion().setFromUnitVectors(Y, normal));
  }
  const [half, radius] = meta.capsules[phalanx]!;
  const axis = Math.abs(normal.z) > 0.9 ? new Vector3(1, 0, 0) : new Vector3(normal.y, -normal.x, 0).normalize();
  if (axis.x > 0) axis.negate();
  axis.projectOnPlane(normal).normalize();
  const centre = middle.addScaledVector(normal, radius).addScaledVector(axis, 0.6 * half);
  return into(centre, new Quaternion().setFromUnitVectors(Z, axis));
}

/** The phalanges of one hand, each with its poses; `inside` is a point of the object at the start. */
export function handOf(meta: HandMeta, tracks: Map<number, PoseTrack>, inside: Vector3, colour: string): Phalanx[] {
  const skin = skinOf(colour);
  const patches = new Map(meta.patches.map((p) => [p.phalanx, p.points.map((v) => new Vector3(...v))]));
  return meta.shown.map((phalanx) => {
    const track = tracks.get(phalanx)!;
    const geometry = shapeOf(meta, phalanx);
    const shape = new Group();
    skin.forEach((material, i) => {
      const part = new Mesh(geometry, material);
      part.renderOrder = 1 + i;
      shape.add(part);
    });
    const points = patches.get(phalanx);
    if (points?.length) {
      const start = { position: positionAt(track, 0), rotation: rotationAt(track, 0) };
      const { position, rotation } = behindPatch(meta, phalanx, points, start, inside);
      shape.position.copy(position);
      shape.quaternion.copy(rotation);
    }
    const group = new Group();
    group.add(shape);
    return { group, track };
  });
}
