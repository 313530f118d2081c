#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "assets/image.h"

namespace rambla::game {

/// Encodes and writes pictures on worker threads, so that drawing goes on meanwhile.
class PictureWriter {
public:
    PictureWriter();
    ~PictureWriter();  ///< waits for what is left; errors that nobody asked for are logged
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;

    /// Queues a picture; waits only while too many are queued already. @throws assets::Error  of an earlier
    /// picture
    void write(std::filesystem::path file, assets::Image image);
    /// Queues other work of the same kind.
    void run(std::function<void()> work);
    /// Waits until all is written. @throws assets::Error  of any of them
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace rambla::game
