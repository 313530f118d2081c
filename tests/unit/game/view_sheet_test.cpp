#include "game/view_sheet.h"

#include <gtest/gtest.h>

namespace rambla::game {
namespace {

using Names = std::vector<std::string>;

Names names_of(const std::vector<std::filesystem::path>& files) {
    return distinct_names(files);
}

TEST(DistinctNames, LeaveOutTheFoldersThatAllFilesShare) {
    EXPECT_EQ(names_of({"a/b/Box/glTF/Box.gltf", "a/b/Box/glTF-Binary/Box.glb"}),
              (Names{"glTF/Box.gltf", "glTF-Binary/Box.glb"}));
    EXPECT_EQ(names_of({"/a/b.glb", "/a/./c.glb"}), (Names{"b.glb", "c.glb"}));
    EXPECT_EQ(names_of({"a/b.glb", "/c.glb"}), (Names{"a/b.glb", "/c.glb"}));
}

TEST(DistinctNames, KeepFileNamesEvenOfOneFileOrTwice) {
    EXPECT_EQ(names_of({"a/b/c.glb"}), Names{"c.glb"});
    EXPECT_EQ(names_of({"a/b.glb", "a/b.glb"}), (Names{"b.glb", "b.glb"}));
    // A folder may bear the name of a file.
    EXPECT_EQ(names_of({"a/b", "a/b/c"}), (Names{"b", "b/c"}));
    EXPECT_EQ(names_of({}), Names{});
}

}  // namespace
}  // namespace rambla::game
