#include "reports/page_parts.hpp"

namespace handhold::reports {

// Curves: Okabe and Ito's colours, which stay apart for colour-blind eyes; dashes and marks tell them apart without
// colour.
std::string_view page_style() {
  return R"css(
:root {
  color-scheme: light dark;
  --paper: #fdfdfc; --raised: #f4f4f1; --ink: #1c1d1f; --quiet: #5a5d63; --rule: #dcdcd6; --grid: #e7e7e2;
  --pass: #0b6b3a; --fail: #b3261e; --vacuous: #8a5a00; --pass-soft: #e6f2ea; --fail-soft: #fbe9e7; --vacuous-soft: #fbf0da;
  --truth: #3a3d42; --reference: #0072b2; --realtime: #c44e00; --guide: #8a8d93;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16181b; --raised: #1f2226; --ink: #e8e8e5; --quiet: #a3a7ae; --rule: #353a40; --grid: #2a2e33;
    --pass: #6fcf97; --fail: #ff8a80; --vacuous: #f2c062; --pass-soft: #17301f; --fail-soft: #3a1b19; --vacuous-soft: #372a10;
    --truth: #d5d7da; --reference: #56b4e9; --realtime: #ef9b3f; --guide: #7d828a;
  }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; scroll-behavior: smooth; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 1rem/1.6 system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", Arial, sans-serif; }
main { max-width: 74rem; margin: 0 auto; padding: 2.5rem clamp(1rem, 4vw, 3rem) 6rem; }
p, .prose { max-width: 46rem; }
h1 { font-size: clamp(1.35rem, 1rem + 1.8vw, 1.9rem); line-height: 1.25; margin: 0 0 .6rem; letter-spacing: -.01em; text-wrap: balance; }
h2 { font-size: 1.35rem; line-height: 1.3; margin: 0 0 1rem; letter-spacing: -.005em; }
h3 { font-size: 1.05rem; margin: 2.2rem 0 .6rem; }
h4 { font-size: .95rem; margin: 0 0 .35rem; font-weight: 600; color: var(--ink); }
a { color: var(--reference); text-underline-offset: .15em; }
a:focus-visible, summary:focus-visible, .scroll:focus-visible { outline: 2px solid var(--reference); outline-offset: 3px; border-radius: 2px; }
section { margin-top: 3.5rem; padding-top: 2.2rem; border-top: 1px solid var(--rule); }
.verdict { border-left: .35rem solid; padding: 1.1rem 1.4rem; border-radius: .25rem; }
.verdict.pass { border-color: var(--pass); background: var(--pass-soft); }
.verdict.fail { border-color: var(--fail); background: var(--fail-soft); }
.verdict p { margin: 0; }
.quiet, .source { color: var(--quiet); }
.source { display: block; font-size: .8rem; font-weight: 400; line-height: 1.45; }
.tag { display: inline-block; font-size: .78rem; font-weight: 600; white-space: nowrap; padding: .05rem .5rem; border-radius: 1rem; }
.tag.pass { color: var(--pass); background: var(--pass-soft); }
.tag.fail { color: var(--fail); background: var(--fail-soft); }
.tag.vacuous { color: var(--vacuous); background: var(--vacuous-soft); }
.scroll { overflow-x: auto; margin: .6rem 0 1.4rem; }
table { border-collapse: collapse; width: 100%; font-size: .86rem; line-height: 1.45; }
caption { text-align: left; color: var(--quiet); padding-bottom: .5rem; font-size: .86rem; }
th, td { text-align: left; vertical-align: top; padding: .5rem .9rem .5rem 0; border-bottom: 1px solid var(--rule); }
thead th { color: var(--quiet); font-weight: 600; font-size: .78rem; vertical-align: bottom; border-bottom-color: var(--quiet); }
tbody th { font-weight: 600; min-width: 11rem; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.wide { min-width: 15rem; }
.use { padding-left: .6rem; min-width: 10.5rem; }
.bad { color: var(--fail); font-weight: 600; }
.bar { display: block; position: relative; width: 9rem; height: .55rem; margin: .42rem 0 .2rem; background: var(--raised); border: 1px solid var(--rule); }
.bar i { position: absolute; left: 0; top: 0; bottom: 0; background: var(--pass); }
.bar.vacuous i { background: var(--vacuous); }
.bar.fail i { background: repeating-linear-gradient(135deg, var(--fail) 0 4px, transparent 4px 7px); border-right: 2px solid var(--fail); }
.bar b { position: absolute; left: 80%; top: -.3rem; bottom: -.3rem; border-left: 2px solid var(--ink); }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .3rem 1.4rem; margin: 1rem 0; font-size: .88rem; }
dt { color: var(--quiet); }
dd { margin: 0; overflow-wrap: anywhere; }
pre { background: var(--raised); border: 1px solid var(--rule); border-radius: .3rem; padding: .8rem 1rem; overflow-x: auto; font-size: .85rem; line-height: 1.5; max-width: 100%; white-space: pre-wrap; overflow-wrap: anywhere; }
code, pre { font-family: ui-monospace, "SF Mono", "DejaVu Sans Mono", Menlo, Consolas, monospace; }
.contents { list-style: none; margin: 1.2rem 0 0; padding: 0; display: grid; grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); gap: .15rem 2rem; }
.contents li { display: flex; align-items: flex-start; justify-content: space-between; gap: .8rem; padding: .4rem 0; border-bottom: 1px solid var(--rule); font-size: .9rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 2rem 2.5rem; margin: 1.2rem 0 2rem; }
figure { margin: 0; max-width: 38rem; min-width: 0; }
figcaption { font-size: .86rem; color: var(--quiet); margin-bottom: .5rem; }
.legend { display: flex; flex-wrap: wrap; gap: .2rem 1.2rem; list-style: none; margin: .2rem 0 .3rem; padding: 0; color: var(--ink); }
.legend li { display: inline-flex; align-items: center; gap: .45rem; }
svg.plot { width: 100%; height: auto; display: block; overflow: visible; }
svg text { fill: var(--ink); font-size: 13.5px; font-family: inherit; }
svg text.tick { fill: var(--quiet); font-size: 12.5px; font-variant-numeric: tabular-nums; }
svg .axis { fill: none; stroke: var(--quiet); stroke-width: 1; }
svg .grid { fill: none; stroke: var(--grid); stroke-width: 1; }
svg .line { fill: none; stroke-width: 2; stroke-linejoin: round; }
svg .line.truth { stroke: var(--truth); stroke-width: 4.5; stroke-opacity: .35; }
svg .line.reference { stroke: var(--reference); stroke-dasharray: 8 4; }
svg .line.realtime { stroke: var(--realtime); stroke-dasharray: 2 3; stroke-width: 2.4; }
svg .line.guide { stroke: var(--guide); stroke-width: 1.4; stroke-dasharray: 1 4; stroke-linecap: round; }
svg .mark { stroke: none; }
svg .mark.truth { fill: var(--truth); } svg .mark.reference { fill: var(--reference); } svg .mark.realtime { fill: var(--realtime); }
svg .mark.guide { fill: var(--guide); }
details { margin: 1rem 0; }
summary { cursor: pointer; font-weight: 600; padding: .3rem 0; }
footer { margin-top: 4rem; color: var(--quiet); font-size: .85rem; }
@media (max-width: 40rem) {
  main { padding-top: 1.2rem; }
  svg text { font-size: 20px; } svg text.tick { font-size: 17.5px; }
  dl { grid-template-columns: 1fr; gap: 0; } dd { margin-bottom: .6rem; }
  tbody th { min-width: 9rem; }
}
@media print { section { break-inside: auto; } figure, tr { break-inside: avoid; } .scroll { overflow: visible; } }
)css";
}

}  // namespace handhold::reports
