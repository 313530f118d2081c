#include "game/study/report/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <span>

namespace rambla::game::study {
namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

TEST(StudyText, EscapesMarkupAndQuotes) {
    EXPECT_EQ(escaped("<a href=\"x\">&'</a>"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;");
    EXPECT_EQ(escaped("\xC2\xB5s \xE2\x82\xAC \xF0\x9F\x98\x80"), "\xC2\xB5s \xE2\x82\xAC \xF0\x9F\x98\x80");
}

TEST(StudyText, ReplacesWhatNoXmlMayHold) {
    const std::string replacement = "\xEF\xBF\xBD";
    EXPECT_EQ(escaped("a\x01z"), "a" + replacement + "z");
    EXPECT_EQ(escaped("a\xFFz"), "a" + replacement + "z");
    EXPECT_EQ(escaped("\xE2\x82"), replacement + replacement);                    // cut short
    EXPECT_EQ(escaped("\xC0\xBC"), replacement + replacement);                    // '<' in two bytes
    EXPECT_EQ(escaped("\xED\xA0\x80"), replacement + replacement + replacement);  // half of a surrogate pair
    EXPECT_EQ(escaped(std::string_view{"\0", 1}), replacement);
}

TEST(StudyText, ExactNumbersReadBack) {
    for (const double value : {0.1, 1.0 / 3.0, 1e-300, -12345.678, 1e22, 5e-324})
        EXPECT_EQ(std::strtod(exact(value).c_str(), nullptr), value);
    EXPECT_EQ(exact(k_infinite), "inf");
    EXPECT_EQ(exact(-k_infinite), "-inf");
    EXPECT_EQ(exact(-k_nan), "nan");
}

TEST(StudyText, BriefNumbersHaveThreeDigits) {
    EXPECT_EQ(brief(0.0), "0");
    EXPECT_EQ(brief(64.0), "64");
    EXPECT_EQ(brief(12345.0), "12345");
    EXPECT_EQ(brief(12.345), "12.3");
    EXPECT_EQ(brief(9.999), "10.0");
    EXPECT_EQ(brief(-0.012345), "−0.0123");
    EXPECT_EQ(brief(1.234e-7), "1.23·10⁻⁷");
    EXPECT_EQ(brief(6.5e12), "6.50·10¹²");
    EXPECT_EQ(brief(-k_infinite), "−∞");
    EXPECT_EQ(brief(k_nan), "not a number");
}

TEST(StudyText, WrapsAtSpacesAndInsideLongWords) {
    using testing::ElementsAre;
    EXPECT_THAT(wrapped("one two three", 8, 5), ElementsAre("one two", "three"));
    EXPECT_THAT(wrapped("abcdefghij k", 4, 5), ElementsAre("abcd", "efgh", "ij k"));
    EXPECT_THAT(wrapped("one two three four", 8, 2), ElementsAre("one two", "three…"));
    EXPECT_THAT(wrapped("one two three four five", 10, 2), ElementsAre("one two", "three fou…"));
    EXPECT_THAT(wrapped("µµµ µµµ", 3, 2), ElementsAre("µµµ", "µµµ"));
    EXPECT_THAT(wrapped("", 10, 2), ElementsAre());
}

TEST(StudyText, BytesAsCharacters) {
    const auto of = [](std::string_view text) {
        return base64(std::as_bytes(std::span{text}));
    };
    // RFC 4648, section 10.
    EXPECT_EQ(of(""), "");
    EXPECT_EQ(of("f"), "Zg==");
    EXPECT_EQ(of("fo"), "Zm8=");
    EXPECT_EQ(of("foo"), "Zm9v");
    EXPECT_EQ(of("foob"), "Zm9vYg==");
    EXPECT_EQ(of("\xFB\xFF\xBF"), "+/+/");
}

}  // namespace
}  // namespace rambla::game::study
