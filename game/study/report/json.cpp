#include "game/study/report/json.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "assets/error.h"
#include "game/study/report/json_reader.h"
#include "game/study/report/picture_files.h"
#include "game/study/report/text.h"

namespace rambla::game::study {
namespace {

/// Keeps the members in the order in which they are written, so that a person finds them.
using Json = nlohmann::ordered_json;

constexpr const char* k_schema = "rambla.study/1";

/// The largest studies have some hundred grades of some hundred rounds; far more than that is no study.
constexpr std::uintmax_t k_most_bytes = std::uintmax_t{64} << 20;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(exact(value));
}

template <class Items, class ToJson>
Json array_of(const Items& items, ToJson to_json_of) {
    Json array = Json::array();
    for (const auto& item : items)
        array.push_back(to_json_of(item));
    return array;
}

Json to_value(const Metric& metric) {
    return {{"name", metric.name}, {"value", number(metric.value)}, {"unit", metric.unit}};
}

Json to_value(const GradeResult& grade) {
    return {{"scene", grade.scene},
            {"grade", grade.grade},
            {"ms", array_of(grade.ms, number)},
            {"bytes", number(grade.bytes)},
            {"metrics", array_of(grade.metrics, [](const Metric& metric) { return to_value(metric); })}};
}

Json to_value(const Series& series) {
    const auto point = [](const glm::dvec2& at) {
        return Json::array({number(at.x), number(at.y)});
    };
    return {{"name", series.name}, {"line", series.line}, {"points", array_of(series.points, point)}};
}

Json to_value(const Plot& plot) {
    return {{"title", plot.title},
            {"x_label", plot.x_label},
            {"y_label", plot.y_label},
            {"x_log", plot.x_log},
            {"y_log", plot.y_log},
            {"pareto", plot.pareto},
            {"series", array_of(plot.series, [](const Series& series) { return to_value(series); })}};
}

Json to_value(const Table& table) {
    return {{"title", table.title}, {"head", table.head}, {"rows", table.rows}};
}

/// @param study, index  whose row it is, and the how manieth
Json to_value(const PictureRow& row, const std::string& study, std::size_t index) {
    Json pictures = Json::array();
    for (std::size_t i = 0; i < row.pictures.size(); ++i) {
        pictures.push_back({{"label", row.pictures[i].label}, {"file", picture_file(study, index, i)}});
        if (!picture_fault(row, i).empty()) pictures.back()["file"] = nullptr;
    }
    return {{"title", row.title}, {"pictures", std::move(pictures)}};
}

Json picture_rows(const StudyResult& study) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < study.pictures.size(); ++i)
        rows.push_back(to_value(study.pictures[i], study.name, i));
    return rows;
}

Metric metric_from(const JsonReader& in) {
    return {in.member("name").text(), in.member("value").number(), in.member("unit").text()};
}

GradeResult grade_from(const JsonReader& in) {
    GradeResult grade{in.member("scene").text(), in.member("grade").text()};
    for (const JsonReader& ms : in.member("ms").items())
        grade.ms.push_back(ms.number());
    grade.bytes = in.member("bytes").number();
    for (const JsonReader& metric : in.member("metrics").items())
        grade.metrics.push_back(metric_from(metric));
    return grade;
}

Series series_from(const JsonReader& in) {
    Series series{in.member("name").text(), {}, in.member("line").boolean()};
    for (const JsonReader& point : in.member("points").items()) {
        const std::vector<JsonReader> parts = point.items(2);
        series.points.emplace_back(parts[0].number(), parts[1].number());
    }
    return series;
}

Plot plot_from(const JsonReader& in) {
    Plot plot{.title = in.member("title").text(),
              .x_label = in.member("x_label").text(),
              .y_label = in.member("y_label").text(),
              .x_log = in.member("x_log").boolean(),
              .y_log = in.member("y_log").boolean(),
              .pareto = in.member("pareto").boolean(),
              .series = {}};
    for (const JsonReader& series : in.member("series").items())
        plot.series.push_back(series_from(series));
    return plot;
}

