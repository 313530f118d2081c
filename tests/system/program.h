#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace rambla::system_test {

using Environment = std::map<std::string, std::string>;

/// What a program left behind.
struct Ended {
    int exit_code = -1;  ///< −1: it was killed, by a signal or because its time was up
    std::string out;     ///< standard output
    std::string err;     ///< standard error
};

/// A child process whose output goes to files. Killed when its owner is gone.
class Process {
public:
    /// @param changes  environment variables that differ from ours; an empty value takes one away
    Process(const std::vector<std::string>& command, const Environment& changes,
            const std::filesystem::path& folder);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    [[nodiscard]] bool running();
    /// Waits for the end, and kills the process once `limit` is over.
    [[nodiscard]] Ended wait(std::chrono::seconds limit);
    void terminate();

private:
    void reap(int flags);

    pid_t pid_ = -1;
    bool ended_ = false;
    int status_ = 0;
    std::filesystem::path out_, err_;
};

/// Long enough for the slowest run here on a loaded machine with a software rasteriser and a cold shader
/// cache.
inline constexpr std::chrono::seconds k_patience{240};

/// Runs rambla without a display in `folder`, and waits for it.
[[nodiscard]] Ended rambla(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// Asks again and again until the answer is yes. @return  false if that took longer than `limit`
[[nodiscard]] bool eventually(const std::function<bool()>& question, std::chrono::seconds limit = k_patience);

/// A folder of one test's own, gone when the test is over.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string file_text(const std::filesystem::path& file);
void write_file(const std::filesystem::path& file, const std::string& text);
[[nodiscard]] std::size_t line_count(const std::string& text);

}  // namespace rambla::system_test
