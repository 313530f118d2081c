#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets/error.h"
#include "game/commands/command.h"
#include "game/exit_code.h"
#include "game/json_output.h"
#include "game/options.h"
#include "game/size.h"
#include "game/study/facts.h"
#include "game/study/report/order.h"
#include "game/study/report/report.h"
#include "game/study/study.h"
#include "game/study/summary.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;
using study::StudyResult;

struct StudyCommand {
    Options options;
    study::StudyOptions study;
    std::vector<std::string> names;
    fs::path folder = "out/study";
    fs::path against;  ///< empty: none
};

std::atomic<bool> g_stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

/// The first asks for an end, the second is the system's own.
extern "C" void ask_for_an_end(int signal) {
    g_stop = true;
    std::signal(signal, SIG_DFL);
}

/// While it lives, an interrupt ends a run by the way of its results.
class Interrupts {
public:
    Interrupts() {
        g_stop = false;
        std::signal(SIGINT, ask_for_an_end);
        std::signal(SIGTERM, ask_for_an_end);
    }
    ~Interrupts() {
        std::signal(SIGINT, SIG_DFL);
        std::signal(SIGTERM, SIG_DFL);
    }
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;
};

/// How to run a study again, with what the user has asked for.
std::string command_text(const StudyCommand& command, std::string_view name) {
    std::string text = fmt::format("rambla study {}", name);
    const study::StudyOptions& asked = command.study;
    if (asked.size_px != glm::uvec2{0})
        text += fmt::format(" --size {}x{}", asked.size_px.x, asked.size_px.y);
    if (asked.rounds > 0) text += fmt::format(" --rounds {}", asked.rounds);
    if (asked.quick) text += " --quick";
    return text + fmt::format(" --seed {}", asked.seed);
}

std::vector<std::string> names_in_order() {
    std::vector<std::string> names;
    for (const study::Study* known : study::all_studies())
        names.emplace_back(known->name);
    return names;
}

/// Compares with an earlier run. @return  whether there was something to compare, and no pair of grades
/// changed places by more than its spreads
bool tell_reversals(const study::StudyRun& before, const std::vector<StudyResult>& results,
                    std::string& text) {
    std::size_t compared = 0;
    std::size_t reversed = 0;
    bool enough_rounds = study::has_enough_rounds(before.result);
    for (const StudyResult& result : results) {
        if (result.name != before.result.name) continue;
        enough_rounds = enough_rounds && study::has_enough_rounds(result);
        compared += study::compared_pairs(before.result, result);
        for (const study::Reversal& reversal : study::same_order(before.result, result)) {
            text += fmt::format("CHANGED PLACES  {}\n", study::to_text(reversal));
            ++reversed;
        }
    }
    text += fmt::format(
        "{}: {} pairs of grades differ by more than their spreads in both runs, {} changed places\n",
        before.result.name, compared, reversed);
    if (compared == 0) {
        text += fmt::format("NOTHING COMPARED  {}\n",
                            enough_rounds ? "no two grades differ by more than their spreads in both runs"
                                          : "one of the runs has fewer than three rounds");
    }
    return compared > 0 && reversed == 0;
}

/// The earlier run, where one is asked for. @throws std::invalid_argument  if it is of a study that is not
/// run
std::optional<study::StudyRun> earlier_run(const StudyCommand& command,
                                           const std::vector<const study::Study*>& studies) {
    if (command.against.empty()) return std::nullopt;
    study::StudyRun before = study::read_study(command.against);
    const bool run = std::any_of(studies.begin(), studies.end(), [&](const study::Study* chosen) {
        return chosen->name == before.result.name;
    });
    if (!run)
        throw std::invalid_argument{
            fmt::format("{}: found a run of the study '{}', expected one of those to be run",
                        command.against.string(), before.result.name)};
    return before;
}

nlohmann::json summary_json(const std::vector<StudyResult>& results, const fs::path& folder) {
    nlohmann::json studies = nlohmann::json::array();
    for (const StudyResult& result : results) {
        studies.push_back({{"name", result.name},
                           {"duration_s", result.duration_s},
                           {"grades", result.grades.size()},
                           {"incomplete", result.incomplete}});
    }
    return {{"schema", "rambla.studies/1"}, {"out", folder.string()}, {"studies", studies}};
}

