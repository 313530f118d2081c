#include "bench/harness/run.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "bench/harness/machine.h"
#include "bench/harness/measurement.h"
#include "bench/harness/table.h"

namespace rambla::bench {
namespace {

struct Options {
    bool quick = false;
    std::string json;
    int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::string> rest;  ///< for Google Benchmark
};

Options parse(std::span<char*> arguments) {
    Options options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string_view argument = arguments[i];
        const auto value = [&]() -> std::string_view {
            if (i + 1 == arguments.size())
                throw std::invalid_argument{std::string{argument} + " needs a value"};
            return arguments[++i];
        };
        if (argument == "--quick") {
            options.quick = true;
        } else if (argument == "--json") {
            options.json = value();
        } else if (argument == "--threads") {
            const std::string_view text = value();
            const auto [end, error] =
                std::from_chars(text.data(), text.data() + text.size(), options.threads);
            if (error != std::errc{} || end != text.data() + text.size() || options.threads < 1)
                throw std::invalid_argument{"--threads needs a number from 1"};
        } else {
            options.rest.emplace_back(argument);
        }
    }
    return options;
}

/// Google Benchmark's own parser, on our defaults and then the user's words, which win.
void configure(const Options& options, std::vector<std::string> more) {
    std::vector<std::string> words{"bench", "--benchmark_enable_random_interleaving=true",
                                   "--benchmark_report_aggregates_only=false",
                                   options.quick ? "--benchmark_repetitions=3" : "--benchmark_repetitions=5",
                                   options.quick ? "--benchmark_min_time=0.01" : "--benchmark_min_time=0.1"};
    words.insert(words.end(), options.rest.begin(), options.rest.end());
    words.insert(words.end(), more.begin(), more.end());
    std::vector<char*> pointers;
    for (std::string& word : words)
        pointers.push_back(word.data());
    int count = static_cast<int>(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (count > 1) throw std::invalid_argument{fmt::format("unknown argument {}", pointers[1])};
}

/// Collects all repetitions of one benchmark after the other.
class Collector : public benchmark::BenchmarkReporter {
public:
    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration) add(run);
        }
    }

    [[nodiscard]] std::vector<Measurement> take() {
        for (Measurement& measurement : measurements_) {
            for (auto& [name, values] : counters_[measurement.name.variant])
                measurement.counters[name] = median(values);
        }
        counters_.clear();
        return std::exchange(measurements_, {});
    }

private:
    void add(const Run& run) {
        const auto name = parse_name(run.run_name.str());
        if (!name) return;
        if (run.error_occurred) {
            fmt::print(stderr, "{}: {}\n", run.run_name.str(), run.error_message);
            return;
        }
        auto measurement = std::ranges::find(measurements_, *name, &Measurement::name);
        if (measurement == measurements_.end()) {
            measurements_.push_back({*name, {}, {}});
            measurement = measurements_.end() - 1;
        }
        const auto items = run.counters.find("items_per_second");
        measurement->ns_per_item.push_back(items != run.counters.end()
                                               ? 1e9 / items->second.value
                                               : run.real_accumulated_time * 1e9 /
                                                     static_cast<double>(run.iterations));
        for (const auto& [key, counter] : run.counters) {
            if (key != "items_per_second") counters_[name->variant][key].push_back(counter.value);
        }
    }

    std::vector<Measurement> measurements_;
    std::map<std::string, std::map<std::string, std::vector<double>>> counters_;  ///< by variant, by name
};

/// All variants of one operation and size: they run in turns, so that what slows the machine for a while
/// slows all of them.
struct Group {
    BenchmarkName first;
    std::string filter;  ///< a regular expression for exactly these
};

std::vector<Group> groups(const std::string& filter) {
    std::ostringstream names;
    Collector collector;
    collector.SetOutputStream(&names);
    benchmark::RunSpecifiedBenchmarks(&collector, filter);
    std::vector<Group> groups;
    std::istringstream lines{names.str()};
    for (std::string line; std::getline(lines, line);) {
        const auto name = parse_name(line);
        if (!name) {
            fmt::print(stderr, "{}: not named operation/bare/N or operation/rambla/N, left out\n", line);
            continue;
        }
        const auto group = std::ranges::find_if(groups, [&](const Group& other) {
            return other.first.operation == name->operation && other.first.size == name->size;
        });
        if (group == groups.end()) {
            groups.push_back({*name, line});
        } else {
            group->filter += "|" + line;
        }
    }
    for (Group& group : groups)
        group.filter = "^(" + group.filter + ")$";
    return groups;
}

std::vector<Measurement> measure(const std::vector<Group>& groups) {
    std::vector<Measurement> all;
    Collector collector;
    for (const Group& group : groups) {
        fmt::print(stderr, "measuring {} of {}\n", group.first.operation, group.first.size);
        benchmark::RunSpecifiedBenchmarks(&collector, group.filter);
        for (Measurement& measurement : collector.take())
            all.push_back(std::move(measurement));
    }
    return all;
}

int run_or_throw(std::string_view title, std::span<const Target> targets, std::span<char*> arguments) {
    const Options options = parse(arguments);
    configure(options, {"--benchmark_list_tests=true"});
    const std::vector<Group> found = groups(benchmark::GetBenchmarkFilter());
    configure(options, {"--benchmark_list_tests=false"});

    const tbb::global_control threads{tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(options.threads)};
    const std::vector<Measurement> measurements = measure(found);
    const std::vector<Row> rows = make_rows(measurements, targets);
    const Machine machine = this_machine(options.threads);
    fmt::print("{}\n{}", title, to_text(rows, machine));
    if (!options.json.empty()) {
        std::ofstream file{options.json};
        file << to_json(rows, measurements, machine);
        if (!file.flush()) throw std::runtime_error{"cannot write " + options.json};
    }
    return 0;
}

}  // namespace

int run(std::string_view title, std::span<const Target> targets, int argc, char** argv) {
    try {
        return run_or_throw(title, targets, std::span{argv, static_cast<std::size_t>(argc)}.subspan(1));
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return 2;
    }
}

}  // namespace rambla::bench
