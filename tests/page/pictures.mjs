// SPDX-License-Identifier: GPL-3.0-or-later
// Screenshots of the page's main views. node pictures.mjs REPORT OUT README_PICTURE
import { copyFileSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch, open, PHONE, shown, WIDE } from './browser.mjs';

const [report, out, readme] = process.argv.slice(2);
const { cases } = JSON.parse(readFileSync(join(report, 'results.json'), 'utf8'));
const of = (id) => (cases.some((c) => c.id === id) ? id : cases[0].id);
const replay = `#case=${of('D04')}&engine=realtime&t=0.277`;

const PICTURES = [
  ['verdict', { size: WIDE }, '#verdict'],
  ['verdict-dark', { size: WIDE, scheme: 'dark' }, '#verdict'],
  ['engines', { size: WIDE }, '#engines'],
  ['case', { size: WIDE, hash: replay }, ''],
  ['case-dark', { size: WIDE, scheme: 'dark', hash: replay }, ''],
  ['case-below', { size: WIDE, hash: replay }, '.case-below'],
  ['case-phone', { size: PHONE, hash: replay }, ''],
  ['engines-phone', { size: PHONE }, '#engines'],
];

mkdirSync(out, { recursive: true });
const browser = await launch();
for (const [name, options, place] of PICTURES) {
  const tab = await open(browser, report, options);
  if (place) await tab.evaluate((selector) => document.querySelector(selector).scrollIntoView(), place);
  else await shown(tab);
  await tab.waitForTimeout(500);
  await tab.screenshot({ path: join(out, `${name}.png`) });
  console.log(join(out, `${name}.png`));
  await tab.context().close();
}
await browser.close();
if (readme) copyFileSync(join(out, 'case.png'), readme);
