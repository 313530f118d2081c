#include "system/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace rambla::system_test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds k_poll{20};

std::vector<std::string> changed_environment(const Environment& changes) {
    std::vector<std::string> result;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (changes.count(text.substr(0, text.find('='))) == 0) result.push_back(text);
    }
    for (const auto& [name, value] : changes) {
        if (!value.empty()) result.push_back(name + "=" + value);
    }
    return result;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const Environment& changes, const fs::path& folder)
    : out_{folder / (fs::path{command.front()}.filename().string() + ".out")},
      err_{fs::path{out_}.replace_extension(".err")} {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), O_CREAT | O_WRONLY | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err_.c_str(), O_CREAT | O_WRONLY | O_TRUNC,
                                     0600);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    std::vector<std::string> arguments = command;
    std::vector<std::string> environment = changed_environment(changes);
    const int error = posix_spawnp(&pid_, command.front().c_str(), &actions, nullptr,
                                   pointers(arguments).data(), pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error{command.front() + " cannot be started"};
}

Process::~Process() {
    if (!running()) return;
    kill(pid_, SIGKILL);
    reap(0);
}

bool Process::running() {
    if (!ended_) reap(WNOHANG);
    return !ended_;
}

Ended Process::wait(std::chrono::seconds limit) {
    const Clock::time_point deadline = Clock::now() + limit;
    while (running() && Clock::now() < deadline)
        std::this_thread::sleep_for(k_poll);
    if (running()) {
        kill(pid_, SIGKILL);
        reap(0);
    }
    return {.exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : -1,
            .out = file_text(out_),
            .err = file_text(err_)};
}

void Process::terminate() {
    if (running()) kill(pid_, SIGTERM);
}

void Process::reap(int flags) {
    ended_ = waitpid(pid_, &status_, flags) == pid_;
}

Ended rambla(const std::vector<std::string>& arguments, const fs::path& folder) {
    std::vector<std::string> command{RAMBLA_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return Process{command, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}, folder}.wait(k_patience);
}

bool eventually(const std::function<bool()>& question, std::chrono::seconds limit) {
    const Clock::time_point deadline = Clock::now() + limit;
    for (;;) {
        if (question()) return true;
        if (Clock::now() > deadline) return false;
        std::this_thread::sleep_for(k_poll);
    }
}

ScratchFolder::ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "rambla-system-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error{"no scratch folder can be made: " + name};
    path_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string file_text(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void write_file(const fs::path& file, const std::string& text) {
    std::ofstream{file, std::ios::binary} << text;
}

std::size_t line_count(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace rambla::system_test
