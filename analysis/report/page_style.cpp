#include "analysis/report/page_style.hpp"

namespace palpate::analysis {

const char* const kPageStyle = R"css(
:root { --ink: #1b1f24; --soft: #57606a; --rule: #d0d7de; --wash: #f6f8fa; --warn: #7a2e00; --warn-wash: #fff4e5; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: #fff;
       font: 16px/1.55 "Source Serif 4", "Charter", "Georgia", "DejaVu Serif", serif; }
.sheet { max-width: 820px; margin: 0 auto; padding: 32px 24px 64px; }
h1, h2, h3, th, caption, figcaption, .meta, .running, .label, svg text, .banner {
  font-family: "Inter", "Helvetica Neue", "Arial", "DejaVu Sans", sans-serif; }
h1 { font-size: 28px; line-height: 1.2; margin: 0 0 4px; letter-spacing: -0.01em; }
h2 { font-size: 20px; margin: 44px 0 10px; padding-top: 14px; border-top: 1px solid var(--rule); }
h3 { font-size: 16px; margin: 26px 0 6px; }
p { margin: 0 0 12px; }
.meta { color: var(--soft); font-size: 14px; margin-bottom: 20px; }
.banner { background: var(--warn-wash); border-left: 5px solid #d55e00; color: var(--warn);
          padding: 10px 14px; margin: 10px 0; font-size: 14.5px; line-height: 1.45; }
.running { display: none; }
.summary { background: var(--wash); border-radius: 6px; padding: 16px 20px 6px; }
.summary p:first-child { color: var(--soft); }
.label { display: inline-block; font-size: 11.5px; letter-spacing: .06em; text-transform: uppercase;
         border: 1px solid var(--soft); border-radius: 3px; padding: 0 6px; margin-left: 8px; color: var(--soft);
         vertical-align: 2px; font-weight: 500; }
.label.primary { background: var(--ink); border-color: var(--ink); color: #fff; }
.claim { color: var(--soft); font-size: 15px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; margin: 12px 0 6px; font-size: 14px; line-height: 1.35;
        font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; font-size: 14px; padding-bottom: 6px; }
th { text-align: left; font-weight: 600; font-size: 12.5px; color: var(--soft); vertical-align: bottom; }
tbody th { color: var(--ink); font-size: 14px; font-weight: 500; vertical-align: top; }
th, td { padding: 6px 14px 6px 0; border-bottom: 1px solid var(--rule); vertical-align: top; }
thead th { border-bottom: 1.5px solid var(--ink); }
.note { color: var(--soft); font-size: 13px; line-height: 1.45; }
.columns { column-width: 170px; column-gap: 28px; }
figure { margin: 18px 0; }
figcaption { font-size: 13.5px; line-height: 1.45; color: var(--soft); margin-top: 4px; }
svg { display: block; max-width: 100%; height: auto; }
svg text { font-size: 13px; fill: var(--ink); }
svg .tick, svg .critical-text { font-size: 12px; fill: var(--soft); }
svg .name { font-size: 13px; fill: var(--soft); }
svg .row { font-weight: 600; font-size: 14px; }
svg .axis { stroke: #57606a; stroke-width: 1; }
svg .grid { stroke: #e7ebef; stroke-width: 1; }
svg .chance { stroke: #57606a; stroke-width: 1.2; stroke-dasharray: 5 4; }
svg .guess { fill: #dfe3e8; }
svg .rejected { fill: #8c959f; }
svg .bar { fill-opacity: .82; }
svg .whisker { stroke: #1b1f24; stroke-width: 1.8; }
svg .critical { stroke: #1b1f24; stroke-width: 1.6; }
svg .critical-text { fill: #1b1f24; }
svg .link { stroke: #afb8c1; stroke-width: 2; }
svg .dot { stroke: #fff; stroke-width: 1; }
details { margin: 10px 0; }
summary { cursor: pointer; font: 600 14px "Inter", "Helvetica Neue", "Arial", "DejaVu Sans", sans-serif; }
ul { padding-left: 20px; } li { margin-bottom: 7px; }
pre { font: 12.5px/1.45 "DejaVu Sans Mono", "Menlo", monospace; background: var(--wash); padding: 14px 16px;
      white-space: pre-wrap; overflow-wrap: anywhere; }
code { font-family: "DejaVu Sans Mono", "Menlo", monospace; font-size: .85em; overflow-wrap: anywhere; }
@media print {
  @page { size: A4; margin: 16mm 17mm; }
  body { font-size: 10.5pt; }
  .sheet { max-width: none; padding: 0; display: table; width: 100%; }
  .running { display: table-header-group; break-inside: avoid; font-size: 8.5pt; color: var(--warn); }
  .running div { border-bottom: 1px solid #d55e00; padding-bottom: 2px; margin-bottom: 10px; }
  main { display: table-row-group; }
  h2, h3 { break-after: avoid; }
  figure, tr, li, .banner { break-inside: avoid; }
  h2 { margin-top: 28px; }
  thead { display: table-header-group; }
  table { font-size: 8.8pt; } th, td { padding: 3.5px 12px 3.5px 0; } th { font-size: 8pt; } tbody th { font-size: 8.8pt; }
  .scroll { overflow: visible; }
  .summary, .banner, pre, svg { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
}
)css";

}  // namespace palpate::analysis
