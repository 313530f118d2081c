#include "game/study/pass_ms.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "game/pass_table.h"

namespace rambla::game::study {
namespace {

std::vector<std::string> row_of(const PassRow& row) {
    return {row.name,
            fmt::format("{:.2f}", row.gpu_ms_median),
            fmt::format("{:.1f} %", 100.0 * row.share),
            fmt::format("{:.2f}", row.cpu_ms_median),
            bytes_text(row.bytes_written),
            bytes_text(row.memory_bytes)};
}

}  // namespace

PassMs pass_ms(const PictureCost& cost) {
    const PassTable table = make_pass_table(cost.rounds);
    PassMs ms;
    for (const PassRow& row : table.passes)
        ms.emplace_back(row.name, row.gpu_ms_median);
    ms.emplace_back("(missing)", table.missing.gpu_ms_median);
    ms.emplace_back("whole picture", table.frame.gpu_ms_median);
    ms.emplace_back("CPU of the render thread", table.frame.cpu_ms_median);
    return ms;
}

std::string ms_text(const PassMs& passes, std::string_view name) {
    const auto found =
        std::find_if(passes.begin(), passes.end(), [&](const auto& pass) { return pass.first == name; });
    return found == passes.end() ? "–" : fmt::format("{:.2f}", found->second);
}

Table cost_table(std::string title, const PictureCost& cost) {
    const PassTable passes = make_pass_table(cost.rounds);
    Table table{.title = std::move(title),
                .head = {"pass", "ms", "share", "CPU ms", "written", "memory while it runs"},
                .rows = {}};
    for (const PassRow& row : passes.passes)
        table.rows.push_back(row_of(row));
    table.rows.push_back(row_of(passes.missing));
    table.rows.push_back(row_of(passes.frame));
    return table;
}

}  // namespace rambla::game::study
