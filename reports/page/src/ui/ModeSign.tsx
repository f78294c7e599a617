// SPDX-License-Identifier: GPL-3.0-or-later
import type { ModeName } from '../scene/markers';

/** The sign of a contact mode as in the 3D view: disc, diamond, ring. */
export function ModeSign({ mode }: { mode: ModeName }) {
  return (
    <svg class={`sign mode-${mode}`} width="12" height="12" viewBox="-6 -6 12 12" aria-hidden="true">
      {mode === 'slip' ? <path d="M0 -5L5 0L0 5L-5 0Z" /> : <circle r={mode === 'stick' ? 4.5 : 3.6} />}
    </svg>
  );
}
