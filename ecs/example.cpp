// Balls fall, bounce and come to rest; those at rest are taken away.

#include <cstdio>

#include "ecs/schedule.h"
#include "ecs/world.h"

using namespace rambla::ecs;

struct Height {
    float above_floor_m;
};
struct Speed {
    float up_m_s;
};
struct Resting {};  // without data: a tag
struct Clock {
    float step_s;
};

int main() {
    World world;
    world.set_resource(Clock{1.0f / 60.0f});
    for (int i = 0; i < 5000; ++i)
        world.create(Height{0.001f * static_cast<float>(i)}, Speed{0.0f});

    Schedule schedule;
    // Chunks of up to 1024 balls, on as many threads as there are.
    schedule.add("fall", [](View<Height, Speed, Without<Resting>> balls, Res<Clock> clock) {
        balls.for_each_chunk([&](const auto& chunk) {
            chunk.each([&](Height& height, Speed& speed) {
                speed.up_m_s -= 9.81f * clock->step_s;
                height.above_floor_m += speed.up_m_s * clock->step_s;
                if (height.above_floor_m >= 0.0f) return;
                height.above_floor_m = 0.0f;
                speed.up_m_s *= -0.5f;
            });
        });
    });
    // Waits for "fall", which writes what it reads. Changes of structure are recorded, then made at sync().
    schedule.add("rest",
                 [](View<Entity, const Height, const Speed, Without<Resting>> balls, Commands& commands) {
                     balls.each([&](Entity ball, const Height& height, const Speed& speed) {
                         if (height.above_floor_m == 0.0f && speed.up_m_s < 0.1f)
                             commands.add(ball, Resting{});
                     });
                 });
    schedule.sync();
    schedule.add("take away", [](View<Entity, With<Resting>> resting, Commands& commands) {
        resting.each([&](Entity ball) { commands.destroy(ball); });
    });

    for (int second = 0; second < 4; ++second) {
        std::printf("after %d s: %zu balls\n", second, world.entity_count());
        for (int step = 0; step < 60; ++step)
            schedule.run(world);
    }
}
