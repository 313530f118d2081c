#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "assets/export/image.h"
#include "assets/import/image.h"
#include "game/study/report/page_pictures.h"
#include "game/study/report/picture_files.h"
#include "game/study/report/report.h"
#include "unit/game/study/svg_reader.h"

namespace rambla::game::study {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

/// A picture whose texels all differ from their neighbours.
assets::Image picture(std::uint32_t width, std::uint32_t height, int seed = 0) {
    assets::Image image{.name = {}, .width = width, .height = height, .texels = {}};
    for (std::size_t i = 0; i < std::size_t{width} * height; ++i) {
        for (const std::size_t factor : {37u, 91u, 5u})
            image.texels.push_back(std::byte(static_cast<unsigned char>(i * factor + std::size_t(seed))));
        image.texels.push_back(std::byte{255});
    }
    return image;
}

StudyResult study(std::vector<PictureRow> rows, std::string name = "bloom") {
    StudyResult result;
    result.name = std::move(name);
    result.title = "Bloom";
    result.pictures = std::move(rows);
    return result;
}

/// Each digit by its place, which is another way than the one it was made by.
std::vector<std::byte> from_base64(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<bool> bits;
    for (const char digit : text) {
        if (digit == '=') continue;
        for (int bit = 5; bit >= 0; --bit)
            bits.push_back((digits.find(digit) >> bit & 1u) != 0);
    }
    std::vector<std::byte> bytes(bits.size() / 8);
    for (std::size_t i = 0; i < bytes.size() * 8; ++i)
        bytes[i / 8] |= std::byte(static_cast<unsigned char>((bits[i] ? 1u : 0u) << (7 - i % 8)));
    return bytes;
}

/// The pictures inside of a page, in its order.
std::vector<assets::Image> embedded(const std::string& html) {
    std::vector<assets::Image> images;
    const std::string begin = "src=\"data:image/png;base64,";
    for (std::size_t at = html.find(begin); at != std::string::npos; at = html.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        images.push_back(
            assets::decode_image(from_base64(html.substr(from, html.find('"', from) - from)), "x"));
    }
    return images;
}

void expect_equal(const assets::Image& found, const assets::Image& expected) {
    EXPECT_EQ(found.width, expected.width);
    EXPECT_EQ(found.height, expected.height);
    EXPECT_EQ(found.texels, expected.texels);
}

TEST(StudyPictures, AreInThePageToTheBit) {
    assets::Image clear = picture(5, 3, 9);
    clear.texels[3] = std::byte{0};
    const std::string html = pictures_html(study({{"Row", {{"wide", picture(160, 90)}}},
                                                  {"Dots", {{"1", picture(1, 1, 77)}}},
                                                  {"Clear", {{"a", picture(5, 3)}, {"b", clear}}}}));
    const std::vector<assets::Image> found = embedded(html);
    ASSERT_EQ(found.size(), 4u);
    expect_equal(found[0], picture(160, 90));
    expect_equal(found[1], picture(1, 1, 77));
    expect_equal(found[2], picture(5, 3));
    expect_equal(found[3], clear);
}

TEST(StudyPictures, HaveLabelsAndTextsThatStandForThem) {
    const std::string html = pictures_html(
        study({{"Before & \"after\"", {{"<b>", picture(2, 2)}, {"bloom:radius=2", picture(2, 2)}}},
               {"", {{"", picture(2, 2)}}}}));
    EXPECT_TRUE(is_well_formed(html));
    EXPECT_THAT(html, HasSubstr("<h3>Before &amp; &quot;after&quot;</h3>"));
    EXPECT_THAT(html, HasSubstr("<figcaption>&lt;b&gt;</figcaption>"));
    EXPECT_THAT(html, HasSubstr("alt=\"Before &amp; &quot;after&quot;: &lt;b&gt;\""));
    EXPECT_THAT(html, HasSubstr("alt=\"Before &amp; &quot;after&quot;: bloom:radius=2\""));
    EXPECT_THAT(html, HasSubstr("alt=\"bloom-2-1.png\"")) << "without any name";
    EXPECT_THAT(html, HasSubstr("<a href=\"bloom-1-2.png\">"));
}

TEST(StudyPictures, SmallOnesAreEnlargedByAWholeFactor) {
    const auto html = [](std::uint32_t width, std::uint32_t height) {
        return pictures_html(study({{"Row", {{"a", picture(width, height)}}}}));
    };
    EXPECT_THAT(html(160, 90), HasSubstr("class=\"pixels\" width=\"320\" height=\"180\""));
    EXPECT_THAT(html(96, 54), HasSubstr("class=\"pixels\" width=\"288\" height=\"162\""));
    EXPECT_THAT(html(1, 1), HasSubstr("class=\"pixels\" width=\"16\" height=\"16\""));
    EXPECT_THAT(html(161, 90), HasSubstr("<img width=\"161\" height=\"90\""));
    EXPECT_THAT(html(960, 1), HasSubstr("<img width=\"960\" height=\"1\""));
    EXPECT_THAT(html(320, 1), HasSubstr("class=\"pictures\""));
    EXPECT_THAT(html(321, 1), HasSubstr("class=\"pictures broad\"")) << "columns that grow";
}

TEST(StudyPictures, WhatCannotBeShownIsASentence) {
    assets::Image floats = picture(2, 2);
    floats.format = assets::PixelFormat::rgba32f;
    floats.texels.resize(64);
    assets::Image torn = picture(2, 2);
    torn.texels.pop_back();
    const std::string html = pictures_html(study({{"Row",
                                                   {{"none", {}},
                                                    {"floats", floats},
                                                    {"torn", torn},
                                                    {"broad", picture(961, 1)},
                                                    {"tall", picture(1, 961)},
                                                    {"right", picture(2, 2)},
                                                    {"other <size>", picture(3, 2)}}},
                                                  {"Empty row", {}}}));
    EXPECT_TRUE(is_well_formed(html));
    EXPECT_THAT(html, HasSubstr("“none” is not shown: there is no picture of it."));
    EXPECT_THAT(html, HasSubstr("“floats” is not shown: its channels are no bytes."));
    EXPECT_THAT(html, HasSubstr("“torn” is not shown: it has 15 bytes of texels instead of 16."));
    EXPECT_THAT(html, HasSubstr("“broad” is not shown: it has 961 × 1 pixels, at most 960 × 960 are shown."));
    EXPECT_THAT(html, HasSubstr("“tall” is not shown"));
    EXPECT_THAT(html,
                HasSubstr("“other &lt;size&gt;” is not shown: it has 3 × 2 pixels, and “right” beside it "
                          "2 × 2."));
    EXPECT_THAT(html, HasSubstr("<h3>Empty row</h3>\n<p class=\"small\">There are no pictures.</p>"));
    const std::vector<assets::Image> shown = embedded(html);
    ASSERT_EQ(shown.size(), 1u);
    expect_equal(shown.front(), picture(2, 2));
    EXPECT_EQ(pictures_html(study({})), "");
}

/// A folder of one test's own.
class StudyPictureFiles : public testing::Test {
protected:
    ~StudyPictureFiles() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    void write(const StudyResult& result) { write_report(folder, std::vector{result}, {{"date", "today"}}); }
    [[nodiscard]] std::string page() const {
        std::ifstream in{folder / "index.html", std::ios::binary};
        return {std::istreambuf_iterator<char>{in}, {}};
    }

