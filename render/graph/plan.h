#pragma once

#include <cstdint>
#include <vector>

namespace rambla::render::graph {

inline constexpr std::uint32_t k_none = 0xffffffffu;

/// How a pass touches a resource; decides which memory barrier a reader needs after an incoherent write.
enum class Use : std::uint8_t {
    sampled,     ///< texture unit
    image,       ///< image load or store
    attachment,  ///< colour or depth attachment
    storage,     ///< shader storage block
    uniform,     ///< uniform block
    indirect,    ///< indirect commands
    vertex,      ///< vertex attributes
    index,       ///< vertex indices
    transfer     ///< copies and read-backs
};
using UseMask = std::uint32_t;
[[nodiscard]] constexpr UseMask mask_of(Use use) {
    return 1u << static_cast<unsigned>(use);
}

/// One declaration of a pass.
struct Access {
    std::uint32_t reads = k_none;   ///< version whose contents the pass needs
    std::uint32_t writes = k_none;  ///< version that it makes
    Use use = Use::sampled;
};

/// The contents of a resource between two writes.
struct Version {
    std::uint32_t resource = 0;
    std::uint32_t writer = k_none;    ///< pass; none: what the resource held before the frame
    std::uint32_t previous = k_none;  ///< version that the writer replaced
    std::uint32_t next = k_none;      ///< version that replaces this one
};

struct Resource {
    bool transient = true;
    bool keep = false;         ///< its final contents are wanted after the frame
    std::uint32_t layout = 0;  ///< transient resources of equal layout can share memory
    std::uint32_t latest = 0;  ///< version
};

struct Pass {
    std::uint32_t first_access = 0;
    std::uint32_t access_count = 0;
    bool side_effect = false;
};

/// A frame as its passes declared it. Knows nothing of GL.
struct Recording {
    std::vector<Resource> resources;
    std::vector<Version> versions;
    std::vector<Access> accesses;
    std::vector<Pass> passes;

    void clear();
    /// @return  the resource's first version
    std::uint32_t add_resource(const Resource& resource);
    std::uint32_t add_pass();
    /// These concern the pass added last, so that a pass's accesses lie together. @throws std::logic_error on
    /// handles of other frames, and on writes to contents that another pass has replaced
    void read(std::uint32_t pass, std::uint32_t version, Use use);
    /// @param loads  the pass needs what the version held
    /// @return       the new version
    std::uint32_t write(std::uint32_t pass, std::uint32_t version, Use use, bool loads);
};

/// From the first to the last position (in Plan::order) that touches a transient resource.
struct Lifetime {
    std::uint32_t first = k_none;  ///< none: no living pass touches it
    std::uint32_t last = 0;
    std::uint32_t slot = k_none;  ///< of memory, shared with others of the same layout
};

/// What to run, in which order, with which memory and barriers.
struct Plan {
    std::vector<std::uint32_t> order;  ///< living passes
    std::vector<UseMask> barriers;     ///< per position: uses that earlier incoherent writes must reach
    std::vector<Lifetime> lifetimes;   ///< per resource
    std::vector<std::uint32_t> slot_layouts;  ///< per slot of memory
};

/// Turns recordings into plans; keeps its memory between frames.
class Planner {
public:
    /// Passes nobody needs are left out: living are those with side effects, the last writers of kept
    /// resources, and whatever living ones read from. The order is the recorded one, changed only as far as
    /// reads and writes demand.
    /// @throws std::logic_error  when passes wait for each other in a circle
    [[nodiscard]] const Plan& plan(const Recording& recording);

private:
    void cull(const Recording& recording);
    void link(const Recording& recording);
    void sort(const Recording& recording);
    void place(const Recording& recording);
    void find_barriers(const Recording& recording);

    struct Edge {
        std::uint32_t before;
        std::uint32_t after;
    };
    struct Incoherent {
        bool written = false;
        UseMask reached = 0;
    };
    Plan plan_;
    std::vector<std::uint8_t> alive_;
    std::vector<std::uint32_t> work_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> waiting_for_;
    std::vector<std::uint8_t> slot_taken_;
    std::vector<Incoherent> incoherent_;
};

}  // namespace rambla::render::graph
