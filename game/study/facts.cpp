#include "game/study/facts.h"

#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "game/machine.h"
#include "game/options.h"

namespace rambla::game::study {
namespace {

std::string now_utc() {
    const auto now = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
    return fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(now)));
}

/// Mesa's rasteriser on the CPU has threads of its own.
std::string rasteriser_threads() {
    const char* const asked = std::getenv("LP_NUM_THREADS");
    return asked != nullptr ? asked : "as many as processors";
}

}  // namespace

RunFacts run_facts(StudyContext& context) {
    const render::DeviceInfo device = context.thread().device();
    RunFacts facts{{"date", now_utc()},
                   {"processor", processor_name()},
                   {"processors", std::to_string(std::thread::hardware_concurrency())},
                   {"worker threads", std::to_string(worker_count())},
                   {"renderer", device.renderer},
                   {"driver", device.version}};
    if (device.software) facts.emplace_back("rasteriser threads (LP_NUM_THREADS)", rasteriser_threads());
    facts.emplace_back("compiler", compiler_name());
    facts.emplace_back("C library", c_library_name());
    facts.emplace_back("Rambla", RAMBLA_VERSION);
    facts.emplace_back("seed", std::to_string(context.options().seed));
    return facts;
}

}  // namespace rambla::game::study
