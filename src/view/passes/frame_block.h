// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "view/gl/gl_objects.h"
#include "view/scene/scene.h"

namespace tactooth {

/// The viewpoint of one pass.
struct PassView {
    Mat4 worldToView = Mat4::Identity();
    Mat4 viewToClip = Mat4::Identity();
    Vec3 eye = Vec3::Zero();  ///< world, mm
    bool mirrored = false;    ///< worldToView contains a reflection, which reverses the orientation of triangles
    Eigen::Vector4d clipPlane = Eigen::Vector4d(0, 0, 0, 1);  ///< world; only points on its positive side are drawn
    Eigen::Vector4d section = Eigen::Vector4d(0, 0, 0, 1);    ///< the same for sectioned objects only

    [[nodiscard]] Mat4 worldToClip() const { return viewToClip * worldToView; }
};

/// The uniform block `Frame` of shaders/frame.glsl, in its std140 layout.
struct FrameBlock {
    Eigen::Matrix4f worldToClip;
    Eigen::Matrix4f clipToWorld;
    Eigen::Matrix4f worldToShadow;
    Eigen::Vector4f eye;
    Eigen::Vector4f clipPlane;
    Eigen::Vector4f section;
    Eigen::Vector4f toKey;
    Eigen::Vector4f keyColour;
    Eigen::Vector4f toFill;
    Eigen::Vector4f fillColour;
    Eigen::Vector4f skyColour;
    Eigen::Vector4f groundColour;
    Eigen::Vector4f backgroundTop;
    Eigen::Vector4f backgroundBottom;
    Eigen::Vector4f imageSize;
    Eigen::Vector4f shadowTexel;
    Eigen::Vector4f sightEnds;
    Eigen::Vector4f sightReach;
};
static_assert(offsetof(FrameBlock, sightReach) == 3 * 64 + 14 * 16);

/// The data that the shaders need to sample the shadow map.
struct ShadowLookup {
    Mat4 worldToShadow = Mat4::Identity();
    double texel = 1;  ///< size of a texel in texture coordinates
    double pitch = 1;  ///< mm per texel
    double error = 0;  ///< mm by which a shadow caster may be displaced
};

/// The LOD tolerance (mm of displacement for each mm of distance from the eye) that corresponds to `pixels`.
[[nodiscard]] double lodToleranceAt(const PassView& view, ImageSize size, double pixels);

/// `lodTolerance`: from lodToleranceAt.
[[nodiscard]] FrameBlock frameBlock(const PassView& view, const Lighting& lighting, const Background& background,
                                    const ShadowLookup& shadow, ImageSize size, double lodTolerance);

/// Adds what must be seen to `frame`, which was made for this view. A line that is not wholly in front of the eye is
/// left out.
void addSight(FrameBlock& frame, const SightLine& sight, const PassView& view, ImageSize size);

}  // namespace tactooth
