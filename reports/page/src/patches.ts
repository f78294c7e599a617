// SPDX-License-Identifier: GPL-3.0-or-later
import type { Contact } from './packed';

/** Contacts by hand and phalanx. */
export function patchesOf(contacts: readonly Contact[]): Map<string, Contact[]> {
  const out = new Map<string, Contact[]>();
  for (const c of contacts) {
    const key = `${c.track[0]}.${c.track[1]}`;
    const patch = out.get(key);
    if (patch) patch.push(c);
    else out.set(key, [c]);
  }
  return out;
}
