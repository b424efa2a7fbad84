#include "html_parts.h"

namespace heed::report {

namespace {

/// Bars: Okabe and Ito's palette, darkened on white until each has 3:1 against the paper, and apart in
/// lightness as well. \cite okabe.08.jfly
constexpr std::string_view colours = R"css(
:root {
  color-scheme: light dark;
  --paper: #fdfcfa; --panel: #f5f3ee; --ink: #1b1d20; --soft: #575b62; --line: #ddd9d0; --link: #00568a;
  --good: #0b6b45; --bad: #a33b00; --sign: #b3261e;
  --k0: #0072b2; --k1: #85888d; --k2: #c97a00; --k3: #00855f; --k4: #a64d86; --heat: 213 94 0;
  --gentle: #0072b2; --firm: #b06a00; --emergency: #b3261e;
  --serif: Charter, "Bitstream Charter", "Iowan Old Style", Palatino, "Palatino Linotype", "Source Serif 4", Georgia, "DejaVu Serif", serif;
  --sans: "Source Sans 3", "Segoe UI", "Helvetica Neue", Roboto, Cantarell, "Noto Sans", "DejaVu Sans", sans-serif;
  --mono: "JetBrains Mono", "Cascadia Mono", "SF Mono", Consolas, "Liberation Mono", "DejaVu Sans Mono", monospace;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #15171a; --panel: #1d2024; --ink: #eae7e0; --soft: #a9abaf; --line: #353940; --link: #84c5f0;
    --good: #6fcf9f; --bad: #ffa36b; --sign: #ff8a80;
    --k0: #56b4e9; --k1: #8f9297; --k2: #e69f00; --k3: #2fb58c; --k4: #cc79a7; --heat: 230 120 40;
    --gentle: #56b4e9; --firm: #e69f00; --emergency: #ff8a80;
  }
}
)css";

constexpr std::string_view text = R"css(
* { box-sizing: border-box; }
html { background: var(--paper); color: var(--ink); -webkit-text-size-adjust: 100%; }
body { margin: 0; font: 1rem/1.6 var(--sans); overflow-wrap: anywhere; }
main, .hero, .contents, footer { max-width: 76rem; margin-inline: auto; padding-inline: clamp(1rem, 4vw, 3rem); }
p, li, dd { max-width: 68ch; }
p { margin: 0 0 1em; }
a { color: var(--link); text-underline-offset: .18em; }
code { font: .86em/1.5 var(--mono); }
h1 { font: 600 clamp(1.6rem, 1.2rem + 1.9vw, 2.5rem)/1.2 var(--serif); letter-spacing: -.012em; max-width: 27em; margin: .2em 0 .5em; text-wrap: balance; }
h2 { font: 600 clamp(1.35rem, 1.15rem + .9vw, 1.8rem)/1.25 var(--serif); margin: 0 0 .4em; }
h3 { font: 600 1.02rem/1.4 var(--sans); margin: 1.6em 0 .5em; }
.hero { padding-top: clamp(2rem, 6vw, 4.5rem); padding-bottom: 1rem; }
.eyebrow { color: var(--soft); font-size: .84rem; letter-spacing: .04em; margin: 0; }
.lede { font-size: 1.13rem; color: var(--soft); }
.intro { color: var(--soft); }
.answer { display: grid; gap: 2rem 4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 25rem), 1fr)); align-items: start; margin-top: 2rem; }
.answer ul { margin: 0; padding: 0; list-style: none; }
.answer li { padding: .62em 0; border-top: 1px solid var(--line); }
.contents { margin-block: 1.5rem 0; font-size: .92rem; }
.contents ul { list-style: none; margin: 0; padding: .8em 0; display: flex; flex-wrap: wrap; gap: .3em 1.5em; border-block: 1px solid var(--line); }
section { padding-block: clamp(2.2rem, 5vw, 3.6rem) .5rem; }
footer { color: var(--soft); font-size: .88rem; padding-block: 2.5rem 3.5rem; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
)css";

