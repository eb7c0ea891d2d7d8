// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/appearance_uniforms.h"

#include <array>

#include "geometry/util/assert.h"
#include "view/scene/scene.h"

namespace tactooth {

void setAppearances(const ShaderProgram& program, const std::vector<Appearance>& appearances) {
    TACTOOTH_ASSERT(!appearances.empty() && appearances.size() <= kMaxAppearances);
    std::array<Eigen::Vector4f, 2 * kMaxAppearances> packed;
    for (std::size_t i = 0; i < appearances.size(); ++i) {
        const Appearance& appearance = appearances[i];
        const Vec3f colour = linearColour(appearance.colour);
        packed[2 * i] = {colour.x(), colour.y(), colour.z(), appearance.roughness};
        packed[2 * i + 1] = {appearance.metalness, appearance.translucency, appearance.wetness, appearance.grain};
    }
    program.setAll("appearances", packed.data(), static_cast<int>(2 * appearances.size()));
}

void setOpacities(const ShaderProgram& program, const std::vector<Appearance>& appearances) {
    std::array<float, kMaxAppearances> packed{};
    for (std::size_t i = 0; i < appearances.size(); ++i) packed[i] = appearances[i].opacity;
    program.setAll("opacities", packed.data(), static_cast<int>(appearances.size()));
}

}  // namespace tactooth
