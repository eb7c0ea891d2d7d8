// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/look_uniforms.h"

#include <array>
#include <cassert>

#include "view/scene/scene.h"

namespace tactooth {

void setLooks(const ShaderProgram& program, const std::vector<Look>& looks) {
    assert(!looks.empty() && looks.size() <= kMaxLooks);
    std::array<Eigen::Vector4f, 2 * kMaxLooks> packed;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        const Look& look = looks[i];
        const Vec3f colour = linearColour(look.colour);
        packed[2 * i] = {colour.x(), colour.y(), colour.z(), look.roughness};
        packed[2 * i + 1] = {look.metalness, look.translucency, look.wetness, look.grain};
    }
    program.setAll("looks", packed.data(), static_cast<int>(2 * looks.size()));
}

void setOpacities(const ShaderProgram& program, const std::vector<Look>& looks) {
    std::array<float, kMaxLooks> packed{};
    for (std::size_t i = 0; i < looks.size(); ++i) packed[i] = looks[i].opacity;
    program.setAll("opacities", packed.data(), static_cast<int>(looks.size()));
}

}  // namespace tactooth
