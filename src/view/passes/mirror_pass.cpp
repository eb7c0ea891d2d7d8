// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "view/passes/mirror_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "view/gl/shaders.h"

namespace tactooth {

namespace {

constexpr int kSectors = 128;             ///< of the drawn disc: its rim is then round to 4 um
constexpr double kGlassClearance = 0.01;  ///< mm in front of the plane: the mirror's own glass is not reflected

/// Two perpendicular vectors in the plane of the disc, both as long as the radius; right x up points along the normal.
std::pair<Vec3, Vec3> discAxes(const SceneMirror& mirror) {
    const Vec3 normal = mirror.planeInWorld().normal;
    const Vec3 right = normal.unitOrthogonal();
    return {mirror.radius * right, mirror.radius * normal.cross(right)};
}

}  // namespace

PixelRectangle coveredPixels(const SceneMirror& mirror, const Camera& camera, ImageSize size) {
    if (mirror.planeInWorld().signedDistance(camera.cameraInWorld.position) <= kGlassClearance) return {};
    const auto [right, up] = discAxes(mirror);
    const Vec3 centre = mirror.mirrorInWorld * mirror.centre;
    Eigen::AlignedBox2d box;
    // The 16-gon with these corners encloses the whole disc.
    const double outside = 1 / std::cos(std::numbers::pi / 16);
    for (int i = 0; i < 16; ++i) {
        const double angle = 2 * std::numbers::pi * i / 16;
        const auto pixel = project(camera, size, centre + outside * (std::cos(angle) * right + std::sin(angle) * up));
        if (!pixel) return PixelRectangle::whole(size);
        box.extend(Vec2(pixel->x(), size.height - pixel->y()));
    }
    return {(box.min().array().floor().cwiseMax(0).cwiseMin(1e6)).cast<int>(),
            box.max().array().ceil().cwiseMax(0).cwiseMin(Vec2(size.width, size.height).array()).cast<int>()};
}

PassView reflectedView(const PassView& direct, const Plane& mirror) {
    const Mat4 reflection = reflectionMatrix(mirror);
    PassView view = direct;
    view.worldToView = direct.worldToView * reflection;
    view.eye = (reflection * direct.eye.homogeneous()).head<3>();
    view.mirrored = !direct.mirrored;
    view.clipPlane << mirror.normal, -(mirror.offset + kGlassClearance);
    return view;
}

Expected<MirrorPass> MirrorPass::create() {
    MirrorPass pass;
    auto program = ShaderProgram::create("mirror", "", {shaders::kFrame, shaders::kMirrorVert}, {shaders::kMirrorFrag});
    if (!program) return Unexpected{program.error()};
    pass.program_ = std::move(*program);
    pass.frameBuffer_ = gl::Buffer::make();
    pass.noVertices_ = gl::VertexArray::make();
    return pass;
}

void MirrorPass::draw(const SceneMirror& mirror, const FrameBlock& frame, const RenderTarget& reflection,
                      const PixelRectangle& covered) const {
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frameBuffer_.name());
    const auto extended = [](const Vec3& v) { return Eigen::Vector4f(v.homogeneous().cast<float>()); };
    const auto [right, up] = discAxes(mirror);
    program_.use();
    program_.set("centre", extended(mirror.mirrorInWorld * mirror.centre));
    program_.set("right", extended(right));
    program_.set("up", extended(up));
    program_.set("sectors", kSectors);
    program_.set("reflection", 0);
    program_.set("reflectance", std::pow(mirror.dimmedReflectance(), 1 / 2.2F));
    program_.set("fog", mirror.fog);
    program_.set("drops", mirror.drops);
    Eigen::Vector4i corners;
    corners << covered.low, covered.high.array() - 1;
    program_.set("covered", Eigen::Vector4f(corners.cast<float>()));
    glBindTexture(GL_TEXTURE_2D, reflection.colourTexture());
    glEnable(GL_CULL_FACE);
    // The disc is in the plane of a face of the mirror's mesh and must win the depth test against it.
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-2.0F, -8.0F);
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3 * kSectors);
    glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace tactooth
