#pragma once

#include "assets/generate/builder.h"
#include "assets/generate/draws.h"

namespace rambla::assets::generate {

/// A plane tree of about seven metres: trunk, boughs and a crown of leaf cards whose normals point away from
/// the crown's middle, so that it is shaded as one soft body. Foot at the origin.
void build_tree(Builder& builder, Draws& draws);

}  // namespace rambla::assets::generate
