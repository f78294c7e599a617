// SPDX-License-Identifier: GPL-3.0-or-later
import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import type { Mesh } from '../packed';
import { MODES, type ModeName } from '../scene/markers';
import { Replay, type Theme } from '../scene/replay';
import { Stage, type View } from '../scene/stage';
import { ModeSign } from './ModeSign';
import { cssColour } from './Plot';
import type { Played } from './Strips';
import { useClock } from './time';

const VIEWS: readonly (readonly [View, string])[] = [
  ['three-quarter', 'Default'], ['front', 'Front'], ['side', 'Side'], ['top', 'Top'],
];

function themeOf(ghost: string): Theme {
  return {
    object: cssColour('--object'), edge: cssColour('--object-edge'), hand: cssColour('--hand'), ghost: cssColour(ghost),
    force: cssColour('--force'), grid: cssColour('--scene-grid'), paper: cssColour('--scene'),
    modes: { stick: cssColour('--stick'), slip: cssColour('--slip'), apart: cssColour('--apart') },
  };
}

export interface SceneOptions {
  ghostOn: boolean;
  follow: boolean;
  onGhost: (on: boolean) => void;
  onFollow: (on: boolean) => void;
}

interface Props extends SceneOptions {
  /** of the run: the camera stays while it is the same */
  sceneId: string;
  played: Played;
  meshes: (Mesh | null)[];
  ghost: Played | undefined;
  theme: string;
}

function Tools({ look, ghost, ...options }: SceneOptions & { look: (view: View) => void; ghost: boolean }) {
  return (
    <div class="scene-tools" role="group" aria-label="View">
      {VIEWS.map(([view, name]) => <button type="button" onClick={() => look(view)}>{name}</button>)}
      <button type="button" aria-pressed={options.follow} title="Follow the object (f)"
        onClick={() => options.onFollow(!options.follow)}>Follow</button>
      {ghost && (
        <button type="button" aria-pressed={options.ghostOn} title="Show the other engine's object (g)"
          onClick={() => options.onGhost(!options.ghostOn)}>Ghost</button>
      )}
    </div>
  );
}

/** The 3D replay with its key. */
export function SceneView({ sceneId, played, meshes, ghost, theme, ...options }: Props) {
  const clock = useClock();
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const key = useRef<HTMLDivElement>(null);
  const stage = useRef<Stage | null>(null);
  const shown = useRef('');
  const [failure, setFailure] = useState('');
  const { recording } = played;
  const report = useCallback((counts: Record<ModeName, number>) => {
    for (const [mode] of MODES) {
      const place = key.current?.querySelector(`[data-count=${mode}]`);
      if (place) place.textContent = String(counts[mode]);
    }
  }, []);
  useEffect(() => {
    try {
      stage.current = new Stage(canvas.current!, report);
    } catch (error) {
      setFailure(error instanceof Error ? error.message : String(error));
      return;
    }
    const made = stage.current;
    const fit = ([entry]: ResizeObserverEntry[]): void => {
      if (entry) made.resize(entry.contentRect.width, entry.contentRect.height);
    };
    const observer = new ResizeObserver(fit);
    observer.observe(box.current!);
    const stop = clock.listen((t) => made.seek(t));
    return () => {
      stop();
      observer.disconnect();
      made.dispose();
      stage.current = null;
      shown.current = '';
    };
  }, []);
  useEffect(() => {
    const colours = themeOf(ghost?.engine.colour ?? '--truth');
    stage.current?.show(new Replay(recording, meshes, ghost?.recording ?? null, colours), shown.current === sceneId);
    shown.current = sceneId;
  }, [recording, meshes, ghost?.recording, theme]);
  useEffect(() => {
    if (!stage.current) return;
    stage.current.ghost = options.ghostOn;
    stage.current.follow = options.follow;
    stage.current.redraw();
  }, [options.ghostOn, options.follow, recording]);
  const names = recording.bodies.map((b) => b.name || 'object').join(', ');
  const hands = recording.hands.length;
  return (
    <div class="scene">
      <div class="scene-picture" ref={box}>
        <canvas ref={canvas} role="img" aria-label={`3D view of ${names} and ${hands} hand${hands === 1 ? '' : 's'}`} />
        {failure && <p class="absent">This browser draws no WebGL, so there is no 3D view here: {failure}</p>}
        <Tools look={(view) => stage.current?.look(view)} ghost={ghost !== undefined} {...options} />
      </div>
      <div class="scene-key" ref={key}>
        {recording.contacts.length > 0 && (
          <>
            {(['stick', 'slip', 'apart'] as const).map((mode) => (
              <span><ModeSign mode={mode} />{mode} <b data-count={mode} /></span>
            ))}
            <span><i class="arrow" aria-hidden="true" />force of a phalanx</span>
          </>
        )}
        {ghost && (
          <span>
            <i class="ghost" style={{ '--c': `var(${ghost.engine.colour})` }} aria-hidden="true" />{ghost.engine.name}
          </span>
        )}
        <span>grid 20 mm</span>
        {recording.hands.some((h) => h.patches.length > 0) && (
          <span class="note">Fingers schematic: the case prescribes patches only.</span>
        )}
      </div>
    </div>
  );
}
