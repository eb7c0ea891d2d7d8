// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pictures/render_mouth.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/pictures/render_arguments.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/mouth_scene.h"
#include "geometry/files/file_bytes.h"
#include "geometry/util/degree.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

/// The shown part of a mouth and the side it is seen from.
struct MouthView {
    std::string_view name;
    OrbitCamera::Direction direction;
    ShownJaws jaws = ShownJaws::Both;
};
constexpr std::array<MouthView, 6> kViews = {{{"front", {90 * kDegree, 0}},
                                              {"right", {25 * kDegree, 0}},
                                              {"left", {155 * kDegree, 0}},
                                              {"upper", {90 * kDegree, -90 * kDegree}, ShownJaws::Upper},
                                              {"lower", {90 * kDegree, 90 * kDegree}, ShownJaws::Lower},
                                              {"dentist", {62 * kDegree, 20 * kDegree}}}};

Expected<MouthView> viewOf(const std::string& name) {
    const auto found = std::ranges::find(kViews, name, &MouthView::name);
    if (found != kViews.end()) return *found;
    const auto free = parseView(name);
    if (free && !free->standard) return MouthView{"", free->free};
    return unexpected(msg::kMouthViewUnknown, name);
}

/// The box that the picture has to show: all crowns and some gingiva around them.
Box3 boxOf(const BuiltinMouth& mouth, ShownJaws jaws) {
    Box3 crowns;
    for (const MouthTooth& tooth : mouth.teeth) {
        const bool upper = tooth.tooth.fdi < 30;
        if (jaws == (upper ? ShownJaws::Lower : ShownJaws::Upper)) continue;
        const Pose pose = mouth.poseOf(tooth);
        for (const Vec3f& vertex : tooth.tooth.enamel.vertices) crowns.extend(pose * vertex.cast<double>());
    }
    constexpr double kAround = 5;  // mm
    return crowns.isEmpty() ? Box3(Vec3::Constant(-30), Vec3::Constant(30))
                            : Box3(crowns.min().array() - kAround, crowns.max().array() + kAround);
}

/// Makes the camera that the options describe.
Expected<OrbitCamera> eyeOf(const RenderOptions& options, const MouthView& view, const Box3& box, ImageSize size) {
    OrbitCamera eye;
    eye.fit(box, size.aspect());
    eye.setView(view.direction);
    constexpr double kNearer = 0.75;  // the fit holds for every direction; from one the mouth is smaller
    eye.zoom(kNearer, Vec2(size.width / 2.0, size.height / 2.0), size);
    if (!options.at.empty()) {
        const auto middle = parsePoint(options.at);
        if (!middle) return Unexpected{middle.error()};
        constexpr double kAround = 15;  // mm
        eye.fit(Box3(middle->array() - kAround, middle->array() + kAround), size.aspect());
    }
    if (options.span > 0) {
        const double shown = eye.pixelPitch(size) * size.height;
        eye.zoom(options.span / shown, Vec2(size.width / 2.0, size.height / 2.0), size);
    }
    return eye;
}

/// The pictures of one run.
struct RenderSetup {
    const RenderOptions& options;
    std::vector<ShownBody> bodies;
    std::vector<ShownTissue> softTissues;
    ImageSize size;
    OffscreenRenderer renderer;
};

Expected<void> takePicture(RenderSetup& studio, const OrbitCamera& eye, const std::filesystem::path& file) {
    SceneContents contents;
    contents.around = studio.bodies;
    contents.softTissues = studio.softTissues;
    contents.camera = eye.camera();
    Scene scene = makeScene(contents);
    if (studio.options.noBackground) scene.background.kind = Background::Kind::Transparent;
    const Expected<Image> image = studio.renderer.render(scene, studio.size);
    if (!image) return Unexpected{image.error()};
    if (auto written = writePng(*image, file); !written) return written;
    print("{}: the built-in mouth, {} x {}\n", displayName(file), studio.size.width, studio.size.height);
    return {};
}

}  // namespace

Expected<void> renderMouth(const RenderOptions& options) {
    const auto size = parseSize(options.size);
    if (!size) return Unexpected{size.error()};
    const auto view = viewOf(options.view);
    if (!view) return Unexpected{view.error()};
    if (options.softTissues && options.mouthSpec.jaw != "open") return unexpected(msg::kSoftTissuesOfOpenMouth);
    const auto mouth = mouthFromSpec(options.mouthSpec);
    if (!mouth) return Unexpected{mouth.error()};
    const auto eye = eyeOf(options, *view, boxOf(*mouth, view->jaws), *size);
    if (!eye) return Unexpected{eye.error()};
    auto renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    RenderSetup studio{options, shownMouth(*mouth, view->jaws), {}, *size, std::move(*renderer)};
    if (options.softTissues) studio.softTissues = shownSoftTissues(*mouth);
    if (options.turntable == 0) return takePicture(studio, *eye, options.out);
    for (int i = 0; i < options.turntable; ++i) {
        OrbitCamera turned = *eye;
        turned.setView({view->direction.azimuth + 360 * kDegree * i / options.turntable, view->direction.elevation});
        if (auto done = takePicture(studio, turned, numberedFile(options.out, i)); !done) return done;
    }
    return {};
}

}  // namespace tactooth
