// SPDX-License-Identifier: GPL-3.0-or-later
import {
  AmbientLight, DirectionalLight, Group, HemisphereLight, PerspectiveCamera, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { ModeName } from './markers';
import type { Replay } from './replay';

export type View = 'three-quarter' | 'front' | 'side' | 'top';
const DIRECTIONS: Record<View, Vector3> = {
  'three-quarter': new Vector3(1, -0.5, 0.36), front: new Vector3(1, 0, 0.04), side: new Vector3(0, -1, 0.04),
  top: new Vector3(0.01, 0, 1),
};

function lights(): Group {
  const key = new DirectionalLight(0xffffff, 2.2);
  const rim = new DirectionalLight(0xffffff, 0.8);
  const sky = new HemisphereLight(0xffffff, 0xb9b4a8, 1.7);
  key.position.set(1, -0.9, 1.6);
  rim.position.set(-1, 1, 0.4);
  sky.position.set(0, 0, 1);
  return new Group().add(key, rim, sky, new AmbientLight(0xffffff, 0.25));
}

/** The camera and the canvas: shows a replay at an instant, knows nothing of time or of the page. */
export class Stage {
  ghost = true;
  follow = false;
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera(28, 1, 0.005, 20);
  private readonly controls: OrbitControls;
  private readonly lights = lights();
  private replay: Replay | null = null;
  private instant = 0;
  private wanted = false;

  constructor(canvas: HTMLCanvasElement, private readonly onDraw: (counts: Record<ModeName, number>) => void) {
    // Kept after drawing, so that a picture of the page has the scene in it.
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableZoom = matchMedia('(pointer: fine)').matches;
    this.controls.addEventListener('change', () => this.redraw());
  }

  /** Shows another replay; the camera stays where it is if it looks at the same scene. */
  show(replay: Replay, sameScene: boolean): void {
    this.replay?.dispose();
    this.replay = replay;
    replay.scene.add(this.lights);
    if (!sameScene) this.look('three-quarter');
    this.redraw();
  }

  seek(t: number): void {
    this.instant = t;
    this.redraw();
  }

  resize(width: number, height: number): void {
    if (!(width > 0 && height > 0)) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  look(view: View): void {
    if (!this.replay) return;
    const { centre, radius } = this.replay;
    const distance = (0.9 * radius) / Math.sin((this.camera.fov * Math.PI) / 360) / Math.min(1, this.camera.aspect);
    this.camera.near = 0.2 * distance;
    this.camera.far = 20 * distance;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(centre);
    this.camera.position.copy(DIRECTIONS[view]).normalize().multiplyScalar(distance).add(centre);
    this.controls.update();
    this.redraw();
  }

  /** Draws once a display frame at most, and only when something changed. */
  redraw(): void {
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      this.draw();
    });
  }

  dispose(): void {
    this.controls.dispose();
    this.replay?.dispose();
    this.replay = null;
    this.renderer.dispose();
  }

  private draw(): void {
    if (!this.replay) return;
    const counts = this.replay.seek(this.instant, this.ghost);
    if (this.follow) {
      this.camera.position.sub(this.controls.target).add(this.replay.followed());
      this.controls.target.copy(this.replay.followed());
    }
    this.renderer.render(this.replay.scene, this.camera);
    this.onDraw(counts);
  }
}
