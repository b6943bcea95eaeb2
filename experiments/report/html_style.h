#pragma once

// What makes the report page look and sort as it does; text inside its <style> and <script>.
namespace report {

inline constexpr const char* page_style = R"(
:root { --a: #0072B2; --b: #D55E00; --draw: #b5b5b5; --line: #e2e4e8; --soft: #f6f7f9; --text: #1d2330; --dim: #646b7a; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
       color: var(--text); background: #fff; margin: 0 auto; padding: 24px 28px 80px; max-width: 1180px; }
h1 { font-size: 26px; margin: 0; }
h2 { font-size: 19px; margin: 38px 0 10px; padding-bottom: 5px; border-bottom: 1px solid var(--line); }
h3 { font-size: 16px; margin: 20px 0 6px; }
p { margin: 6px 0; }
.dim { color: var(--dim); }
.small { font-size: 13px; }
.lead { background: var(--soft); border-left: 4px solid var(--a); padding: 12px 16px; margin: 18px 0; }
.lead p { margin: 3px 0; }
.warn { background: #fff6e5; border-left: 4px solid #e69f00; padding: 8px 16px; margin: 8px 0; }
.progress { height: 8px; background: var(--line); border-radius: 4px; overflow: hidden; margin: 10px 0 4px; }
.progress i { display: block; height: 100%; background: var(--a); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 14px; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: 5px 12px 5px 0; border-bottom: 1px solid var(--line); white-space: nowrap; vertical-align: top; }
th { color: var(--dim); font-weight: 600; }
th:first-child, td:first-child, .left { text-align: left !important; }
tr.sig td { font-weight: 600; }
td.wrap { white-space: normal; max-width: 420px; }
.bar { display: inline-flex; width: 150px; height: 14px; border-radius: 3px; overflow: hidden; vertical-align: middle; background: var(--line); }
.bar i { height: 100%; } .bar .a { background: var(--a); } .bar .d { background: var(--draw); } .bar .b { background: var(--b); }
.key { font-size: 13px; color: var(--dim); } .key i { display: inline-block; width: 10px; height: 10px; border-radius: 2px; margin: 0 4px 0 12px; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(440px, 1fr)); gap: 18px 26px; }
figure { margin: 0; } figure svg { width: 100%; height: auto; } figcaption { font-size: 13px; color: var(--dim); }
table.games th { cursor: pointer; user-select: none; } table.games th.up::after { content: " \25B2"; } table.games th.down::after { content: " \25BC"; }
tr.bad td { background: #fff1ee; }
code, pre { font: 12.5px/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { background: var(--soft); padding: 12px; overflow-x: auto; }
details { margin: 8px 0; } summary { cursor: pointer; font-weight: 600; }
@media print { body { max-width: none; } details[open] summary { display: none; } }
)";

/// Sorts the list of games by the column that is clicked; numbers by data-v, all else as text.
inline constexpr const char* page_script = R"(
document.querySelectorAll('table.games th').forEach(function (head, column) {
  head.addEventListener('click', function () {
    var body = head.closest('table').tBodies[0];
    var down = head.classList.contains('up');
    head.parentNode.querySelectorAll('th').forEach(function (other) { other.classList.remove('up', 'down'); });
    head.classList.add(down ? 'down' : 'up');
    var key = function (row) {
      var cell = row.cells[column];
      return cell.dataset.v === undefined ? cell.textContent : Number(cell.dataset.v);
    };
    Array.from(body.rows).sort(function (a, b) {
      var x = key(a), y = key(b);
      return (x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1);
    }).forEach(function (row) { body.appendChild(row); });
  });
});
)";

}  // namespace report
