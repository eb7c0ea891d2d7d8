// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pictures/render_command.h"

#include "app/cli/pictures/render_arguments.h"
#include "app/cli/pictures/render_mouth.h"
#include "app/cli/terminal/messages.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/inspection.h"
#include "app/common/legends/distance_legend.h"
#include "app/common/legends/ghost_legend.h"
#include "app/common/scene_builder.h"
#include "app/common/tooth_zones.h"
#include "app/common/view_marks.h"
#include "assessment/ideal_shape.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/util/degree.h"
#include "geometry/util/number_text.h"
#include "instruments/mirror.h"
#include "session/io/material_file.h"
#include "session/model/session_tooth.h"
#include "view/render/offscreen.h"

namespace tactooth {
namespace {

constexpr double kEyesPerFocus = 1.0 / 30;  // eye separation as a share of the focus distance: easy to fuse

Expected<SessionTooth> toothOf(const RenderOptions& options, const MaterialRegistry& materials) {
    if (options.tooth.empty()) return makeSessionTooth(kBuiltinTeeth.front());
    ToothSource source{.outer = options.tooth, .layers = {}};
    if (!options.materials.empty()) source.materials = &materials;
    for (const std::string& text : options.layers) {
        Expected<ToothSource::Layer> layer = parseLayer(text, materials);
        if (!layer) return Unexpected{layer.error()};
        source.layers.push_back(std::move(*layer));
    }
    return loadSessionTooth(source, options.workOn);
}

Expected<DistanceColourMap> distancesFor(const RenderOptions& options, const Box3& box) {
    if (options.tolerance >= options.range) {
        return unexpected(msg::kToleranceBeyondRange, numberText(options.tolerance), numberText(options.range));
    }
    auto mesh = loadIdealShape(options.target);
    if (!mesh) return Unexpected{mesh.error()};
    const SurfacePart target(std::move(*mesh));
    constexpr double kMargin = 0.1;  // mm: the grid extends beyond the surface that samples it
    const Box3 around(box.min().array() - kMargin, box.max().array() + kMargin);
    return DistanceColourMap{std::make_shared<const DistanceGrid>(sampleDistances(target, around)),
                             {options.range, options.tolerance}};
}

Expected<std::shared_ptr<CavityGhost>> ghostFor(const RenderOptions& options, const SurfacePart& uncut) {
    const auto mesh = loadIdealShape(options.target);
    if (!mesh) return Unexpected{mesh.error()};
    auto ghost = std::make_shared<CavityGhost>(*mesh, uncut);
    if (ghost->empty()) {
        return unexpected(msg::kTargetLeavesNoGhost, displayName(options.target));
    }
    return ghost;
}

Expected<Inspection> inspectionOf(const RenderOptions& options, const SessionTooth& tooth) {
    Inspection inspection;
    if (!options.clip.empty()) {
        const auto clip = parseClip(options.clip);
        if (!clip) return Unexpected{clip.error()};
        inspection.section = sectionPlane(clip->side, tooth.mesialX, tooth.box(), clip->fromMiddle);
    }
    for (const std::string& text : options.transparent) {
        const auto layer = parseOpacity(text, tooth.piece->tooth().materials());
        if (!layer) return Unexpected{layer.error()};
        inspection.opacity[static_cast<std::size_t>(layer->material)] = layer->opacity;
    }
    if (options.ghost) {
        auto ghost = ghostFor(options, *tooth.piece->tooth().ownOuter());
        if (!ghost) return Unexpected{ghost.error()};
        inspection.ghost = std::move(*ghost);
    } else if (!options.target.empty()) {
        auto distances = distancesFor(options, tooth.box());
        if (!distances) return Unexpected{distances.error()};
        inspection.distances = std::move(*distances);
    }
    return inspection;
}

/// Makes the camera that the options describe.
Expected<OrbitCamera> eyeOf(const RenderOptions& options, const SessionTooth& tooth, ImageSize size) {
    const auto direction = parseView(options.view);
    if (!direction) return Unexpected{direction.error()};
    OrbitCamera camera;
    // A case is shown whole, unless the options name one of its teeth.
    camera.fit(options.workOn.empty() ? tooth.piece->tooth().outer()->tree().box() : tooth.box(), size.aspect());
    if (direction->standard) {
        camera.setView(*direction->standard, tooth.mesialX);
    } else {
        camera.setView(tooth.mesialX < 0 ? mirroredInX(direction->free) : direction->free);
    }
    if (!options.at.empty()) {
        const auto middle = parsePoint(options.at);
        if (!middle) return Unexpected{middle.error()};
        camera.fit(Box3(middle->array() - 5, middle->array() + 5), size.aspect());
    }
    if (options.span > 0) {
        const double shown = camera.pixelPitch(size) * size.height;
        camera.zoom(options.span / shown, Vec2(size.width / 2.0, size.height / 2.0), size);
    }
    return camera;
}

Stereo::Mode stereoOf(const std::string& name) {
    if (name == "side-by-side") return Stereo::Mode::SideBySide;
    return name == "anaglyph" ? Stereo::Mode::Anaglyph : Stereo::Mode::Off;
}

/// Everything that stays the same in all pictures of one run.
struct RenderSetup {
    const RenderOptions& options;
    SessionTooth tooth;
    MaterialTable materials;
    Inspection inspection;
    std::optional<DentalMirror> mirror;
    ImageSize size;
    OffscreenRenderer renderer;
};

Scene sceneFor(const RenderSetup& studio, const OrbitCamera& eye) {
    SceneContents contents;
    contents.tooth = studio.tooth.piece->surface();
    contents.materials = studio.materials;
    contents.zones = toothZones(studio.tooth.piece->tooth(), studio.materials);
    contents.camera = eye.camera();
    if (studio.mirror) {
        const Vec3 toEye = (contents.camera.cameraInWorld.position - studio.tooth.box().center()).normalized();
        contents.mirror = ShownMirror{std::make_shared<const TriangleMesh>(studio.mirror->surface), studio.mirror->disc,
                                      parkedMirror(studio.tooth.box(), toEye, studio.tooth.mesialX)};
    }
    Scene scene = makeScene(contents);
    applyInspection(scene, studio.tooth.piece->tooth(), studio.inspection);
    if (scene.mirror) {
        scene.mirror->fog = static_cast<float>(studio.options.fog);
        scene.mirror->drops = static_cast<float>(studio.options.drops);
    }
    if (studio.options.noBackground) scene.background.kind = Background::Kind::Transparent;
    scene.stereo = {stereoOf(studio.options.stereo), eye.distance(), kEyesPerFocus * eye.distance()};
    if (const StandardView* second = standardView(studio.options.second)) {
        scene.second = SecondView{crownCamera(*second, studio.tooth.mesialX, studio.tooth.box())};
    }
    return scene;
}

Expected<void> takePicture(RenderSetup& studio, const OrbitCamera& eye, const std::filesystem::path& file) {
    Expected<Image> image = studio.renderer.render(sceneFor(studio, eye), studio.size);
    if (!image) return Unexpected{image.error()};
    if (studio.inspection.distances) drawDistanceLegend(*image, studio.inspection.distances->scale);
    if (studio.inspection.ghost) drawGhostLegend(*image);
    if (studio.options.marks) {
        drawViewMarks(*image, eye.camera(), studio.tooth.mesialX, 1 / eye.pixelPitch(studio.size));
    }
    if (auto written = writePng(*image, file); !written) return written;
    print("{}: {}, {} x {}\n", displayName(file), studio.tooth.name, studio.size.width, studio.size.height);
    return {};
}

Expected<void> takeTurn(RenderSetup& studio, OrbitCamera eye) {
    const int count = studio.options.turntable;
    for (int i = 0; i < count; ++i) {
        OrbitCamera turned = eye;
        turned.setView({eye.direction().azimuth + 360 * kDegree * i / count, eye.direction().elevation});
        auto done = takePicture(studio, turned, numberedFile(studio.options.out, i));
        if (!done) return done;
    }
    return {};
}

Expected<void> render(const RenderOptions& options) {
    const auto size = parseSize(options.size);
    if (!size) return Unexpected{size.error()};
    const auto given = materialsFrom(options.materials);
    if (!given) return Unexpected{given.error()};
    auto tooth = toothOf(options, **given);
    if (!tooth) return Unexpected{tooth.error()};
    printImportNotes(tooth->importNotes);
    // A built-in tooth has the built-in materials. All registries begin with these.
    const MaterialTable materials(options.tooth.empty() ? **given : tooth->piece->tooth().materials());
    auto inspection = inspectionOf(options, *tooth);
    if (!inspection) return Unexpected{inspection.error()};
    const auto eye = eyeOf(options, *tooth, *size);
    if (!eye) return Unexpected{eye.error()};
    auto renderer = OffscreenRenderer::create();
    if (!renderer) return Unexpected{renderer.error()};
    RenderSetup studio{options, std::move(*tooth), materials, std::move(*inspection), {}, *size, std::move(*renderer)};
    if (options.mirror) studio.mirror = makeMirror(*options.mirror);
    return options.turntable > 0 ? takeTurn(studio, *eye) : takePicture(studio, *eye, options.out);
}

/// Opens the files before the work starts, so that an obstacle to a picture is reported at once.
Expected<void> openFiles(const RenderOptions& options, FileTransaction& files) {
    for (const auto& input : {options.tooth, options.materials, options.target}) files.reads(input);
    for (const std::string& layer : options.layers) files.reads(layer.substr(layer.find('=') + 1));
    if (options.turntable == 0) return files.open(options.out);
    for (int i = 0; i < options.turntable; ++i) {  // too many to keep all of them open
        if (auto free = files.checkFree(numberedFile(options.out, i)); !free) return free;
    }
    const auto first = AtomicFile::create(numberedFile(options.out, 0));
    if (!first) return Unexpected{first.error()};
    return {};
}

}  // namespace

int runRender(const RenderOptions& options) {
    FileTransaction files;
    if (const auto opened = openFiles(options, files); !opened) return reportError(opened.error());
    if (const auto done = options.mouth ? renderMouth(options) : render(options); !done)
        return reportError(done.error());
    const auto named = files.commit();
    return named ? kExitOk : reportError(named.error());
}

}  // namespace tactooth
