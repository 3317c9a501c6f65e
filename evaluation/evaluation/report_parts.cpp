#include "evaluation/report_parts.hpp"

#include <fmt/format.h>

#include "evaluation/markup.hpp"

namespace symscene {
namespace {

constexpr const char* report_style = R"(
:root { color-scheme: light dark; --back: #fff; --text: #1c2024; --faint: #667079; --line: #d8dde1;
  --band: #f4f6f8; --c0: #1d5fc4; --c1: #7aa7e8; --c2: #c2680a; --c3: #13795b; --c4: #a12a8f;
  --c5: #b3261e; --c6: #6b5b00; --c7: #4c5a67; }
@media (prefers-color-scheme: dark) { :root { --back: #14181c; --text: #e6eaee; --faint: #98a4af;
  --line: #333b43; --band: #1c2228; --c0: #6ea8ff; --c1: #3f6fb5; --c2: #ffae57; --c3: #4fd1a5;
  --c4: #ee8ade; --c5: #ff8a80; --c6: #dcc94c; --c7: #b0bec9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.25rem 4rem; max-width: 84rem; background: var(--back);
  color: var(--text); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; margin: 0; }
h2 { font-size: 1.2rem; margin: 2.5rem 0 .5rem; }
p { max-width: 48rem; margin: .4rem 0 .8rem; color: var(--faint); }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
th, td { padding: .3rem .4rem; text-align: right; white-space: nowrap; vertical-align: top; }
th { font-weight: 600; white-space: normal; vertical-align: bottom; border-bottom: 2px solid var(--line); }
td { border-bottom: 1px solid var(--line); }
tbody tr:nth-child(even) { background: var(--band); }
.l1 :is(th, td):nth-child(-n+1), .l2 :is(th, td):nth-child(-n+2),
.last :is(th, td):last-child { text-align: left; }
.last td:last-child { white-space: normal; min-width: 18rem; }
.l2 td:nth-child(-n+2) { white-space: normal; }
.failures { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: 1.25rem; }
.failures img { width: 100%; border: 1px solid var(--line); border-radius: .3rem; display: block; }
.failures figcaption small { display: block; font-weight: 400; color: var(--faint); }
.total tbody tr:last-child td { font-weight: 600; border-top: 2px solid var(--line); }
.figures { display: grid; grid-template-columns: repeat(auto-fill, minmax(22rem, 1fr));
  gap: 2rem 1.5rem; }
.small { grid-template-columns: repeat(auto-fill, minmax(17rem, 1fr)); }
figure { margin: 0; }
figcaption { font-weight: 600; margin-bottom: .3rem; }
svg { width: 100%; height: auto; display: block; }
svg text { font: 11px system-ui, sans-serif; fill: var(--faint); }
.grid { stroke: var(--line); fill: none; }
.equal { stroke: var(--faint); fill: none; stroke-dasharray: 1 4; opacity: .8; }
.curve { fill: none; stroke: var(--c); stroke-width: 2; stroke-linejoin: round; }
.dots { fill: none; stroke: var(--c); stroke-width: 4; stroke-linecap: round; opacity: .35; }
.band { fill: var(--c); stroke: none; opacity: .14; }
.ring { fill: none; stroke: var(--c); stroke-width: 2; }
.star { fill: var(--c); stroke: var(--back); stroke-width: 1; }
.legend { list-style: none; margin: .4rem 0 0; padding: 0; font-size: .9rem; }
.legend li { padding-left: 1.4rem; position: relative; }
.legend small { display: block; color: var(--faint); }
.swatch { position: absolute; left: 0; top: .45rem; width: .9rem; height: .5rem;
  border-radius: .2rem; background: var(--c); }
.c0 { --c: var(--c0); } .c1 { --c: var(--c1); } .c2 { --c: var(--c2); } .c3 { --c: var(--c3); }
.c4 { --c: var(--c4); } .c5 { --c: var(--c5); } .c6 { --c: var(--c6); } .c7 { --c: var(--c7); }
)";

std::string row_html(const std::vector<std::string>& row, const char* cell) {
  std::string html = "<tr>";
  for (const std::string& text : row)
    html += fmt::format("<{0}>{1}</{0}>", cell, escape_markup(text));
  return html + "</tr>\n";
}

}  // namespace

std::string report_head(const std::string& title) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n"
      "<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n",
      escape_markup(title), report_style);
}

std::string report_section(const char* title, const char* text) {
  return fmt::format("<h2>{}</h2>\n<p>{}</p>\n", title, text);
}

std::string report_table(const TextTable& table, const char* classes) {
  std::string html = fmt::format("<div class=\"scroll\"><table class=\"{}\">\n<thead>", classes);
  html += row_html(table.front(), "th") + "</thead>\n<tbody>\n";
  for (std::size_t k = 1; k < table.size(); ++k) html += row_html(table[k], "td");
  return html + "</tbody>\n</table></div>\n";
}

}  // namespace symscene