constexpr std::string_view tables = R"css(
.scroll { overflow-x: auto; max-width: 100%; margin-block: 1rem; }
table { border-collapse: collapse; font-size: .93rem; font-variant-numeric: tabular-nums; line-height: 1.4; overflow-wrap: normal; }
.scroll table { min-width: max(100%, 42rem); }
.scroll .misses, .pairs .scroll table { min-width: 100%; }
caption span { display: block; position: sticky; left: 0; max-width: min(68ch, calc(100vw - 2.2rem)); }
caption { text-align: left; color: var(--soft); padding-bottom: .6em; font-size: .9rem; }
th, td { padding: .5em .8em; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th:first-child { padding-left: .2em; }
thead th { font-weight: 600; font-size: .86rem; color: var(--soft); vertical-align: bottom; border-bottom-color: var(--soft); }
tbody th { font-weight: 500; }
.n { text-align: right; white-space: nowrap; }
.exact { display: block; color: var(--soft); font-size: .8rem; }
.misses td { font: 500 1.35rem/1.2 var(--serif); text-align: right; white-space: nowrap; }
.misses th[scope=col] { text-align: right; }
.misses th:first-child { text-align: left; }
.misses .subject th, .misses .subject td { font-weight: 700; }
.misses { width: 100%; }
.rule { min-width: 10.5rem; }
@media (max-width: 40rem) { .misses th, .misses td { padding: .5em .3em; } .misses td { font-size: 1.08rem; } }
.who { display: inline-flex; align-items: baseline; gap: .5em; }
.swatch { flex: none; width: .75em; height: .75em; border-radius: .15em; background: var(--swatch); }
.k0 { --swatch: var(--k0); } .k1 { --swatch: var(--k1); } .k2 { --swatch: var(--k2); } .k3 { --swatch: var(--k3); } .k4 { --swatch: var(--k4); }
.errors th, .errors td { padding: .42em .5em; }
.errors tbody th[scope=row] { min-width: 9rem; max-width: 17rem; position: sticky; left: 0; background: var(--paper); }
.errors thead th.n { white-space: normal; font-size: .78rem; font-weight: 500; min-width: 3.4rem; line-height: 1.25; }
.errors thead .who { flex-direction: column; align-items: flex-end; gap: .3em; }
td code { white-space: nowrap; }
#method td code { white-space: normal; overflow-wrap: anywhere; }
.errors tbody .other:not(.n) { font-size: .84rem; line-height: 1.55; white-space: nowrap; }
.errors .group { color: var(--soft); font-weight: 600; font-size: .84rem; padding-top: 1.4em; background: none; }
.errors .what { display: block; color: var(--soft); font-size: .8rem; font-weight: 400; }
.errors .first, .errors thead .first { border-left: 1px solid var(--line); }
.errors .zero, .errors .other { color: var(--soft); }
.h1 { background: rgb(var(--heat) / .08); } .h2 { background: rgb(var(--heat) / .16); } .h3 { background: rgb(var(--heat) / .25); }
.h4 { background: rgb(var(--heat) / .34); } .h5 { background: rgb(var(--heat) / .44); }
)css";

constexpr std::string_view parts = R"css(
.facts { display: flex; flex-wrap: wrap; gap: .8rem 2.4rem; margin: 0 0 1.4rem; }
.facts div { min-width: 5rem; }
.facts dt { color: var(--soft); font-size: .84rem; }
.facts dd { margin: 0; font: 500 1.35rem/1.3 var(--serif); }
.list { list-style: none; padding: 0; margin: .4rem 0 0; display: grid; gap: 0 3.5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 28rem), 1fr)); }
.list li { break-inside: avoid; min-width: 0; max-width: none; padding: .65em 0; border-top: 1px solid var(--line); }
.list p { margin: .15em 0 0; }
.because { color: var(--soft); font-size: .87rem; }
.place, .origin { color: var(--soft); font-size: .84rem; }
.place { white-space: nowrap; }
.list .origin { float: right; margin-left: 1em; max-width: 60%; overflow-wrap: anywhere; text-align: right; }
details { padding: .5rem 0 1rem; }
summary { cursor: pointer; font-weight: 600; padding: .25em 0; }
summary .place { font-weight: 400; }
.cards { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); }
.card { background: var(--panel); border-top: 4px solid var(--swatch); border-radius: .2rem; padding: 1.1rem 1.3rem 1.3rem; min-width: 0; }
.card h3 { margin: 0 0 .2em; font: 600 1.2rem/1.3 var(--serif); }
.card p, .card li { font-size: .93rem; }
.card ul { margin: .3em 0 0; padding-left: 1.1em; }
.card h4 { margin: 1.1em 0 0; font-size: .84rem; font-weight: 600; color: var(--soft); }
.card .facts div { min-width: 0; }
.card .because { margin: 1em 0 0; }
.card .facts { gap: .5rem 1.4rem; margin: .9rem 0 0; }
.card .facts dd { font-size: 1.15rem; }
.verdict { font-weight: 600; color: var(--good); }
.verdict.bad { color: var(--bad); }
.warning { border-left: 4px solid var(--bad); padding: .2rem 0 .2rem 1.1rem; margin-bottom: 1.2rem; }
.warning p { margin: 0; }
.pairs { display: grid; gap: 0 2.5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 24rem), 1fr)); align-items: start; }
.pairs > * { min-width: 0; }
img.picture { display: block; width: 100%; min-width: 36rem; max-width: 60rem; height: auto; }
)css";

