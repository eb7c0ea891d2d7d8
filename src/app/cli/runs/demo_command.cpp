// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/demo_command.h"

#include <fmt/core.h>

#include <cstdio>

#include "app/cli/runs/demo_pictures.h"
#include "app/cli/runs/demo_summary.h"
#include "app/cli/runs/run_recording.h"
#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/images/plot_image.h"
#include "app/common/mouth_scene.h"
#include "app/common/spin_blur.h"
#include "app/common/tooth_zones.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "geometry/files/folder.h"
#include "geometry/io/stl_writer.h"
#include "geometry/util/messages.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"
#include "instruments/turbine.h"
#include "journal/file/atomic_journal_file.h"
#include "session/cases/bur_by_name.h"
#include "session/cases/loaded_tooth.h"
#include "session/io/material_file.h"
#include "session/io/tick_csv.h"
#include "session/simulation/session_voxel.h"
#include "session/simulation/tooth_cache.h"
#include "session/simulation/tooth_in_mouth.h"
#include "session/simulation/tooth_source.h"
#include "sound/files/wav_file.h"

namespace tactooth {
namespace {

namespace fs = std::filesystem;

constexpr int kPictureBurTriangles = 5000;  // the blades then appear ground
constexpr const char* kRecording = "session.ttsession";
constexpr const char* kDefaultBur = "57";  // straight fissure, 1.0 mm: can leave its cavity along its path of entry

struct DemoInputs {
    std::string toothName;
    std::string burName;
    std::shared_ptr<const LayeredTooth> tooth;
    Box3 box;  // of the tooth that is cut
    std::optional<CustomBur> customBur;
    Surroundings surroundings;
    std::optional<Instrument> instrument;
    DemoProps props;
};

/// The lower first molar in an open mouth.
Expected<ToothInMouth> makeDemoMouth(DemoInputs& cast) {
    const ToothCache cache(defaultCacheFolder());
    Expected<ToothInMouth> made = toothInMouth(46, Lesion{}, {.jaw = JawPose::Open, .missing = {}}, cache);
    if (!made) return made;
    cast.props.around = shownAround(made->around);
    cast.props.softTissues = shownSoftTissues(made->softTissues);
    cast.surroundings = surroundingsOf(*made);
    return made;
}

Expected<void> loadDemoTooth(const DemoOptions& options, const MaterialRegistry& materials, DemoInputs& cast) {
    if (!options.tooth.empty()) {
        ToothSource source{options.tooth, {}, {}, options.materials.empty() ? nullptr : &materials};
        for (const std::string& text : options.layers) {
            auto layer = parseLayer(text, materials);
            if (!layer) return Unexpected{layer.error()};
            source.layers.push_back(std::move(*layer));
        }
        auto placed = loadToothOrCase(source, options.workOn);
        if (!placed) return Unexpected{placed.error()};
        printImportNotes(placed->importNotes);
        ToothPlacement& place = placed->place;
        cast.toothName = place.teethOfCase.empty() ? displayFileName(options.tooth) : place.name;
        cast.tooth = std::move(placed->tooth);
        cast.box = place.box;
        cast.props.mesialX = place.mesialX;
        cast.props.materials = MaterialTable(cast.tooth->materials());
        cast.customBur = std::move(place.bur);
        return {};
    }
    const Expected<ToothInMouth> molar =
        options.mouth ? makeDemoMouth(cast)
                      : Expected<ToothInMouth>({.tooth = makeBuiltinTooth(BuiltinToothKind::LowerFirstMolar)});
    if (!molar) return Unexpected{molar.error()};
    auto tooth = layeredTooth(*molar);
    if (!tooth) return Unexpected{tooth.error()};
    cast.tooth = std::make_shared<const LayeredTooth>(std::move(*tooth));
    cast.box = cast.tooth->ownBox();
    cast.props.zones = toothZones(*cast.tooth, cast.props.materials);
    cast.props.mesialX = mesialX(molar->tooth.fdi);
    cast.toothName = fmt::format("built-in: {} (FDI {})", molar->tooth.name, molar->tooth.fdi);
    return {};
}

Expected<void> loadDemoBur(const DemoOptions& options, DemoInputs& cast) {
    TriangleMesh mesh;
    double sharpness = 1;
    const std::optional<BurSpec> chosen = findBur(options.bur.native());
    if (chosen) {
        cast.customBur.reset();  // not that of the case
    } else if (!options.bur.empty()) {
        auto own = findOrReadBur(options.bur);
        if (!own) return Unexpected{own.error()};
        cast.customBur = std::move(*own);
    }
    if (cast.customBur) {
        mesh = cast.customBur->surface;
        sharpness = cast.customBur->sharpness;
        cast.burName = cast.customBur->name;
        cast.props.tool.bur = std::make_shared<const TriangleMesh>(mesh);
        cast.props.tool.material = cast.customBur->material;
        cast.props.tool.edge = cast.customBur->edge();
    } else {
        const BurSpec spec = chosen ? *chosen : findBur(kDefaultBur).value();
        mesh = makeBur(spec).surface;
        sharpness = spec.sharpness;
        cast.burName = fmt::format("built-in: {} (US No. {})", spec.name, spec.number);
        cast.props.tool.bur = std::make_shared<const TriangleMesh>(makeBur(spec, kPictureBurTriangles).surface);
        cast.props.tool.turbine = std::make_shared<const TriangleMesh>(makeTurbine());
        cast.props.tool.material = spec.material;
        cast.props.tool.edge = spec.edge();
    }
    auto cutting = makeCuttingTool(mesh, sharpness);
    if (!cutting) return unexpected(msg::kNamedSentence, cast.burName, cutting.error());
    cast.props.tool.blurred = std::make_shared<const TriangleMesh>(spinEnvelopeMesh(cutting->envelope));
    cast.instrument =
        Instrument{std::make_shared<const ToolShape>(std::move(mesh)), std::move(*cutting), cast.props.tool.edge};
    return {};
}

void makeDemoMirror(DemoInputs& cast) {
    DentalMirror mirror = makeMirror();
    ShownMirror shown;
    shown.disc = mirror.disc;
    shown.mesh = std::make_shared<const TriangleMesh>(std::move(mirror.surface));
    cast.props.mirror = std::move(shown);
}

Expected<void> writeTicks(const fs::path& path, const std::vector<Tick>& ticks) {
    auto file = TickCsv::create(path);
    if (!file) return Unexpected{file.error()};
    for (const Tick& tick : ticks) file->write(tick.time, tick);
    return file->commit();
}

/// Writes every result except the picture of the touch, which is made before the tooth is cut.
Expected<void> writeResults(const fs::path& folder, const Demonstration& played, const CutModel& piece,
                            const DemoInputs& cast, double seconds) {
    const Tick& last = played.ticks.back();
    if (const auto& work = played.work) {
        const DemoMoment moment{work->surface, played.ticks[work->tick], work->flying};
        if (auto done = writeDemoPicture(folder / "spray.png", DemoView::AtWork, moment, cast.props); !done)
            return done;
    }
    const DemoMoment end{piece.surface(), last};
    if (auto done = writeDemoPicture(folder / "cut.png", DemoView::Cut, end, cast.props); !done) return done;
    if (auto done = writeForcePlot(folder / "forces.png", played.ticks); !done) return done;
    auto wav = WavWriter::create(folder / "session.wav", framesOf(seconds));
    if (!wav) return Unexpected{wav.error()};
    const auto toFile = [&](std::span<const float> stereo) { wav->write(stereo); };
    if (auto done = renderInChunks(played.sound, seconds, {}, toFile); !done) return done;
    if (auto done = wav->commit(); !done) return done;
    if (auto done = writeTicks(folder / "forces.csv", played.ticks); !done) return done;
    if (auto done = writeStl(piece.exported().mesh, folder / "cut.stl"); !done) return done;
    return writeFile(folder / "summary.json", demoSummary(played, piece, cast.toothName, cast.burName));
}

/// Opens the files before the work starts, so that an obstacle to a result is reported at once.
Expected<void> openFiles(const DemoOptions& options, FileTransaction& files) {
    for (const auto& input : {options.tooth, options.bur, options.materials}) files.reads(input);
    for (const std::string& layer : options.layers) files.reads(layer.substr(layer.find('=') + 1));
    if (auto made = files.makeFolder(options.out); !made) return made;
    for (const char* name : {"touch.png", "spray.png", "cut.png", "forces.png", "session.wav", "forces.csv", "cut.stl",
                             "summary.json", kRecording}) {
        if (auto opened = files.open(options.out / name); !opened) return opened;
    }
    return {};
}

}  // namespace

int runDemo(const DemoOptions& options) {
    FileTransaction files;
    if (const auto done = openFiles(options, files); !done) return reportError(done.error());
    RunRecording recording;
    if (const auto opened = recording.open(options.record, options.seal, &files); !opened)
        return reportError(opened.error());
    DemoInputs cast;
    const auto materials = materialsFrom(options.materials);
    if (!materials) return reportError(materials.error());
    cast.props.materials = MaterialTable(**materials);
    if (const auto done = loadDemoTooth(options, **materials, cast); !done) return reportError(done.error());
    if (const auto done = loadDemoBur(options, cast); !done) return reportError(done.error());
    makeDemoMirror(cast);
    cast.props.box = cast.box;

    print("tooth: {}\nbur:   {}\n", cast.toothName, cast.burName);
    const auto model = std::make_shared<CutModel>(cast.tooth, kSessionVoxel);
    CutModel& piece = *model;
    piece.surroundBy(cast.surroundings);
    if (const auto begun = recording.begin(piece, cast.toothName); !begun) return reportError(begun.error());
    auto file = AtomicFile::create(options.out / kRecording);
    if (!file) return reportError(file.error());
    auto own = SessionRecorder::start(std::make_unique<AtomicJournalFile>(*file), displayName(options.out / kRecording),
                                      piece, cast.toothName, recording.seal());
    if (!own) return reportError(own.error());
    const auto sink = [&](const SessionEvent& event) {
        (*own)->append(event);
        if (recording.recorder() != nullptr) recording.recorder()->append(event);
    };
    const std::shared_ptr<const Surface> uncut = piece.surface();
    int reported = 0;
    const auto progress = [&](double part) {
        const int tenths = static_cast<int>(10 * part);
        if (tenths <= reported) return;
        reported = tenths;
        print("playing {:.0f} s of touching and cutting: {} %\n", options.seconds, 10 * tenths);
        std::fflush(stdout);
    };
    HapticSettings settings;
    settings.materials = cast.props.materials;
    const Quat grip = uprightGrip(cast.props.mesialX, 0);
    const Demonstration played = playDemonstration(model, cast.box, *cast.instrument, settings, grip, options.seconds,
                                                   progress, sink, recording.stop());
    const std::uint64_t hash = piece.hash();
    if (const auto closed = recording.close(hash); !closed) return reportError(closed.error());
    if (recording.stop().stop_requested()) return kExitOk;  // the signal ends the program
    if (const auto closed = (*own)->close(hash); !closed) return reportError(closed.error());
    if (const auto done = file->commit(); !done) return reportError(done.error());
    print("drawing, plotting, rendering the sound\n");
    const DemoMoment touch{uncut, played.ticks[played.touchTick]};
    if (const auto done = writeDemoPicture(options.out / "touch.png", DemoView::Touch, touch, cast.props); !done)
        return reportError(done.error());
    if (const auto done = writeResults(options.out, played, piece, cast, options.seconds); !done)
        return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("removed {:.3f} mm^3 in {} surface updates\n", total(piece.removed()), played.surfaceUpdates);
    print(
        "touch.png, {}cut.png, forces.png, session.wav, forces.csv, cut.stl, session.ttsession and summary.json are in "
        "{}\n",
        played.work ? "spray.png, " : "", displayName(options.out));
    return kExitOk;
}

}  // namespace tactooth
