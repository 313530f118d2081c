#include "render/graph/plan.h"

#include <algorithm>
#include <stdexcept>

namespace rambla::render::graph {

void Recording::clear() {
    resources.clear();
    versions.clear();
    accesses.clear();
    passes.clear();
}

std::uint32_t Recording::add_resource(const Resource& resource) {
    const auto version = static_cast<std::uint32_t>(versions.size());
    versions.push_back({.resource = static_cast<std::uint32_t>(resources.size())});
    resources.push_back(resource);
    resources.back().latest = version;
    return version;
}

std::uint32_t Recording::add_pass() {
    passes.push_back({.first_access = static_cast<std::uint32_t>(accesses.size())});
    return static_cast<std::uint32_t>(passes.size() - 1);
}

namespace {

void check(const Recording& recording, std::uint32_t pass, std::uint32_t version) {
    if (version >= recording.versions.size()) {
        throw std::logic_error("render graph: a pass names a handle that nothing in this frame made");
    }
    if (pass + 1 != recording.passes.size()) {
        throw std::logic_error("render graph: a pass declares its accesses outside its set-up step");
    }
}

bool has_contents(const Recording& recording, std::uint32_t version) {
    const Version& v = recording.versions[version];
    return v.writer != k_none || !recording.resources[v.resource].transient;
}

}  // namespace

void Recording::read(std::uint32_t pass, std::uint32_t version, Use use) {
    check(*this, pass, version);
    if (!has_contents(*this, version)) {
        throw std::logic_error("render graph: a pass reads a transient resource that no pass has written");
    }
    accesses.push_back({.reads = version, .use = use});
    ++passes[pass].access_count;
}

std::uint32_t Recording::write(std::uint32_t pass, std::uint32_t version, Use use, bool loads) {
    check(*this, pass, version);
    if (loads && use == Use::attachment && !has_contents(*this, version)) {
        throw std::logic_error("render graph: a pass loads an attachment that no pass has written");
    }
    if (versions[version].next != k_none) {
        throw std::logic_error(
            "render graph: a pass writes to contents that another pass has already replaced");
    }
    const auto made = static_cast<std::uint32_t>(versions.size());
    const std::uint32_t resource = versions[version].resource;
    versions.push_back({.resource = resource, .writer = pass, .previous = version});
    versions[version].next = made;
    resources[resource].latest = made;
    accesses.push_back({.reads = loads ? version : k_none, .writes = made, .use = use});
    ++passes[pass].access_count;
    return made;
}

const Plan& Planner::plan(const Recording& recording) {
    cull(recording);
    link(recording);
    sort(recording);
    place(recording);
    find_barriers(recording);
    return plan_;
}

void Planner::cull(const Recording& recording) {
    alive_.assign(recording.passes.size(), 0);
    work_.clear();
    const auto need = [&](std::uint32_t pass) {
        if (pass == k_none || alive_[pass] != 0) return;
        alive_[pass] = 1;
        work_.push_back(pass);
    };
    for (std::uint32_t p = 0; p < recording.passes.size(); ++p) {
        if (recording.passes[p].side_effect) need(p);
    }
    for (const Resource& resource : recording.resources) {
        if (resource.keep) need(recording.versions[resource.latest].writer);
    }
    while (!work_.empty()) {
        const Pass& pass = recording.passes[work_.back()];
        work_.pop_back();
        for (std::uint32_t a = 0; a < pass.access_count; ++a) {
            const Access& access = recording.accesses[pass.first_access + a];
            if (access.reads != k_none) need(recording.versions[access.reads].writer);
        }
    }
}

// Three reasons to wait: contents come from a writer; they must have been read before they are replaced; and
// of two writers the later one must win. A version that a culled pass would have made does not exist, so the
// search for what is replaced goes back to the last living writer.
void Planner::link(const Recording& recording) {
    edges_.clear();
    const auto add = [&](std::uint32_t before, std::uint32_t after) {
        if (before == k_none || before == after || alive_[before] == 0 || alive_[after] == 0) return;
        edges_.push_back({before, after});
    };
    for (std::uint32_t p = 0; p < recording.passes.size(); ++p) {
        const Pass& pass = recording.passes[p];
        for (std::uint32_t a = 0; a < pass.access_count; ++a) {
            const Access& access = recording.accesses[pass.first_access + a];
            if (access.reads != k_none) {
                add(recording.versions[access.reads].writer, p);
                std::uint32_t next = recording.versions[access.reads].next;
                while (next != k_none) {
                    add(p, recording.versions[next].writer);
                    next = recording.versions[next].next;
                }
            }
            if (access.writes != k_none) {
                std::uint32_t previous = recording.versions[access.writes].previous;
                while (previous != k_none) {
                    add(recording.versions[previous].writer, p);
                    previous = recording.versions[previous].previous;
                }
            }
        }
    }
}

// Kahn 1962, always taking the earliest recorded pass that is ready. Frames have a few dozen passes: scanning
// them all for each is cheaper than a heap.
void Planner::sort(const Recording& recording) {
    plan_.order.clear();
    waiting_for_.assign(recording.passes.size(), 0);
    for (const Edge& edge : edges_)
        ++waiting_for_[edge.after];
    const auto living = static_cast<std::size_t>(std::count(alive_.begin(), alive_.end(), std::uint8_t{1}));
    while (plan_.order.size() < living) {
        std::uint32_t ready = 0;
        while (ready < alive_.size() && (alive_[ready] != 1 || waiting_for_[ready] != 0))
            ++ready;
        if (ready == alive_.size()) {
            throw std::logic_error("render graph: passes wait for each other in a circle");
        }
        alive_[ready] = 2;  // placed
        plan_.order.push_back(ready);
        for (const Edge& edge : edges_) {
            if (edge.before == ready) --waiting_for_[edge.after];
        }
    }
}

void Planner::place(const Recording& recording) {
    plan_.lifetimes.assign(recording.resources.size(), {});
    plan_.slot_layouts.clear();
    slot_taken_.clear();
    for (std::uint32_t position = 0; position < plan_.order.size(); ++position) {
        const Pass& pass = recording.passes[plan_.order[position]];
        for (std::uint32_t a = 0; a < pass.access_count; ++a) {
            const Access& access = recording.accesses[pass.first_access + a];
            const std::uint32_t version = access.writes != k_none ? access.writes : access.reads;
            Lifetime& life = plan_.lifetimes[recording.versions[version].resource];
            life.first = std::min(life.first, position);
            life.last = position;
        }
    }
    for (std::uint32_t position = 0; position < plan_.order.size(); ++position) {
        for (std::size_t r = 0; r < recording.resources.size(); ++r) {
            Lifetime& life = plan_.lifetimes[r];
            const Resource& resource = recording.resources[r];
            if (!resource.transient || life.first != position) continue;
            std::uint32_t slot = 0;
            while (slot < slot_taken_.size() &&
                   (slot_taken_[slot] != 0 || plan_.slot_layouts[slot] != resource.layout)) {
                ++slot;
            }
            if (slot == slot_taken_.size()) {
                slot_taken_.push_back(0);
                plan_.slot_layouts.push_back(resource.layout);
            }
            slot_taken_[slot] = 1;
            life.slot = slot;
        }
        for (const Lifetime& life : plan_.lifetimes) {
            if (life.slot != k_none && life.last == position) slot_taken_[life.slot] = 0;
        }
    }
}

// Image and storage writes are incoherent: another way of access sees them only behind a barrier of its kind.
// One barrier serves all writes before it, so each (memory, use) needs it once per write. The account is kept
// per memory, not per resource, for the next tenant of a slot must not be overtaken by the last one's writes.
void Planner::find_barriers(const Recording& recording) {
    const std::size_t slots = plan_.slot_layouts.size();
    plan_.barriers.assign(plan_.order.size(), 0);
    incoherent_.assign(slots + recording.resources.size(), {});
    const auto state_of = [&](const Access& access) -> Incoherent& {
        const std::uint32_t version = access.writes != k_none ? access.writes : access.reads;
        const std::uint32_t resource = recording.versions[version].resource;
        const std::uint32_t slot = plan_.lifetimes[resource].slot;
        return incoherent_[slot != k_none ? slot : slots + resource];
    };
    for (std::size_t position = 0; position < plan_.order.size(); ++position) {
        const Pass& pass = recording.passes[plan_.order[position]];
        UseMask& barrier = plan_.barriers[position];
        for (std::uint32_t a = 0; a < pass.access_count; ++a) {
            const Access& access = recording.accesses[pass.first_access + a];
            const Incoherent& state = state_of(access);
            if (state.written) barrier |= mask_of(access.use) & ~state.reached;
        }
        if (barrier != 0) {
            for (Incoherent& state : incoherent_)
                state.reached |= barrier;
        }
        for (std::uint32_t a = 0; a < pass.access_count; ++a) {
            const Access& access = recording.accesses[pass.first_access + a];
            if (access.writes == k_none) continue;
            if (access.use == Use::image || access.use == Use::storage) {
                state_of(access) = {.written = true, .reached = 0};
            }
        }
    }
}

}  // namespace rambla::render::graph
