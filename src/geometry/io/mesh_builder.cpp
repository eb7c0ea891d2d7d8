// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/io/mesh_builder.h"

#include <utility>

#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"

namespace tactooth {

void MeshBuilder::endStrip() {
    for (std::size_t i = 2; i < corners_.size(); ++i) {
        const bool isTurned = i % 2 != 0;
        const Triangle triangle = {corners_[isTurned ? i - 1 : i - 2], corners_[isTurned ? i - 2 : i - 1], corners_[i]};
        const bool isDegenerateStripCorner =
            triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
        if (!isDegenerateStripCorner) mesh_.triangles.push_back(triangle);
    }
    corners_.clear();
}

TriangleMesh MeshBuilder::take() {
    mesh_.vertices = welder_.takeVertices();
    return std::move(mesh_);
}

Expected<ReadMesh> readWithOffset(const std::string& name, const std::function<ReadAttempt(const Vec3& offset)>& read) {
    ReadAttempt first = read(Vec3::Zero());
    // Also after an error: the outline of a face may cross itself only because its corners were rounded.
    const std::optional<Vec3> offset = first.rounding.betterOffset();
    if (!offset) return std::move(first.mesh);
    ReadAttempt again = read(*offset);
    if (!again.mesh) return std::move(again.mesh);
    again.mesh->offset = *offset;
    again.mesh->importNotes.push_back(
        {ImportNoteTopic::File,
         {msg::kNoteMoved, name, numberText(offset->x()), numberText(offset->y()), numberText(offset->z())}});
    return std::move(again.mesh);
}

}  // namespace tactooth
