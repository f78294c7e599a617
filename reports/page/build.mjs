// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the page's frame: program, style and fonts in one HTML file, with places for data that the C++ program fills.
// node build.mjs OUT (run where node_modules lies)
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from 'esbuild';
import subsetFont from 'subset-font';
import temml from 'temml';

const json = (file) => JSON.parse(readFileSync(file, 'utf8'));

/** The folder of an installed package. */
const folderOf = (name) => join('node_modules', ...name.split('/'));

/** TeX of the cases -> MathML. */
function formulas() {
  const options = { displayMode: true, throwOnError: true };
  const lines = (tex) => tex.map((line) => temml.renderToString(line, options)).join('');
  return Object.fromEntries(Object.entries(json('formulas.json')).map(([id, tex]) => [id, lines(tex)]));
}

const BUNDLED = ['preact', 'three', 'uplot', 'temml', 'inter-ui', '@fontsource/stix-two-math'];

function licences() {
  return BUNDLED.map((name) => {
    const files = ['LICENSE', 'LICENSE.txt', 'LICENSE.md'].map((file) => join(folderOf(name), file));
    const text = files.flatMap((file) => { try { return [readFileSync(file, 'utf8')]; } catch { return []; } })[0];
    if (!text) throw new Error(`${name}: has no licence text (add its file name to build.mjs)`);
    return { name, version: json(join(folderOf(name), 'package.json')).version, text };
  });
}

const range = (first, n) => Array.from({ length: n }, (_, i) => String.fromCodePoint(first + i)).join('');
const ASCII = range(32, 95);
const TEXT = `${ASCII}\u00a0±·×÷µμ°²³¹⁰⁴⁵⁶⁷⁸⁹⁻⁺–—‘’“”…−≤≥≈≠√→←↑↓↔∞∑∫πσωτθφργδεκλΔΩαβ✓✗‐‑•◆●○▲▶äöüÄÖÜéèß`;
// Letters of a formula are the italic ones of Unicode's mathematical block.
const MATH = `${ASCII}−±×·⋅∕√≤≥=<>∓°′″∞⟨⟩∫∑∂π→⇒αβγδεζηθικλμνξπρστυφχψωΔΣΩΨϵϕℎ\u2061\u2062⎷|∣ˆ¯˙` +
  range(0x1d434, 52) + range(0x1d6e2, 58);

const FONTS = {
  'font:text': ['inter-ui/variable/InterVariable.woff2', TEXT, {
    variationAxes: { opsz: 16, wght: { min: 400, max: 650, default: 400 } },
  }],
  'font:math': ['@fontsource/stix-two-math/files/stix-two-math-latin-400-normal.woff2', MATH, {}],
};

async function font(name) {
  const [file, letters, options] = FONTS[name];
  return subsetFont(readFileSync(join('node_modules', file)), letters, { targetFormat: 'woff2', ...options });
}

const made = {
  name: 'made',
  setup(build) {
    build.onResolve({ filter: /^(page|font):/ }, ({ path }) => ({ path, namespace: 'made' }));
    build.onLoad({ filter: /^font:/, namespace: 'made' }, async ({ path }) => ({
      contents: await font(path), loader: 'dataurl',
    }));
    build.onLoad({ filter: /^page:/, namespace: 'made' }, ({ path }) => ({
      contents: JSON.stringify(path === 'page:formulas' ? formulas() : licences()), loader: 'json',
    }));
  },
};

const { outputFiles } = await build({
  entryPoints: ['src/main.tsx'], outdir: 'out', bundle: true, minify: true, write: false, format: 'iife',
  target: 'es2022', jsx: 'automatic', jsxImportSource: 'preact', legalComments: 'none', charset: 'utf8',
  plugins: [made], logLevel: 'warning',
});
const textOf = (end) => outputFiles.find((f) => f.path.endsWith(end)).text;
const program = textOf('.js').replaceAll('</script', '<\\/script').replaceAll('<!--', '\\x3c!--');

// The data stands behind the program, the recordings last: the verdict is painted while they are still parsed.
writeFileSync(process.argv[2] ?? 'page.html', `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width,initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title><!--handhold:title--></title>
<style>${textOf('.css')}</style>
</head>
<body>
<div id="app"></div>
<noscript><main><h1><!--handhold:title--></h1><!--handhold:table--></main></noscript>
<script type="text/plain" id="results"><!--handhold:results--></script>
<script type="text/plain" id="times"><!--handhold:times--></script>
<script>${program}</script>
<!--handhold:recordings-->
</body>
</html>
`);
