#include "game/study/report/report.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <system_error>
#include <vector>

#include "assets/error.h"
#include "assets/export/image.h"
#include "game/study/report/csv.h"
#include "game/study/report/figure.h"
#include "game/study/report/page.h"
#include "game/study/report/picture_files.h"
#include "game/study/report/plot.h"

namespace rambla::game::study {

namespace fs = std::filesystem;

namespace {

constexpr const char* k_name_characters = "abcdefghijklmnopqrstuvwxyz0123456789-_";

/// A name that is a file's name on any system, and a place on the page.
bool is_name(const std::string& name) {
    return !name.empty() && name.find_first_not_of(k_name_characters) == std::string::npos;
}

void check_names(std::span<const StudyResult> results) {
    for (const StudyResult& result : results) {
        if (!is_name(result.name))
            throw assets::Error{"study", "name", fmt::format("\"{}\"", result.name),
                                "lower-case letters, digits, - and _"};
        const auto same = std::count_if(results.begin(), results.end(),
                                        [&](const StudyResult& other) { return other.name == result.name; });
        if (same > 1)
            throw assets::Error{"study", "name", fmt::format("\"{}\" twice", result.name), "each once"};
    }
}

fs::path file_of(const fs::path& folder, const std::string& name, const char* extension) {
    return folder / (name + extension);
}

void write_study(const fs::path& folder, const StudyRun& run) {
    const StudyResult& study = run.result;
    std::vector<Figure> figures = figures_of(study);
    std::erase_if(figures, [](const Figure& figure) { return !has_marks(figure); });
    const fs::path svg = file_of(folder, study.name, ".svg");
    if (!figures.empty()) {
        assets::write_text(svg, to_svg_file(figures));
    } else {
        // One of an earlier run would not belong to the numbers beside it.
        std::error_code ignored;
        fs::remove(svg, ignored);
    }
    write_pictures(folder, study);
    assets::write_text(file_of(folder, study.name, ".csv"), to_csv(study));
    assets::write_text(file_of(folder, study.name, ".json"), to_json(run));
}

StudyRun read_earlier(const fs::path& file) {
    StudyRun run = read_study(file);
    if (run.result.name != file.stem().string() || !is_name(run.result.name))
        throw assets::Error{file.string(), "name", fmt::format("\"{}\"", run.result.name),
                            "the file's own name"};
    read_pictures(file.parent_path(), run.result);
    return run;
}

bool holds(const std::vector<StudyRun>& runs, const std::string& name) {
    return std::any_of(runs.begin(), runs.end(),
                       [&](const StudyRun& run) { return run.result.name == name; });
}

/// Adds the studies of earlier runs that lie in the folder.
void add_earlier(std::vector<StudyRun>& runs, const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator entry{folder, failed}; !failed && entry != fs::directory_iterator{};
         entry.increment(failed)) {
        if (entry->path().extension() == ".json") files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
        if (holds(runs, file.stem().string())) continue;
        try {
            runs.push_back(read_earlier(file));
        } catch (const assets::Error& error) {
            spdlog::warn("left out of the report: {}", error.what());
        }
    }
}

void sort_runs(std::vector<StudyRun>& runs, std::span<const std::string> order) {
    const auto rank = [&](const StudyRun& run) {
        return std::find(order.begin(), order.end(), run.result.name) - order.begin();
    };
    std::sort(runs.begin(), runs.end(), [&](const StudyRun& a, const StudyRun& b) {
        return rank(a) != rank(b) ? rank(a) < rank(b) : a.result.name < b.result.name;
    });
}

}  // namespace

void write_report(const fs::path& folder, std::span<const StudyResult> results, const RunFacts& facts,
                  std::span<const std::string> order) {
    check_names(results);
    std::vector<StudyRun> runs;
    for (const StudyResult& result : results) {
        runs.push_back({result, facts});
        write_study(folder, runs.back());
    }
    add_earlier(runs, folder);
    sort_runs(runs, order);
    assets::write_text(folder / "index.html", to_page(runs, facts));
}

}  // namespace rambla::game::study
