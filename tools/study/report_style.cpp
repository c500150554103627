#include "study/report_style.h"

namespace penumbra::study {

const std::string_view kReportStyle = R"css(
:root { color-scheme: light dark;
  --ground: #fcfcfb; --raised: #ffffff; --ink: #1b1d21; --quiet: #5b5f66; --line: #dfe1e4; --accent: #0b4f8a; }
@media (prefers-color-scheme: dark) { :root {
  --ground: #16181c; --raised: #1f2227; --ink: #e8e9eb; --quiet: #a3a8b0; --line: #363a41; --accent: #7fb2de; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 76rem; background: var(--ground); color: var(--ink);
  font: 16px/1.5 system-ui, "Liberation Sans", sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.3rem; margin: 3rem 0 .6rem; }
h3 { font-size: 1rem; margin: 1.6rem 0 .4rem; }
p, dl, ul { max-width: 46rem; }
.quiet, figcaption, .card p { color: var(--quiet); }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(14rem, 1fr)); gap: 1rem; margin: 1.6rem 0; }
.card { background: var(--raised); border: 1px solid var(--line); border-radius: .5rem; padding: 1rem 1.2rem; }
.card p { margin: 0; font-size: .9rem; }
.card .value { color: var(--accent); font-size: 2.2rem; line-height: 1.2; font-variant-numeric: tabular-nums; }
.card .name { color: var(--ink); font-weight: 600; font-size: 1rem; }
.finding { border-left: 4px solid #c4341b; padding: .4rem .8rem; background: var(--raised); }
dl.machine { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1rem; max-width: none; }
dl.machine dt { color: var(--quiet); } dl.machine dd { margin: 0; overflow-wrap: anywhere; }
code { font: .9em ui-monospace, "Liberation Mono", monospace; }
figure { margin: 0; } figcaption { font-size: .85rem; }
.chart { margin: 1rem 0; } .chart svg { display: block; width: 100%; max-width: 820px; height: auto; border-radius: .5rem; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(17rem, 1fr)); gap: .8rem; }
.row img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
.legend { display: flex; gap: .4rem; align-items: center; }
.row .legend img { width: 6rem; height: .6rem; }
.scroll { overflow-x: auto; border: 1px solid var(--line); border-radius: .5rem; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; white-space: nowrap; }
th, td { padding: .3rem .6rem; text-align: right; border-bottom: 1px solid var(--line); }
th.name, td.name { text-align: left; }
thead th { background: var(--raised); vertical-align: bottom; }
th button { all: unset; cursor: pointer; } th button:focus-visible { outline: 2px solid var(--accent); }
th[aria-sort=ascending] button::after { content: " \25B4"; } th[aria-sort=descending] button::after { content: " \25BE"; }
tbody tr:hover { background: var(--raised); }
dl.words dt { font-weight: 600; margin-top: .6rem; } dl.words dd { margin: 0 0 0 1.2rem; }
@media print { body { max-width: none; } .scroll { overflow: visible; } }
)css";

// A click on a column's head sorts the table by it, a second click the other way. Cells carry their exact
// figure in data-value; empty ones stay at the end.
const std::string_view kReportScript = R"js(
"use strict";
for (const table of document.querySelectorAll("table.sortable")) {
  const heads = [...table.tHead.rows[0].cells];
  const body = table.tBodies[0];
  heads.forEach((head, column) => head.querySelector("button").addEventListener("click", () => {
    const rising = head.getAttribute("aria-sort") !== "ascending";
    for (const other of heads) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", rising ? "ascending" : "descending");
    const numeric = !head.classList.contains("name");
    const value = row => row.cells[column].dataset.value;
    const rows = [...body.rows].sort((a, b) => {
      const [x, y] = [value(a), value(b)];
      if (x === "" || y === "") return (x === "") - (y === "");
      return (rising ? 1 : -1) * (numeric ? x - y : x.localeCompare(y));
    });
    body.append(...rows);
  }));
}
)js";

}  // namespace penumbra::study
