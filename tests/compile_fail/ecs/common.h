#pragma once

#include "ecs/commands.h"
#include "ecs/query.h"
#include "ecs/world.h"

using namespace rambla::ecs;

struct Position {
    float x = 0.0f, y = 0.0f, z = 0.0f;
};
struct Health {
    int points = 0;
};
struct Frozen {};
