#include "game/entity_browser.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "systems/components.h"

namespace rambla::game {
namespace {

constexpr float k_width_px = 400.0f;
constexpr float k_height_px = 700.0f;

/// The browser in a window of its own, and a mouse.
struct Browser : testing::Test {
    ecs::World world;
    ecs::Entity parent = world.create(systems::LocalTransform{});
    ecs::Entity child = world.create(systems::LocalTransform{}, ecs::Parent{parent});
    ImGuiContext* context = ImGui::CreateContext();
    EntityBrowser browser{world};

    Browser() {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {k_width_px, k_height_px};
        io.Fonts->Build();
        draw();
        click(60.0f, 18.0f);  // unfolds the heading
    }
    ~Browser() override { ImGui::DestroyContext(context); }

    void draw() {
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({k_width_px, k_height_px});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoTitleBar);
        browser.draw();
        ImGui::End();
        ImGui::Render();
    }
    void click(float x_px, float y_px, float drag_px = 0.0f) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {x_px, y_px};
        draw();
        io.MouseDown[0] = true;
        draw();
        io.MousePos = {x_px + drag_px, y_px};
        draw();
        io.MouseDown[0] = false;
        draw();
    }
    /// Clicks, or drags to the right, further and further down until something has come true.
    template <class Fact>
    bool clicked_until(float x_px, float drag_px, const Fact& fact) {
        for (float y_px = 34.0f; y_px < k_height_px; y_px += 4.0f) {
            click(x_px, y_px, drag_px);
            if (fact()) return true;
        }
        return false;
    }
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
