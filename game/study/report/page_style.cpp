#include "game/study/report/page_style.h"

namespace rambla::game::study {

const std::string& page_style() {
    static const std::string style = R"css(
:root{color-scheme:light dark;--paper:#fff;--panel:#f5f6f8;--ink:#1b2127;--muted:#59636e;--rule:#dde1e6;
  --link:#00609a;--bar:#d4e6f3;--front:#eef6fb;--warn:#8a4b00;--warn-panel:#fdf3e3}
@media (prefers-color-scheme:dark){:root{--paper:#12161b;--panel:#1a1f26;--ink:#e7eaee;--muted:#9ba6b2;
  --rule:#2a313a;--link:#7cc0ef;--bar:#1f3f57;--front:#17232d;--warn:#f0c078;--warn-panel:#2a2115}}
*{box-sizing:border-box}
html{scroll-behavior:smooth;-webkit-text-size-adjust:100%}
@media (prefers-reduced-motion:reduce){html{scroll-behavior:auto}}
body{margin:0;background:var(--paper);color:var(--ink);
  font:16px/1.55 system-ui,"Segoe UI",Roboto,"Helvetica Neue",sans-serif;overflow-wrap:anywhere}
a{color:var(--link);text-decoration-thickness:1px;text-underline-offset:.18em}
h1,h2,h3{line-height:1.2;text-wrap:balance;margin:0;letter-spacing:-.012em}
h1{font-size:2.3rem}h2{font-size:1.6rem}h3{font-size:1.02rem}
p{margin:0;max-width:44rem}
.page{max-width:80rem;margin:0 auto;padding:3.5rem 2rem 5rem;display:grid;gap:3rem 2.75rem;
  grid-template-columns:11.5rem minmax(0,1fr)}
header{grid-column:1/-1;display:grid;gap:1rem}
.lead{font-size:1.15rem;max-width:46rem}
.kicker{color:var(--muted);font-size:.85rem;letter-spacing:.08em;text-transform:uppercase}
.facts{display:grid;grid-template-columns:repeat(auto-fill,minmax(13rem,1fr));gap:.9rem 1.5rem;margin:.8rem 0 0;
  padding:1rem 0 0;border-top:1px solid var(--rule)}
.facts dt,.small{font-size:.8125rem;color:var(--muted)}
.facts dd{margin:0;font-size:.9rem}
nav{position:sticky;top:2rem;align-self:start;max-height:calc(100vh - 4rem);overflow-y:auto;font-size:.9rem}
nav h2{font-size:.8125rem;font-weight:500;color:var(--muted);letter-spacing:0;margin-bottom:.5rem}
nav ol{list-style:none;margin:0;padding:0;border-left:1px solid var(--rule)}
nav li{padding:.22rem 0 .22rem .9rem}
nav a{color:inherit;text-decoration:none}nav a:hover{color:var(--link);text-decoration:underline}
main{display:grid;gap:4.5rem;min-width:0}
.study{display:grid;gap:1.1rem;min-width:0;scroll-margin-top:1.5rem}
.study+.study{border-top:1px solid var(--rule);padding-top:3rem}
.question{font-size:1.08rem}
.reference{color:var(--muted)}.reference b{color:var(--ink);font-weight:600}
.warning{background:var(--warn-panel);color:var(--warn);padding:.7rem 1rem;border-radius:.4rem}
.again{font-size:.9rem;color:var(--muted);display:flex;flex-wrap:wrap;gap:.4rem 1.2rem;align-items:baseline;
  max-width:none}
code{font:.86em/1.5 ui-monospace,"Cascadia Code","DejaVu Sans Mono",Menlo,Consolas,monospace}
.again code{background:var(--panel);color:var(--ink);padding:.15rem .5rem;border-radius:.3rem}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(23rem,100%),1fr));gap:1.5rem 2rem;
  align-items:start;margin:.4rem 0}
.figures figure{margin:0;min-width:0}
.plot{display:block;width:100%;max-width:36rem;height:auto;overflow:visible}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,min(20rem,100%));gap:1rem .75rem;align-items:start}
.broad{grid-template-columns:repeat(auto-fit,minmax(min(20rem,100%),1fr))}
.pictures figure{margin:0;min-width:0}
.pictures a{display:block;width:fit-content;max-width:100%}
.pictures img{display:block;max-width:100%;height:auto}
.pixels{image-rendering:pixelated}
.pictures figcaption{font-size:.8125rem;color:var(--muted);margin-top:.3rem}
.block{display:grid;gap:.5rem;min-width:0;margin-top:.8rem}
.block h3 .small{font-weight:400;letter-spacing:0;margin-left:.5em}
details{min-width:0}details>.block{margin-top:1.6rem}summary{cursor:pointer;color:var(--link);font-size:.9rem}
.scroll{overflow-x:auto;max-width:100%;border-top:1px solid var(--rule);border-bottom:1px solid var(--rule)}
.scroll:focus-visible{outline:2px solid var(--link);outline-offset:2px}
table{border-collapse:collapse;font-size:.875rem;line-height:1.35;min-width:100%;overflow-wrap:normal}
th,td{padding:.42rem .6rem;text-align:right;vertical-align:baseline;font-variant-numeric:tabular-nums;
  white-space:nowrap}
th{font-weight:500}
thead th{color:var(--muted);font-size:.8125rem;vertical-align:bottom;border-bottom:1px solid var(--rule)}
tbody tr+tr>*{border-top:1px solid color-mix(in srgb,var(--rule) 55%,transparent)}
.name{text-align:left;white-space:normal;overflow-wrap:break-word;max-width:24rem;font-weight:400}
.grades .name{position:sticky;left:0;background-color:var(--paper)}
.further .name{min-width:8.5rem}
.whole{white-space:nowrap}.long{display:block;min-width:12rem}
.metric{white-space:normal;min-width:6rem}
thead .name{white-space:nowrap}
.number{color:var(--muted);width:1%;padding-right:0}
.muted{color:var(--muted);font-size:.8125rem}
.bar{display:block;min-width:3rem;padding-bottom:.2rem;margin-bottom:-.2rem;
  background:linear-gradient(var(--bar),var(--bar)) no-repeat left bottom/calc(100%*var(--share)) 3px}
.front>*,.grades .front>.name{background-color:var(--front)}
.tag{font-size:.75rem;color:var(--link);border:1px solid currentColor;border-radius:1em;padding:0 .5em;
  white-space:nowrap}
.star{color:var(--link);font-size:.8em}
th .tag{margin-left:.35em}
@media (max-width:60rem){.page{grid-template-columns:minmax(0,1fr);padding:2.2rem 1rem 3rem;gap:2.2rem}
  h1{font-size:1.8rem}h2{font-size:1.4rem}.lead{font-size:1.05rem}
  nav{position:static;max-height:none}.facts{grid-template-columns:repeat(auto-fill,minmax(10rem,1fr))}
  main{gap:3rem}.study+.study{padding-top:2.2rem}
  th,td{padding:.4rem .55rem}}
@media print{nav{display:none}.page{display:block;padding:0}.scroll{overflow:visible}}
)css";
    return style;
}

}  // namespace rambla::game::study
