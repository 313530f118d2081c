#include "ecs/stage.h"

#include <chrono>
#include <utility>

#include "ecs/access_scope.h"
#include "ecs/iteration.h"
#include "ecs/misuse.h"

namespace rambla::ecs::detail {
namespace {

/// A shorter system is done sooner than another thread has begun it.
constexpr std::uint64_t k_shortest_shared_ns = 10'000;

[[noreturn]] void throw_naming(std::string_view system, const std::exception_ptr& error) {
    const std::string prefix = "system \"" + std::string{system} + "\": ";
    try {
        std::rethrow_exception(error);
    } catch (const Misuse& misuse) {
        throw Misuse{prefix + misuse.what()};
    } catch (const std::exception& other) {
        std::throw_with_nested(SystemFailed{prefix + other.what()});
    } catch (...) {
        std::throw_with_nested(SystemFailed{prefix + "threw something that is not a std::exception"});
    }
}

}  // namespace

class Stage::Ready {
public:
    [[nodiscard]] bool empty() const { return first_ == nullptr; }
    void push(Node& node) { node.next = std::exchange(first_, &node); }
    Node& pop() { return *std::exchange(first_, first_->next); }

private:
    Node* first_ = nullptr;
};

void Stage::add(SystemBody& body, std::size_t place, const std::string& name, const AccessSet& access,
                const std::vector<JobLanes*>& lanes, const std::vector<std::size_t>& waits) {
    auto node = std::make_unique<Node>();
    node->stage = this;
    node->body = &body;
    node->context.name = name;
    node->context.place = static_cast<std::uint32_t>(place);
    node->context.access = &access;
    node->context.lanes = lanes;
    node->exclusive = access.everything();
    node->wait_count = static_cast<std::uint32_t>(waits.size());
    for (const std::size_t earlier : waits)
        nodes_[earlier]->followers.push_back(node.get());
    nodes_.push_back(std::move(node));
}

void Stage::run(World& world, CommandQueue& commands, Team* team) {
    team_ = team;
    for (const auto& node : nodes_) {
        node->context.world = &world;
        node->context.commands = &commands;
        node->context.team = team;
        node->waiting.store(node->wait_count, std::memory_order_relaxed);
        node->error = nullptr;
    }
    if (team == nullptr) {
        for (const auto& node : nodes_)
            run_node(*node);
        return;
    }
    Ready ready;
    for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
        if ((*node)->wait_count == 0) share(**node, ready);
    }
    work(ready);
    team->wait();
}

void Stage::share(Node& node, Ready& ready) {
    if (ready.empty() || (node.last.thread != std::thread::id{} && node.last.ns < k_shortest_shared_ns)) {
        ready.push(node);
        return;
    }
    team_->spawn(
        [](void* argument) {
            Node& spawned = *static_cast<Node*>(argument);
            Ready own;
            own.push(spawned);
            spawned.stage->work(own);
        },
        &node);
}

void Stage::work(Ready& ready) {
    while (!ready.empty()) {
        Node& node = ready.pop();
        run_node(node);
        for (auto follower = node.followers.rbegin(); follower != node.followers.rend(); ++follower) {
            if ((*follower)->waiting.fetch_sub(1, std::memory_order_acq_rel) == 1) share(**follower, ready);
        }
    }
}

void Stage::run_node(Node& node) noexcept {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    SystemContext& context = node.context;
    context.job_count = 0;
    try {
        {
            const AccessScope scope{*context.world, context.name, *context.access};
            if (node.exclusive) {
                node.body->run(context);
            } else {
                const IterationMark mark{*context.world, &context};
                node.body->run(context);
            }
        }
        node.body->finish(context);
    } catch (...) {
        node.error = std::current_exception();
        node.body->forget();
    }
    node.last = {.ns = static_cast<std::uint64_t>(
                     std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start).count()),
                 .begin = start,
                 .thread = std::this_thread::get_id()};
}

void Stage::rethrow() const {
    for (const auto& node : nodes_) {
        if (node->error != nullptr) throw_naming(node->context.name, node->error);
    }
}

}  // namespace rambla::ecs::detail
