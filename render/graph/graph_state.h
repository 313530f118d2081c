#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/gl/vertex_array.h"
#include "render/graph/graph.h"
#include "render/graph/pool.h"
#include "render/graph/timers.h"

namespace rambla::render {

/// What RenderGraph holds; shared by the files that record, execute and draw it.
struct RenderGraph::State {
    enum class Kind : std::uint8_t { transient, imported, default_framebuffer };

    struct ResourceInfo {
        const char* name = "";
        std::uint32_t layout = 0;
        Kind kind = Kind::transient;
        graph::Pool::Memory memory;  ///< imported: from the start; transient: while the graph runs
    };

    struct Target {
        std::uint32_t version = graph::k_none;
        LoadOp load = LoadOp::load;
        std::uint32_t level = 0;
        glm::vec4 clear{0.0f};
    };

    struct PassInfo {
        const char* name = "";
        graph::Callback<PassContext&> callback;
        std::array<Target, gl::k_max_colour_attachments> colours;
        Target depth;
    };

    graph::Recording recording;
    std::vector<ResourceInfo> resources;
    std::vector<graph::Layout> layouts;
    std::vector<PassInfo> passes;

    graph::Planner planner;
    const graph::Plan* plan = nullptr;
    graph::Pool pool;
    std::vector<graph::Pool::Memory> slots;  ///< of the running frame
    graph::FramebufferCache framebuffers;
    graph::Timers timers;
    gl::VertexArray no_vertices{"no vertices"};

    [[nodiscard]] std::uint32_t layout_index(const graph::Layout& layout);
    [[nodiscard]] const ResourceInfo& info(std::uint32_t version) const {
        return resources[recording.versions[version].resource];
    }
    [[nodiscard]] const graph::Layout& layout(std::uint32_t version) const {
        return layouts[info(version).layout];
    }
    [[nodiscard]] std::uint32_t add(const ResourceInfo& resource, bool keep);
};

}  // namespace rambla::render
