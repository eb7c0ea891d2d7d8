// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/report/report_pictures.h"

#include <QBuffer>
#include <QImage>
#include <array>
#include <mutex>

#include "app/common/images/image_view.h"
#include "app/common/inspection.h"
#include "app/common/scene_builder.h"
#include "assessment/report/messages.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

constexpr ImageSize kSize{600, 450};      // px: sharp on paper at 58 mm, and six of them below two megabytes
const Vec3f kPaper(0.82F, 0.85F, 0.88F);  // sRGB: little ink, and darker than what is white on it
constexpr double kMargin = 0.1;           // mm: the grid extends beyond the surface that samples it

constexpr double kAspect = static_cast<double>(kSize.width) / kSize.height;

OrbitCamera cameraOn(const std::vector<Vec3>& points, StandardView view, double mesialX, double share) {
    OrbitCamera camera;
    camera.setView(view, mesialX);
    camera.fill(points, share, kAspect);
    return camera;
}

/// The crown alone is of interest, and the pictures are small.
std::vector<Vec3> crownOf(const SurfacePart& tooth) {
    const Box3 crown = crownBox(tooth.tree().box(), 0);
    std::vector<Vec3> points;
    for (const Vec3f& vertex : tooth.mesh().vertices) {
        if (vertex.z() >= crown.min().z()) points.emplace_back(vertex.cast<double>());
    }
    return points;
}

std::vector<Vec3> cutAndIdeal(const CutSurfaces& surfaces) {
    std::vector<Vec3> points;
    for (const TriangleMesh* mesh : {&surfaces.cut.mesh, &surfaces.idealCut.mesh}) {
        for (const Triangle& t : mesh->triangles) points.emplace_back(mesh->vertices[t[0]].cast<double>());
    }
    return points;
}

/// The view that looks into the preparation.
StandardView viewInto(const Preparation& preparation) {
    const DentalDirections to(preparation.axis, preparation.mesialX);
    if (to.hasMesial && to.hasBuccal) return StandardView::Occlusal;
    if (to.hasMesial) return preparation.axis.y() > 0 ? StandardView::Buccal : StandardView::Lingual;
    return preparation.axis.x() * preparation.mesialX > 0 ? StandardView::Mesial : StandardView::Distal;
}

const MessageText& titleOf(StandardView view) {
    static constexpr std::array kTitles = {&msg::kPictureOcclusal, &msg::kPictureBuccal, &msg::kPictureLingual,
                                           &msg::kPictureMesial, &msg::kPictureDistal};
    return *kTitles[static_cast<std::size_t>(view)];
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

Expected<std::vector<ReportPicture>> reportPictures(const Preparation& preparation, const CutSurfaces& surfaces,
                                                    double tolerance, Language language) {
    static std::mutex drawing;  // all threads share one connection to OpenGL's display, and closing it ends it for all
    const std::scoped_lock lock(drawing);
    auto renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    const Expected<LayeredTooth> tooth = LayeredTooth::make(preparation.original->mesh());
    if (!tooth) return Unexpected{tooth.error()};
    const Box3& box = preparation.prepared->tree().box();
    const Box3 around(box.min().array() - kMargin, box.max().array() + kMargin);
    Inspection inspection;
    inspection.distances = DistanceColourMap{
        std::make_shared<const DistanceGrid>(sampleDistances(*preparation.ideal, around)), {kColourRange, tolerance}};
    SceneContents contents;
    contents.tooth = std::make_shared<const Surface>(Surface{.base = preparation.prepared});
    std::vector<ReportPicture> pictures;
    const auto add = [&](const MessageText& title, const OrbitCamera& camera) -> Expected<void> {
        contents.camera = camera.camera();
        Scene scene = makeScene(contents);
        applyInspection(scene, *tooth, inspection);
        scene.background = {Background::Kind::Gradient, kPaper, kPaper};
        Expected<Image> image = renderer->render(scene, kSize);
        if (!image) return Unexpected{image.error()};
        pictures.push_back({std::string(title.in(language)), pngBase64(*image)});
        return {};
    };
    constexpr double kEnlarged = 0.75, kWhole = 0.92;  // of the picture
    const auto enlarged = cameraOn(cutAndIdeal(surfaces), viewInto(preparation), preparation.mesialX, kEnlarged);
    if (auto added = add(msg::kPictureEnlarged, enlarged); !added) return Unexpected{added.error()};
    const std::vector<Vec3> crown = crownOf(*preparation.prepared);
    for (const auto& [name, view] : kStandardViews) {
        const OrbitCamera camera = cameraOn(crown, view, preparation.mesialX, kWhole);
        if (auto added = add(titleOf(view), camera); !added) return Unexpected{added.error()};
    }
    return pictures;
}

}  // namespace tactooth
