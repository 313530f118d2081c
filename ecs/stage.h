#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "ecs/job.h"
#include "ecs/system.h"

namespace rambla::ecs::detail {

/// Systems between two points at which structural changes are made, run as their waits allow.
class Stage {
public:
    /// The next system in the order of the plan. What is passed by reference must outlive the stage.
    /// @param place  its place in the plan
    /// @param waits  systems that it waits for, counted within the stage
    void add(SystemBody& body, std::size_t place, const std::string& name, const AccessSet& access,
             const std::vector<JobLanes*>& lanes, const std::vector<std::size_t>& waits);

    /// Runs all systems, whatever some of them throw. @param team  null: all on this thread, in order
    void run(World& world, CommandQueue& commands, Team* team);
    /// Throws what the first system that threw has thrown, naming it.
    void rethrow() const;

    /// Where and when a system ran.
    struct Ran {
        std::uint64_t ns = 0;
        std::chrono::steady_clock::time_point begin{};
        std::thread::id thread{};  ///< none: it has not run yet
    };
    [[nodiscard]] const Ran& last_run(std::size_t system) const { return nodes_[system]->last; }
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }

private:
    struct Node {
        Stage* stage;
        SystemBody* body;
        SystemContext context;
        bool exclusive;
        std::vector<Node*> followers;
        std::uint32_t wait_count = 0;
        std::atomic<std::uint32_t> waiting{0};  ///< for so many that have not ended
        Node* next = nullptr;                   ///< of those that one thread has ready
        Ran last;
        std::exception_ptr error;
    };
    /// Ready systems that one thread is going to run.
    class Ready;

    static void run_node(Node& node) noexcept;
    /// Runs systems as long as this thread has ready ones.
    void work(Ready& ready);
    /// Puts a system that is ready where it is done soonest: on this thread if it has nothing else to do or
    /// the system is short, else on any.
    void share(Node& node, Ready& ready);

    std::vector<std::unique_ptr<Node>> nodes_;
    Team* team_ = nullptr;
};

}  // namespace rambla::ecs::detail