int run(StudyCommand& command) {
    prepare_json(command.options.json);
    const std::vector<const study::Study*> studies = study::find_studies(command.names);
    const std::optional<study::StudyRun> before = earlier_run(command, studies);
    const tbb::global_control limit = worker_limit(command.options);
    const Interrupts interrupts;
    study::StudyContext context{command.study, g_stop};
    const study::RunFacts facts = study::run_facts(context);
    const std::vector<std::string> order = names_in_order();
    std::vector<StudyResult> results;
    // Before the first study, too: a folder that cannot be written to is known before the work.
    study::write_report(command.folder, {}, facts, order);
    std::string text;
    bool complete = true;
    for (const study::Study* chosen : studies) {
        if (context.stopped()) break;
        results.push_back(study::run_study(*chosen, context, command_text(command, chosen->name)));
        // Those before it are read back from the folder, as those of earlier runs are.
        study::write_report(command.folder, std::span{&results.back(), 1}, facts, order);
        text += study::to_text(results.back());
        complete = complete && results.back().incomplete.empty();
    }
    complete = complete && results.size() == studies.size();
    if (context.stopped() && !complete) {
        spdlog::warn("Interrupted: {} of {} studies were begun and are in {}; what is incomplete is marked",
                     results.size(), studies.size(), command.folder.string());
    }
    const bool same_order = !before || tell_reversals(*before, results, text);
    print_result(command.options.json, text);
    write_json(command.options.json, summary_json(results, command.folder));
    spdlog::info("The report is {}", (command.folder / "index.html").string());
    return complete && same_order ? k_done : k_check_failed;
}

}  // namespace

Command add_study(CLI::App& program) {
    CLI::App* const line = program.add_subcommand(
        "study", "Measures what accuracy costs: grades of a technique against each other and a reference");
    const auto command = std::make_shared<StudyCommand>();
    command->study.quiet = false;
    std::string footer = "Studies:\n  all           every one\n";
    for (const study::Study* known : study::all_studies())
        footer += fmt::format("  {:<14}{}\n", known->name, known->summary);
    line->footer(
        footer +
        "\nGrades take turns, so that what slows the machine slows all of them; times are medians, with "
        "the interval\nthat holds four fifths of the rounds. NAME.csv, NAME.json, NAME.svg and a section "
        "of index.html are written for\neach; sections of earlier runs in the folder stay. An interrupt "
        "(Ctrl-C) ends with what has been measured,\nmarked as incomplete, and with exit code 1.\n");
    line->add_option("NAME", command->names, "Which studies: names, or all")
        ->required()
        ->type_name("NAME...");
    line->add_option("-o,--out", command->folder, "Folder for the report")
        ->type_name("DIR")
        ->capture_default_str();
    line->add_option_function<std::string>(
            "--size",
            [command](const std::string& text) {
                command->study.size_px = usage_checked("--size", [&] { return parse_size(text); });
            },
            "Size of the pictures, instead of those that each study goes through")
        ->type_name("WIDTHxHEIGHT");
    line->add_option("--rounds", command->study.rounds,
                     "How often each grade is measured (default: as suits)")
        ->type_name("N")
        ->transform(whole_number(1, 10'000));
    line->add_option("--seed", command->study.seed, "Of generated scenes and of samples")
        ->type_name("N")
        ->transform(whole_number())
        ->capture_default_str();
    line->add_flag("--quick", command->study.quick,
                   "Small and few pictures, for tests: everything runs, and the numbers mean little");
    line->add_option("--against", command->against,
                     "NAME.json of an earlier run: ends with 1 if grades have changed places in cost by more "
                     "than their spreads, or if there are none to compare: none differ by that much in both "
                     "runs, or one has fewer than three rounds")
        ->type_name("FILE.json");
    line->add_option("--threads", command->options.threads,
                     "Threads that process and trace (default: all cores)")
        ->type_name("N")
        ->transform(whole_number(1, 1024));
    add_message_options(*line, command->options);
    return {line, [command] {
                command->study.quiet = command->options.quiet;
                return run(*command);
            }};
}

}  // namespace rambla::game
