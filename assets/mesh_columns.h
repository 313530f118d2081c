#pragma once

#include "assets/mesh.h"

namespace rambla::assets {

/// Calls `visit` with each column of a mesh that has an entry per vertex, those of its morph targets
/// included; columns that the mesh does not use are empty.
template <class M, class Visit>
void for_each_column(M& mesh, Visit&& visit) {
    visit(mesh.positions);
    visit(mesh.normals);
    visit(mesh.tangents);
    visit(mesh.uv0);
    visit(mesh.uv1);
    visit(mesh.colours);
    visit(mesh.joints);
    visit(mesh.weights);
    for (auto& target : mesh.morphs) {
        visit(target.positions);
        visit(target.normals);
        visit(target.tangents);
    }
}

}  // namespace rambla::assets
