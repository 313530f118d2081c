#include "game/study/report/plot.h"

namespace rambla::game::study {

// The colours are those that Okabe and Ito chose to be told apart with any colour vision ("Color Universal
// Design", 2008), without their black and yellow, darkened on white and lightened on black until a small
// marker stands out. Colours stand here as they are, not as variables, which other readers of SVG than
// browsers do not know.
const std::string& plot_style() {
    static const std::string style = R"css(
.plot text{font:12px system-ui,"Segoe UI",Roboto,"Helvetica Neue",sans-serif;fill:#59636e;
  font-variant-numeric:tabular-nums}
.plot .title{font-weight:600;fill:#1b2127}
.plot .name,.plot .key{fill:#1b2127}
.plot .name{paint-order:stroke;stroke:#f5f6f8;stroke-width:3px;stroke-linejoin:round}
.plot .paper{fill:#fff}
.plot .frame{fill:#f5f6f8}
.plot .grid{stroke:#dde1e6;fill:none}
.plot .tick,.plot .axis{stroke:#8b95a1;fill:none}
.plot .whisker{fill:none;stroke-width:1.5;opacity:.45}
.plot .leader{stroke:#8b95a1;fill:none;stroke-width:.8}
.plot .line{fill:none;stroke-width:1.6;stroke-linejoin:round}
.plot .front{fill:none;stroke:#59636e;stroke-width:1.3;stroke-dasharray:5 3}
.plot .mark,.plot .sample{stroke:#f5f6f8;stroke-width:.8}
.plot .sample{stroke:none}
.plot .s0{fill:#0072b2;stroke:#0072b2}.plot .s1{fill:#d55e00;stroke:#d55e00}
.plot .s2{fill:#008f68;stroke:#008f68}.plot .s3{fill:#b0568c;stroke:#b0568c}
.plot .s4{fill:#b98100;stroke:#b98100}.plot .s5{fill:#3a97cf;stroke:#3a97cf}
.plot .s6{fill:#59636e;stroke:#59636e}
.plot path.mark{stroke:#f5f6f8}
.plot path.line,.plot path.whisker{fill:none}
@media (prefers-color-scheme:dark){
.plot text{fill:#9ba6b2}
.plot .title,.plot .name,.plot .key{fill:#e7eaee}
.plot .name{stroke:#1a1f26}
.plot .paper{fill:#12161b}
.plot .frame{fill:#1a1f26}
.plot .grid{stroke:#2a313a}
.plot .tick,.plot .axis,.plot .leader{stroke:#6d7885}
.plot .front{stroke:#9ba6b2}
.plot .s0{fill:#5aaee6;stroke:#5aaee6}.plot .s1{fill:#f28a4a;stroke:#f28a4a}
.plot .s2{fill:#35c39b;stroke:#35c39b}.plot .s3{fill:#dd95be;stroke:#dd95be}
.plot .s4{fill:#e3b341;stroke:#e3b341}.plot .s5{fill:#9ad4f5;stroke:#9ad4f5}
.plot .s6{fill:#aab4bf;stroke:#aab4bf}
.plot path.mark{stroke:#1a1f26}
.plot path.line,.plot path.whisker{fill:none}
}
)css";
    return style;
}

}  // namespace rambla::game::study
