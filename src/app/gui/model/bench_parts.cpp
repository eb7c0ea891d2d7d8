// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/model/bench_parts.h"

#include "app/common/mouth_scene.h"
#include "app/common/spin_blur.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_catalogue.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"
#include "session/cases/placed_tooth.h"
#include "session/simulation/tooth_cache.h"
#include "session/simulation/tooth_in_mouth.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;           // mm: a twentieth of a small bur's width; the cut itself is finer
constexpr int kShownBurTriangles = 6000;  // blades look round at full zoom

/// `file`: that it came from; empty for one of a case.
Expected<BenchBur> benchBurOf(OwnBur own, const std::filesystem::path& file) {
    Expected<CuttingTool> cutting = makeCuttingTool(own.surface, own.sharpness);
    if (!cutting) return unexpected((file.empty() ? own.name : file.string()) + ": " + cutting.error().message);
    auto shown = std::make_shared<const TriangleMesh>(own.surface);
    auto blurred = std::make_shared<const TriangleMesh>(spinningShape(cutting->envelope));
    const BurEdge edge = own.edge();
    return BenchBur{
        own.name,         {std::make_shared<const ToolShape>(std::move(own.surface)), std::move(*cutting), edge},
        std::move(shown), std::move(blurred),
        own.material,     file};
}

/// `remark`: what its provenance says of it beside its name.
Expected<BenchTooth> builtinBenchTooth(const ToothRequest& request, const std::string& name,
                                       const std::string& remark) {
    const BuiltinTooth made = ToothCache(usualCacheFolder()).make(request);
    Expected<LayeredTooth> layered = layeredTooth(made);
    if (!layered) return Unexpected{layered.error()};
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    return BenchTooth{name,
                      std::make_shared<WorkPiece>(std::move(shared), kVoxel),
                      mesialX(made.fdi),
                      {{"tooth", "built in: " + made.name + remark}}};
}

}  // namespace

Expected<BenchTooth> makeBenchTooth(const BuiltinToothEntry& entry) {
    return builtinBenchTooth(builtinToothRequest(entry.kind), entry.name, "");
}

Expected<BenchTooth> makeBenchTooth(const std::shared_ptr<const Exercise>& exercise) {
    const auto* request = std::get_if<ToothRequest>(&exercise->tooth);
    const bool isSound = request != nullptr && (!request->lesion || request->lesion->width == 0);
    Expected<BenchTooth> tooth = request != nullptr
                                     ? builtinBenchTooth(*request, exercise->name, isSound ? ", sound" : "")
                                     : loadBenchTooth(std::get<ToothSource>(exercise->tooth));
    if (!tooth) return tooth;
    const auto* file = std::get_if<std::filesystem::path>(&exercise->bur);
    Expected<BenchBur> bur =
        file != nullptr ? loadBenchBur(*file) : makeBenchBur(*findBur(std::get<std::string>(exercise->bur)));
    if (!bur) return Unexpected{bur.error()};
    tooth->name = exercise->name;
    tooth->provenance.emplace_back("exercise", exercise->name);
    tooth->bur = std::move(*bur);
    tooth->exercise = exercise;
    return tooth;
}

Expected<BenchTooth> makeBenchTooth(const BenchMouth& mouth) {
    constexpr int kNeighbourTriangles = 20000;
    const MouthRequest request{.triangles = kNeighbourTriangles, .seed = 0, .jaw = JawPose::open, .missing = {}};
    const ToothCache cache(mouth.cached ? usualCacheFolder() : std::filesystem::path());
    const Expected<ToothInMouth> made = toothInMouth(mouth.fdi, Lesion{}, request, cache);
    if (!made) return Unexpected{made.error()};
    Expected<LayeredTooth> layered = layeredTooth(*made);
    if (!layered) return Unexpected{layered.error()};
    BenchTooth tooth{std::to_string(made->tooth.fdi),  // a number needs no translation
                     std::make_shared<WorkPiece>(std::make_shared<const LayeredTooth>(std::move(*layered)), kVoxel),
                     mesialX(made->tooth.fdi),
                     {{"tooth", "built in: " + made->tooth.name + ", in the whole mouth"}}};
    tooth.workBox = tooth.piece->tooth().ownBox();
    tooth.around = shownAround(*made);
    tooth.piece->surroundBy(surroundingsOf(*made));
    return tooth;
}

Expected<BenchTooth> loadBenchTooth(const ToothSource& source, const std::string& workOn) {
    Expected<PlacedWork> work = loadPlacedWork(source, workOn, std::nullopt, kVoxel);
    if (!work) return Unexpected{work.error()};
    ToothPlace& place = work->place;
    BenchTooth tooth{
        std::move(place.name),      std::move(work->piece),      place.mesialX, std::move(work->provenance), place.box,
        std::move(place.materials), std::move(place.teethOfCase)};
    for (const Remark& remark : work->remarks) tooth.provenance.emplace_back("assumed", inWords(remark));
    tooth.remarks = std::move(work->remarks);
    if (place.bur) {
        Expected<BenchBur> bur = benchBurOf(std::move(*place.bur), {});
        if (!bur) return Unexpected{bur.error()};
        tooth.bur = std::move(*bur);
    }
    return tooth;
}

Expected<BenchTooth> makeBenchTooth(const ExaminedScan& scan) {
    Expected<LayeredTooth> layered = LayeredTooth::make(scan.outer, scan.layers);
    if (!layered) return unexpected(scan.name + ": " + layered.error().message + ".");
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    BenchTooth tooth{scan.name, std::make_shared<WorkPiece>(std::move(shared), kVoxel), 1, {{"tooth", scan.name}}};
    for (const Remark& remark : scan.remarks) tooth.provenance.emplace_back("assumed", inWords(remark));
    return tooth;
}

Expected<BenchBur> makeBenchBur(const BurSpec& spec) {
    const Bur felt = makeBur(spec);
    Expected<CuttingTool> cutting = makeCuttingTool(felt.surface, spec.sharpness);
    if (!cutting) return Unexpected{cutting.error()};
    auto blurred = std::make_shared<const TriangleMesh>(spinningShape(cutting->envelope));
    return BenchBur{spec.name,
                    {std::make_shared<const ToolShape>(felt.surface), std::move(*cutting), spec.edge()},
                    std::make_shared<const TriangleMesh>(makeBur(spec, kShownBurTriangles).surface),
                    std::move(blurred),
                    spec.material,
                    {}};
}

Expected<BenchBur> loadBenchBur(const std::filesystem::path& path) {
    Expected<OwnBur> own = readOwnBur(path);
    if (!own) return Unexpected{own.error()};
    return benchBurOf(std::move(*own), path);
}

BenchFurniture makeFurniture() {
    BenchFurniture furniture;
    furniture.turbine = std::make_shared<const TriangleMesh>(makeTurbine());
    furniture.suction = std::make_shared<const TriangleMesh>(makeSuctionTube());
    return furniture;
}

void takeMirror(BenchFurniture& furniture, double diameter) {
    DentalMirror mirror = makeMirror(diameter);
    furniture.mirror = std::make_shared<const TriangleMesh>(std::move(mirror.surface));
    furniture.disc = mirror.disc;
}

}  // namespace tactooth
