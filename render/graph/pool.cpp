#include "render/graph/pool.h"

namespace rambla::render::graph {

void Pool::begin_frame() {
    for (Entry& entry : entries_) {
        entry.idle_frames = entry.taken ? 0 : entry.idle_frames + 1;
        entry.taken = false;
    }
    std::erase_if(entries_, [](const Entry& entry) { return entry.idle_frames > k_idle_frames; });
}

Pool::Memory Pool::acquire(const Layout& layout, const char* name) {
    const auto memory_of = [](const Entry& entry) {
        return entry.layout.buffer_bytes != 0 ? Memory{entry.buffer.name(), 0}
                                              : Memory{entry.texture.name(), entry.texture.id()};
    };
    for (Entry& entry : entries_) {
        if (entry.taken || entry.layout != layout) continue;
        entry.taken = true;
        return memory_of(entry);
    }
    Entry& entry = entries_.emplace_back();
    entry.layout = layout;
    entry.taken = true;
    if (layout.buffer_bytes != 0) {
        entry.buffer = gl::Buffer{name, layout.buffer_bytes};
    } else {
        entry.texture = gl::Texture{name, layout.texture};
    }
    return memory_of(entry);
}

std::uint64_t Pool::bytes() const {
    std::uint64_t sum = 0;
    for (const Entry& entry : entries_)
        sum += entry.texture.bytes() + entry.buffer.size();
    return sum;
}

void FramebufferCache::begin_frame() {
    for (Entry& entry : entries_)
        ++entry.idle_frames;
    std::erase_if(entries_, [](const Entry& entry) { return entry.idle_frames > k_idle_frames; });
}

GLuint FramebufferCache::get(const Key& key, const gl::FramebufferDesc& desc, const char* name) {
    for (Entry& entry : entries_) {
        if (entry.key != key) continue;
        entry.idle_frames = 0;
        return entry.framebuffer.name();
    }
    entries_.push_back({.key = key, .framebuffer = gl::Framebuffer{name, desc}});
    return entries_.back().framebuffer.name();
}

}  // namespace rambla::render::graph
