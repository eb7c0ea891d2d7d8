// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cases/assess_pictures.h"

#include <QBuffer>
#include <QImage>
#include <cctype>

#include "app/common/image_view.h"
#include "app/common/inspection.h"
#include "app/common/legends/distance_legend.h"
#include "app/common/scene_builder.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{720, 540};      // px: sharp on paper at 58 mm, and five of them below a megabyte
constexpr double kRange = 0.5;            // mm: of the colours
const Vec3f kPaper(0.82F, 0.85F, 0.88F);  // sRGB: little ink, and darker than what is white on it
constexpr double kMargin = 0.1;           // mm: the grid extends beyond the surface that samples it

/// The crown alone is of interest, and the pictures are small.
OrbitCamera cameraOn(const Preparation& preparation, StandardView view) {
    OrbitCamera camera;
    camera.fit(crownBox(preparation.prepared->tree().box(), 0), static_cast<double>(kSize.width) / kSize.height);
    camera.setView(view, preparation.mesialX);
    return camera;
}

std::string titleOf(std::string_view name) {
    std::string title(name);
    title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    return title;
}

std::string pngBase64(const Image& image) {
    const QImage picture = viewOf(image);
    QByteArray encoded;
    QBuffer buffer(&encoded);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    return encoded.toBase64().toStdString();
}

}  // namespace

Expected<std::vector<ReportPicture>> assessPictures(const Preparation& preparation, double tolerance) {
    auto renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    const Expected<LayeredTooth> tooth = LayeredTooth::make(preparation.original->mesh());
    if (!tooth) return Unexpected{tooth.error()};
    const Box3& box = preparation.prepared->tree().box();
    const Box3 around(box.min().array() - kMargin, box.max().array() + kMargin);
    Inspection inspection;
    inspection.distances = DistanceColourMap{
        std::make_shared<const DistanceGrid>(sampleDistances(*preparation.ideal, around)), {kRange, tolerance}};
    SceneContents contents;
    contents.tooth = std::make_shared<const Surface>(Surface{.base = preparation.prepared});
    std::vector<ReportPicture> pictures;
    for (const auto& [name, view] : kStandardViews) {
        contents.camera = cameraOn(preparation, view).camera();
        Scene scene = makeScene(contents);
        applyInspection(scene, *tooth, inspection);
        scene.background = {Background::Kind::Gradient, kPaper, kPaper};
        Expected<Image> image = renderer->render(scene, kSize);
        if (!image) return Unexpected{image.error()};
        if (pictures.empty()) drawDistanceLegend(*image, inspection.distances->scale);
        pictures.push_back({titleOf(name), pngBase64(*image)});
    }
    return pictures;
}

}  // namespace tactooth
