#include "game/entity_browser.h"

#include <gtest/gtest.h>

#include "systems/components.h"
#include "unit/game/panel.h"

namespace rambla::game {
namespace {

constexpr float k_width_px = 400.0f;

struct Browser : Panel {
    ecs::World world;
    ecs::Entity parent = world.create(systems::LocalTransform{});
    ecs::Entity child = world.create(systems::LocalTransform{}, ecs::Parent{parent});
    EntityBrowser browser{world};

    Browser() : Panel{k_width_px, 700.0f} {
        draw();
        click(60.0f, 18.0f);  // unfolds the heading
    }
    void draw_widgets() override { browser.draw(); }

    /// Clicks archetypes, and entities below, until the entity is chosen.
    bool choose(ecs::Entity entity) {
        for (float archetype_px = 34.0f; archetype_px < 120.0f; archetype_px += 8.0f) {
            for (float y_px = archetype_px; y_px < 200.0f; y_px += 8.0f) {
                click(100.0f, archetype_px);
                click(100.0f, y_px);
                if (browser.chosen() == entity) return true;
            }
        }
        return false;
    }
};

TEST_F(Browser, AClickChoosesAnEntity) {
    EXPECT_EQ(browser.chosen(), ecs::Entity{});
    EXPECT_TRUE(choose(child));
    EXPECT_TRUE(choose(parent));
}

TEST_F(Browser, DraggingANumberChangesTheComponent) {
    ASSERT_TRUE(choose(parent));
    // On the way down, clicks into the lists may choose the other one.
    const auto chosen = [this]() -> const systems::LocalTransform& {
        return world.get<systems::LocalTransform>(browser.chosen());
    };
    EXPECT_TRUE(clicked_until(190.0f, 40.0f, [&] { return chosen().translation_m.x > 0.0f; }));
    EXPECT_EQ(chosen().translation_m.y, 0.0f);
    EXPECT_EQ(chosen().scale, glm::vec3{1.0f});
}

TEST_F(Browser, AFieldThatIsAnEntityLeadsThere) {
    ASSERT_TRUE(choose(child));
    bool led = false;
    for (float x_px = 150.0f; x_px < k_width_px && !led; x_px += 15.0f)
        led = clicked_until(x_px, 0.0f, [&] { return browser.chosen() == parent; });
    EXPECT_TRUE(led);
    EXPECT_EQ(world.get<ecs::Parent>(child).entity, parent);
}

TEST_F(Browser, AnEntityThatEndsIsNoLongerShown) {
    ASSERT_TRUE(choose(child));
    world.destroy(child);
    draw();
    EXPECT_EQ(browser.chosen(), ecs::Entity{});
}

}  // namespace
}  // namespace rambla::game