    fs::path folder =
        fs::temp_directory_path() /
        (std::string{"rambla-pictures-"} + testing::UnitTest::GetInstance()->current_test_info()->name() +
         std::to_string(getpid()));
};

TEST_F(StudyPictureFiles, ASectionOfAnEarlierRunKeepsItsPictures) {
    write(study({{"Row <1>", {{"off", picture(4, 4)}, {"on", picture(4, 4, 1)}}}}));
    expect_equal(assets::read_image(folder / "bloom-1-2.png"), picture(4, 4, 1));
    const std::string before = page();
    write(study({}, "aliasing"));
    const std::vector<assets::Image> found = embedded(page());
    ASSERT_EQ(found.size(), 2u);
    expect_equal(found[0], picture(4, 4));
    expect_equal(found[1], picture(4, 4, 1));
    const auto section = [](const std::string& html) {
        return html.substr(html.find("<section class=\"study\" id=\"bloom\""));
    };
    EXPECT_EQ(section(page()), section(before));
}

TEST_F(StudyPictureFiles, PicturesThatAreNoMoreAreRemovedAndNoOthers) {
    write(study({{"Row", {{"off", picture(4, 4)}}}}, "bloom-1"));
    write(study(
        {{"Row", {{"off", picture(4, 4)}, {"on", picture(4, 4)}}}, {"Further", {{"x", picture(1, 1)}}}}));
    assets::write_text(folder / "bloom-sheet.png", "somebody's own");
    write(study({{"Row", {{"off", picture(4, 4)}, {"torn", {}}}}}));
    EXPECT_TRUE(fs::exists(folder / "bloom-1-1.png"));
    EXPECT_FALSE(fs::exists(folder / "bloom-1-2.png"));
    EXPECT_FALSE(fs::exists(folder / "bloom-2-1.png"));
    EXPECT_TRUE(fs::exists(folder / "bloom-1-1-1.png")) << "of another study";
    EXPECT_TRUE(fs::exists(folder / "bloom-sheet.png"));
}

TEST_F(StudyPictureFiles, FilesThatAreGoneOrBrokenLeaveTheRestOfTheSection) {
    write(study({{"Row",
                  {{"gone", picture(4, 4)},
                   {"broken", picture(4, 4)},
                   {"large", picture(4, 4)},
                   {"right", picture(4, 4)}}}}));
    fs::remove(folder / "bloom-1-1.png");
    assets::write_text(folder / "bloom-1-2.png", "\x89PNG and nothing more");
    assets::write_image(folder / "bloom-1-3.png", picture(961, 1));
    write(study({}, "aliasing"));
    EXPECT_THAT(page(), HasSubstr("“gone” is not shown: there is no picture of it."));
    EXPECT_THAT(page(), HasSubstr("“broken” is not shown: there is no picture of it."));
    EXPECT_THAT(page(), HasSubstr("“large” is not shown"));
    EXPECT_EQ(embedded(page()).size(), 1u);
}

}  // namespace
}  // namespace rambla::game::study
