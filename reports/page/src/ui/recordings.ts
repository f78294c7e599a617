// SPDX-License-Identifier: GPL-3.0-or-later
import { useEffect, useState } from 'preact/hooks';
import type { Engine, Run } from '../model';
import { decodeMesh, decodeRecording, type Mesh } from '../packed';
import type { Played } from './Strips';

export interface Loaded {
  id: string;
  played: Played[];
  /** of the bodies, the same in every recording of a run */
  meshes: (Mesh | null)[];
}

async function load(id: string, engines: readonly Engine[], run: Run): Promise<Loaded> {
  const kept = run.plays.filter((p) => p.recording);
  const all = await Promise.all(kept.map(async (p) => ({
    engine: engines.find((e) => e.name === p.engine), recording: await decodeRecording(p.recording!),
  })));
  const played = all.filter((p): p is Played => p.engine !== undefined && p.recording.t.length > 0);
  const bodies = played[0]?.recording.bodies ?? [];
  return { id, played, meshes: await Promise.all(bodies.map((b) => (b.mesh ? decodeMesh(b.mesh) : null))) };
}

/** Decodes a run when it is looked at; keeps the one before on screen until then. */
export function useRecordings(
  id: string, engines: readonly Engine[], run: Run, near: boolean,
): [Loaded | null, string] {
  const [loaded, setLoaded] = useState<Loaded | null>(null);
  const [failure, setFailure] = useState('');
  useEffect(() => {
    let current = true;
    if (near) {
      load(id, engines, run).then(
        (all) => { if (current) { setFailure(''); setLoaded(all); } },
        (error: unknown) => { if (current) setFailure(error instanceof Error ? error.message : String(error)); },
      );
    }
    return () => { current = false; };
  }, [id, near]);
  return [loaded, failure];
}
