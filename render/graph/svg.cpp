#include <string>

#include "render/graph/graph.h"
#include "render/graph/graph_state.h"

namespace rambla::render {

namespace {

constexpr int k_column_px = 130;
constexpr int k_row_px = 26;
constexpr int k_left_px = 170;
constexpr int k_top_px = 70;

std::string number(int value) {
    return std::to_string(value);
}

std::string escaped(const char* text) {
    std::string result;
    for (const char* c = text; *c != '\0'; ++c) {
        switch (*c) {
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '&':
                result += "&amp;";
                break;
            default:
                result += *c;
        }
    }
    return result;
}

std::string text_at(int x, int y, const char* anchor, const std::string& text) {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\">" + text +
           "</text>\n";
}

std::string detail(const graph::Layout& layout) {
    if (layout.buffer_bytes != 0) return std::to_string(layout.buffer_bytes) + " bytes";
    return std::to_string(layout.texture.size.x) + "×" + std::to_string(layout.texture.size.y) + ", " +
           std::to_string(gl::bytes_per_texel(layout.texture.format)) + " bytes/texel";
}

}  // namespace

// Columns are passes in the order in which they run, the culled ones behind them; rows are resources. A
// filled dot is a write, a ring a read, and a bar spans the lifetime for which a transient resource holds its
// slot of memory.
std::string RenderGraph::svg() const {
    const State& state = *state_;
    std::vector<std::uint32_t> columns;
    if (state.plan != nullptr) columns = state.plan->order;
    const std::size_t living = columns.size();
    std::vector<bool> placed(state.passes.size(), false);
    for (const std::uint32_t pass : columns)
        placed[pass] = true;
    for (std::uint32_t pass = 0; pass < state.passes.size(); ++pass) {
        if (!placed[pass]) columns.push_back(pass);
    }
    const auto column_x = [](std::size_t column) {
        return k_left_px + static_cast<int>(column) * k_column_px + k_column_px / 2;
    };
    const auto row_y = [](std::size_t row) {
        return k_top_px + static_cast<int>(row) * k_row_px + k_row_px / 2;
    };
    const int width = k_left_px + static_cast<int>(columns.size()) * k_column_px;
    const int height = k_top_px + static_cast<int>(state.resources.size()) * k_row_px + 10;

    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width) + "\" height=\"" +
                      number(height) + "\" font-family=\"sans-serif\" font-size=\"12\">\n" +
                      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const int x = column_x(column) - k_column_px / 2 + 4;
        svg += "<rect x=\"" + number(x) + "\" y=\"14\" width=\"" + number(k_column_px - 8) +
               "\" height=\"30\" rx=\"5\" stroke=\"#345\" fill=\"" +
               (column < living ? "#cfe3f5\"" : "none\" stroke-dasharray=\"4 3\"") + "/>\n";
        svg += text_at(column_x(column), 33, "middle", escaped(state.passes[columns[column]].name));
    }
    for (std::size_t row = 0; row < state.resources.size(); ++row) {
        const State::ResourceInfo& resource = state.resources[row];
        const int y = row_y(row);
        svg += "<g><title>" + detail(state.layouts[resource.layout]) + "</title>\n";
        const graph::Lifetime life = state.plan != nullptr ? state.plan->lifetimes[row] : graph::Lifetime{};
        std::string name = escaped(resource.name);
        if (life.slot != graph::k_none) name += " [" + std::to_string(life.slot) + "]";
        svg += text_at(k_left_px - 8, y + 4, "end", name);
        if (life.first != graph::k_none) {
            svg += "<line x1=\"" + number(column_x(life.first)) + "\" y1=\"" + number(y) + "\" x2=\"" +
                   number(column_x(life.last)) + "\" y2=\"" + number(y) + "\" stroke=\"" +
                   (life.slot != graph::k_none ? "#e0a040" : "#789") +
                   "\" stroke-width=\"6\" opacity=\"0.5\"/>\n";
        }
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const graph::Pass& pass = state.recording.passes[columns[column]];
            bool reads = false;
            bool writes = false;
            for (std::uint32_t a = 0; a < pass.access_count; ++a) {
                const graph::Access& access = state.recording.accesses[pass.first_access + a];
                const auto touches = [&](std::uint32_t version) {
                    return version != graph::k_none && state.recording.versions[version].resource == row;
                };
                reads = reads || touches(access.reads);
                writes = writes || touches(access.writes);
            }
            if (!reads && !writes) continue;
            svg += "<circle cx=\"" + number(column_x(column)) + "\" cy=\"" + number(y) +
                   "\" r=\"6\" stroke=\"#a33\" stroke-width=\"2\" fill=\"" + (writes ? "#a33" : "white") +
                   "\"/>\n";
        }
        svg += "</g>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace rambla::render
