#include "game/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "game/json_output.h"
#include "game/origin.h"
#include "game/size.h"
#include "game/step_clock.h"
#include "systems/position.h"

namespace rambla::game {
namespace {

struct CommandLine : testing::Test {
    CLI::App line{"test"};
    Options options;

    CommandLine() {
        add_scene_options(line, options);
        add_place_options(line, options);
        add_picture_options(line, options);
        add_message_options(line, options);
    }
    void parse(const std::string& text) { line.parse(text); }
    std::string complaint(const std::string& text) {
        try {
            parse(text);
        } catch (const CLI::ParseError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(CommandLine, SetsWhatItNames) {
    parse(
        "--scene city:blocks=1x1 --seed 9 --size 320x180 --shadows focused:size=1024,taps=4 --tonemap aces "
        "--exposure -1.5 --aa none --threads 2 --json -");
    EXPECT_EQ(options.scene, "city:blocks=1x1");
    EXPECT_EQ(options.seed, 9u);
    EXPECT_EQ(options.size_px, glm::uvec2(320, 180));
    EXPECT_EQ(options.settings.shadows.size_texels, 1024);
    EXPECT_EQ(options.settings.shadows.taps, render::ShadowTaps::four);
    EXPECT_EQ(options.settings.tone.curve, render::ToneCurve::aces);
    EXPECT_EQ(options.settings.exposure.ev, -1.5f);
    EXPECT_EQ(options.settings.anti_aliasing.method, render::AntiAliasing::none);
    EXPECT_EQ(options.threads, 2);
    EXPECT_EQ(options.json, "-");
}

TEST_F(CommandLine, ErrorsNameOptionValueAndRange) {
    const std::string text = complaint("--shadows focused:size=100");
    EXPECT_THAT(text, testing::HasSubstr("--shadows"));
    EXPECT_THAT(text, testing::HasSubstr("size is '100', expected a whole number from 256 to 8192 texels"));
    EXPECT_THAT(complaint("--exposure bright"),
                testing::HasSubstr("exposure is 'bright', expected a number of EV or one of: fixed, auto"));
    EXPECT_THAT(complaint("--exposure bright"), testing::Not(testing::HasSubstr("--exposure: --exposure")));
    EXPECT_THAT(complaint("--exposure 17"), testing::HasSubstr("ev is '17', expected -16 to 16 EV"));
    EXPECT_THAT(complaint("--threads 0"), testing::HasSubstr("--threads"));
    EXPECT_THAT(complaint("--nonsense"), testing::HasSubstr("--nonsense"));
}

TEST_F(CommandLine, TexturesHaveABudgetAndAnUploadLimit) {
    EXPECT_EQ(options.settings.textures.budget_mib, 1024.0f);
    parse("--textures budget=12.5,upload=2");
    EXPECT_EQ(options.settings.textures.budget_mib, 12.5f);
    EXPECT_EQ(options.settings.textures.upload_mib, 2.0f);
    EXPECT_THAT(complaint("--textures budget=0"), testing::HasSubstr("0.125 to 65536 MiB"));
    EXPECT_THAT(complaint("--textures size=3"), testing::HasSubstr("budget, upload"));
}

TEST_F(CommandLine, WholeNumbersAreDigitsAlone) {
    for (const char* const text : {"-1", "+1", "1.5", "1e3", "0x10", "many", "18446744073709551616"}) {
        const std::string said = complaint(std::string{"--seed="} + text);
        EXPECT_THAT(said, testing::HasSubstr("--seed")) << text;
        EXPECT_THAT(said,
                    testing::HasSubstr(std::string{"found '"} + text + "', expected a whole number >= 0"));
    }
    EXPECT_NE(complaint("--seed -1"), "");
    EXPECT_EQ(options.seed, 1u);
    parse("--seed 18446744073709551615");
    EXPECT_EQ(options.seed, std::numeric_limits<std::uint64_t>::max());
    parse("--seed 010");
    EXPECT_EQ(options.seed, 10u) << "decimal, whatever the zeros";
    EXPECT_THAT(complaint("--threads -1"),
                testing::HasSubstr("'-1', expected a whole number from 1 to 1024"));
}

TEST_F(CommandLine, TapsAreFourOrSixteen) {
    EXPECT_THAT(complaint("--shadows focused:taps=5"),
                testing::HasSubstr("taps is '5', expected one of: 4, 16"));
}

TEST_F(CommandLine, ExposureIsANumberOrAMethod) {
    parse("--exposure auto:strength=0.5");
    EXPECT_EQ(options.settings.exposure.mode, render::ExposureMode::automatic);
    EXPECT_EQ(options.settings.exposure.strength, 0.5f);
    EXPECT_FALSE(options.own_exposure) << "the light says what auto departs from";
    parse("--exposure auto:ev=2");
    EXPECT_EQ(options.settings.exposure.mode, render::ExposureMode::automatic);
    EXPECT_TRUE(options.own_exposure);
    parse("--exposure +1");
    EXPECT_EQ(options.settings.exposure.ev, 1.0f);
    parse("--exposure -3");
    EXPECT_EQ(options.settings.exposure.mode, render::ExposureMode::fixed);
    EXPECT_EQ(options.settings.exposure.ev, -3.0f);
}

TEST_F(CommandLine, ExposureHasOneSwitch) {
    EXPECT_THAT(complaint("--tonemap aces:exposure=2"), testing::HasSubstr("'exposure'"));
    EXPECT_EQ(options.settings.exposure.ev, 0.0f);
}

TEST_F(CommandLine, HelpExplainsEveryField) {
    const std::string help = line.help();
    for (const auto& parameter : render::k_shadow_parameters)
        EXPECT_THAT(help, testing::HasSubstr(std::string{parameter.help}));
    EXPECT_THAT(help, testing::HasSubstr("256 to 8192 texels"));
}

TEST(Size, IsReadOrRefused) {
    EXPECT_EQ(parse_size("960x540"), glm::uvec2(960, 540));
    EXPECT_EQ(parse_size("16x16384"), glm::uvec2(16, 16384));
    for (const char* const text : {"", "960", "960x", "x540", "960x540x2", "-960x540", "15x540", "960x16385",
                                   "9.5x10", "960 x 540", "99999999999x10"}) {
        EXPECT_THROW(static_cast<void>(parse_size(text)), std::invalid_argument) << text;
    }
}

TEST(Origin, IsReadOrRefused) {
    const systems::WorldPosition place = parse_origin("1000000,-0.5,300.25");
    EXPECT_EQ(place.cell, glm::ivec3(3906, -1, 1));
    EXPECT_EQ(place.local_m, glm::vec3(64.0f, 255.5f, 44.25f));
    for (const char* const text :
         {"", "1", "1,2", "1,2,3,4", "1,2,x", "1,2,nan", "1,2,1e12", " 1,2,3", "1, 2,3"}) {
        EXPECT_THROW(static_cast<void>(parse_origin(text)), std::invalid_argument) << text;
    }
}

TEST(StepClock, CutsTimeIntoStepsWithoutLosingAny) {
    StepClock clock;
    std::uint32_t steps = 0;
    for (int picture = 0; picture < 700; ++picture)
        steps += clock.advance(1.0 / 70.0);
    // 10 s hold 600 steps; the last may still be due by a rounding.
    EXPECT_NEAR(steps, 600.0, 1.0);
    EXPECT_GE(clock.interpolation(), 0.0f);
    EXPECT_LE(clock.interpolation(), 1.0f);
}

TEST(StepClock, ALongPictureSlowsTheGameDownAtTheStatedLimit) {
    StepClock clock;
    EXPECT_NEAR(clock.advance(60.0), 60.0 * StepClock::k_longest_picture_s, 1.0);
    EXPECT_EQ(clock.advance(-1.0), 0u);
}

TEST(StepsAt, TheMomentLiesBetweenTheLastTwoSteps) {
    for (const double time_s : {0.0, 0.001, 1.0 / 60.0, 0.5, 1.0, 7.77, 12345.678}) {
        const StepsAt moment = steps_at(time_s);
        const double shown_s =
            (static_cast<double>(moment.steps) - 1.0 + static_cast<double>(moment.interpolation)) / 60.0;
        // Before the first step there is nothing to lie between. Else: interpolation is a float of a 60th of
        // a second.
        EXPECT_NEAR(moment.steps == 0 ? 0.0 : shown_s, time_s, 1e-6) << time_s;
        EXPECT_GE(moment.interpolation, 0.0f);
        EXPECT_LE(moment.interpolation, 1.0f);
    }
    EXPECT_EQ(steps_at(1.0).steps, 60u);
}

TEST(JsonOutput, StandardOutputGetsOneObject) {
    testing::internal::CaptureStdout();
    print_result("-", "for people\n");
    write_json("-", {{"schema", "test/1"}, {"value_ms", 1.5}});
    const nlohmann::json read = nlohmann::json::parse(testing::internal::GetCapturedStdout());
    EXPECT_EQ(read["schema"], "test/1");
    EXPECT_EQ(read["value_ms"], 1.5);
}

TEST(JsonOutput, NumbersThatJsonCannotHoldBecomeNull) {
    testing::internal::CaptureStdout();
    write_json("-", {{"value", std::numeric_limits<double>::quiet_NaN()}});
    EXPECT_TRUE(nlohmann::json::parse(testing::internal::GetCapturedStdout())["value"].is_null());
}

}  // namespace
}  // namespace rambla::game