constexpr std::string_view charts = R"css(
.legend { display: flex; flex-wrap: wrap; gap: .3em 1.8em; list-style: none; padding: 0; margin: 0 0 1.2rem; font-size: .93rem; }
.legend svg { width: 2.4em; height: 1em; vertical-align: -.15em; margin-right: .4em; }
.charts { display: grid; gap: 2.5rem 2.2rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); }
figure { margin: 0; min-width: 0; break-inside: avoid; }
figcaption { margin-bottom: .8rem; }
figure .because { margin: .6rem 0 0; }
figcaption strong { font: 600 1.12rem/1.35 var(--serif); display: block; }
svg.chart { display: block; width: 100%; height: auto; max-width: 32rem; overflow: visible; }
svg.speed { max-width: 42rem; }
svg text { fill: var(--ink); font: 13px var(--sans); font-variant-numeric: tabular-nums; }
svg .tick { fill: var(--soft); font-size: 12px; }
svg .value { font-size: 12px; }
svg .none { fill: var(--soft); }
svg .grid { stroke: var(--line); stroke-width: 1; }
svg .axis { stroke: var(--soft); stroke-width: 1; }
svg .bar { fill: var(--swatch); }
svg .whisker { stroke: var(--ink); stroke-width: 1.2; fill: none; }
svg .dot { fill: var(--paper); stroke: var(--ink); stroke-width: 1.2; }
svg .band { fill: var(--panel); }
svg .curve { fill: none; stroke-width: 2.4; stroke-linejoin: round; }
svg .gentle { stroke: var(--gentle); } svg .firm { stroke: var(--firm); } svg .emergency { stroke: var(--emergency); }
svg .pass { stroke: var(--soft); stroke-dasharray: 5 4; stroke-width: 1.6; fill: none; }
svg .sign { fill: var(--sign); }
svg .name { font-weight: 600; }
svg .front { fill: none; stroke: var(--soft); stroke-width: 1.6; stroke-dasharray: 2 3; }
svg .policy { fill: var(--paper); stroke: var(--soft); stroke-width: 1.3; }
svg .policy.best { fill: var(--ink); stroke: var(--ink); }
svg .policy.own { fill: var(--swatch); stroke: var(--swatch); }
svg .number { font-size: 12px; font-weight: 600; }
@media (max-width: 40rem) { svg.speed text { font-size: 15px; } svg.speed .tick { font-size: 14.5px; } }
)css";

constexpr std::string_view print = R"css(
@page { size: A4; margin: 16mm 15mm; }
@media print {
  :root {
    color-scheme: light;
    --paper: #fff; --panel: #f5f3ee; --ink: #000; --soft: #484c52; --line: #cfcbc2; --link: #000;
    --good: #0b6b45; --bad: #a33b00; --sign: #b3261e;
    --k0: #0072b2; --k1: #85888d; --k2: #c97a00; --k3: #00855f; --k4: #a64d86; --heat: 213 94 0;
    --gentle: #0072b2; --firm: #b06a00; --emergency: #b3261e;
  }
  html { font-size: 9.5pt; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  main, .hero, .contents, footer { max-width: none; padding-inline: 0; }
  .hero { padding-top: 0; }
  .contents { display: none; }
  section { padding-block: 1.6rem 0; }
  h2, h3, caption, figcaption { break-after: avoid; }
  tr, .card, .warning { break-inside: avoid; }
  thead { display: table-header-group; }
  .scroll { overflow: visible; }
  .scroll table { min-width: 100%; }
  .scroll th, .scroll td { padding-inline: .3em; }
  .errors { font-size: .68rem; }
  .errors th, .errors td { padding: .3em .25em; }
  .errors thead th.n { font-size: .6rem; min-width: 0; }
  .errors tbody th[scope=row] { min-width: 7rem; max-width: 11rem; position: static; }
  .errors .what { font-size: .6rem; }
  .exact { font-size: .62rem; }
  .cards { grid-template-columns: repeat(3, 1fr); gap: .8rem; }
  .pairs { grid-template-columns: 1fr; row-gap: 1rem; }
  .charts { grid-template-columns: repeat(2, 1fr); }
  details::details-content { content-visibility: visible; block-size: auto; }
  a { text-decoration: none; }
}
)css";

std::string assemble() {
  std::string all;
  for (const std::string_view part : {colours, text, tables, parts, charts, print}) all += part;
  return all;
}

}  // namespace

std::string_view style_sheet() {
  static const std::string all = assemble();
  return all;
}

std::string picture_style() {
  return std::string(colours) + std::string(charts);
}

}  // namespace heed::report