std::vector<std::string> texts_from(const std::vector<JsonReader>& items) {
    std::vector<std::string> texts;
    for (const JsonReader& item : items)
        texts.push_back(item.text());
    return texts;
}

Table table_from(const JsonReader& in) {
    Table table{in.member("title").text(), texts_from(in.member("head").items()), {}};
    for (const JsonReader& row : in.member("rows").items())
        table.rows.push_back(texts_from(row.items(table.head.size())));
    return table;
}

/// Files are found by their place (picture_file), whatever names the text has.
PictureRow picture_row_from(const JsonReader& in) {
    PictureRow row{in.member("title").text(), {}};
    for (const JsonReader& picture : in.member("pictures").items())
        row.pictures.push_back({picture.member("label").text(), {}});
    return row;
}

StudyResult study_from(const JsonReader& in) {
    StudyResult study{in.member("name").text(), in.member("title").text(), in.member("question").text(),
                      in.member("reference").text(), in.member("command").text()};
    for (const JsonReader& grade : in.member("grades").items())
        study.grades.push_back(grade_from(grade));
    study.plotted_metric = in.member("plotted_metric").text();
    for (const JsonReader& plot : in.member("plots").items())
        study.plots.push_back(plot_from(plot));
    for (const JsonReader& table : in.member("tables").items())
        study.tables.push_back(table_from(table));
    if (const std::optional<JsonReader> rows = in.optional_member("pictures"))
        for (const JsonReader& row : rows->items())
            study.pictures.push_back(picture_row_from(row));
    study.incomplete = in.member("incomplete").text();
    study.duration_s = in.member("duration_s").number();
    return study;
}

}  // namespace

std::string to_json(const StudyRun& run) {
    const StudyResult& study = run.result;
    const auto fact = [](const auto& pair) {
        return Json{{"name", pair.first}, {"value", pair.second}};
    };
    const Json json{
        {"schema", k_schema},
        {"name", study.name},
        {"title", study.title},
        {"question", study.question},
        {"reference", study.reference},
        {"command", study.command},
        {"incomplete", study.incomplete},
        {"duration_s", number(study.duration_s)},
        {"facts", array_of(run.facts, fact)},
        {"plotted_metric", study.plotted_metric},
        {"grades", array_of(study.grades, [](const GradeResult& grade) { return to_value(grade); })},
        {"plots", array_of(study.plots, [](const Plot& plot) { return to_value(plot); })},
        {"tables", array_of(study.tables, [](const Table& table) { return to_value(table); })},
        {"pictures", picture_rows(study)}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace).append("\n");
}

StudyRun from_json(std::string_view text, const std::string& file) {
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        throw assets::Error{file, "", fmt::format("no JSON ({})", error.what()), "a study"};
    }
    const JsonReader in{json, file};
    in.member("schema").exactly(k_schema);
    StudyRun run{study_from(in), {}};
    for (const JsonReader& fact : in.member("facts").items())
        run.facts.emplace_back(fact.member("name").text(), fact.member("value").text());
    return run;
}

StudyRun read_study(const std::filesystem::path& file) {
    std::error_code failed;
    if (std::filesystem::is_directory(file, failed))
        throw assets::Error{file.string(), "", "a folder", "a study's JSON file"};
    const std::uintmax_t bytes = std::filesystem::file_size(file, failed);
    if (!failed && bytes > k_most_bytes)
        throw assets::Error{file.string(), "", fmt::format("{} bytes", bytes),
                            fmt::format("at most {}", k_most_bytes)};
    std::ifstream in{file, std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    if (failed || !in.is_open() || in.bad())
        throw assets::Error{file.string(), "", "a file that cannot be read", "a study's JSON file"};
    return from_json(text, file.string());
}

}  // namespace rambla::game::study
