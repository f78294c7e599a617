// SPDX-License-Identifier: GPL-3.0-or-later
import { Quaternion, Vector3 } from 'three';
import type { Object3D } from 'three';
import { frameAt, type PoseTrack } from '../packed';

/** A frame and how far on towards the next one. */
export interface Instant {
  k: number;
  share: number;
}

export function instantAt(t: Float64Array, time: number): Instant {
  const k = frameAt(t, time);
  const span = (t[k + 1] ?? t[k]! + 1) - t[k]!;
  return { k, share: Math.min(1, Math.max(0, (time - t[k]!) / span)) };
}

/** Poses `target` as at that instant: straight lines between the frames. */
export function place(target: Object3D, track: PoseTrack, { k, share }: Instant): void {
  const next = Math.min(k + 1, track[0]!.length - 1);
  const mix = (i: number): number => track[i]![k]! + (track[i]![next]! - track[i]![k]!) * share;
  target.position.set(mix(0), mix(1), mix(2));
  target.quaternion.set(mix(4), mix(5), mix(6), mix(3)).normalize();
}

export const positionAt = (track: PoseTrack, k: number): Vector3 =>
  new Vector3(track[0]![k], track[1]![k], track[2]![k]);

export const rotationAt = (track: PoseTrack, k: number): Quaternion =>
  new Quaternion(track[4]![k], track[5]![k], track[6]![k], track[3]![k]).normalize();
