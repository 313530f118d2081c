#pragma once

#include <gtest/gtest.h>

#include "render/gl/context.h"

namespace rambla::render {

/// Tests with a GL context of their own in which every GL error is a failure.
class WithGl : public testing::Test {
protected:
    void TearDown() override { EXPECT_NO_THROW(context_.check_errors()); }

    gl::Context context_{WindowContext{}, true};
};

}  // namespace rambla::render
