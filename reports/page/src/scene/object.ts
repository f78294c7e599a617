// SPDX-License-Identifier: GPL-3.0-or-later
import {
  BufferAttribute, BufferGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial,
  MeshStandardMaterial,
} from 'three';
import { toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { Mesh as PackedMesh } from '../packed';

/** Smooth below this angle, radians; edges are drawn above the other, degrees. */
const CREASE = 0.7;
const EDGE = 35;

export interface Look {
  object: string;
  edge: string;
  ghost: string;
}

interface Shape {
  smooth: BufferGeometry;
  edges: EdgesGeometry;
}

export function shapeOf(mesh: PackedMesh): Shape {
  const indexed = new BufferGeometry();
  indexed.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  indexed.setIndex(new BufferAttribute(mesh.indices, 1));
  return { smooth: toCreasedNormals(indexed, CREASE), edges: new EdgesGeometry(indexed, EDGE) };
}

export function bodyOf({ smooth, edges }: Shape, look: Look): Group {
  const material = new MeshStandardMaterial({
    color: look.object, roughness: 0.78, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const lines = new LineBasicMaterial({ color: look.edge, transparent: true, opacity: 0.55 });
  return new Group().add(new Mesh(smooth, material), new LineSegments(edges, lines));
}

/** A ghost lies a little behind an object at the same place, so that it shows only where the two part. */
export function ghostOf({ smooth, edges }: Shape, look: Look): Group {
  const veil = new Mesh(smooth, new MeshBasicMaterial({
    color: look.ghost, transparent: true, opacity: 0.22, depthWrite: false,
    polygonOffset: true, polygonOffsetFactor: 3, polygonOffsetUnits: 60,
  }));
  const outline = new LineSegments(edges, new LineBasicMaterial({ color: look.ghost, transparent: true }));
  veil.renderOrder = 4;
  outline.renderOrder = 5;
  return new Group().add(veil, outline);
}
