// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/bench_parts.h"

#include "app/common/spin_blur.h"
#include "geometry/mesh_file.h"
#include "instruments/bur_shape.h"
#include "instruments/suction_tube.h"
#include "instruments/turbine.h"

namespace tactooth {
namespace {

constexpr double kVoxel = 0.05;           // mm: a twentieth of a small bur's width; the cut itself is finer
constexpr int kShownBurTriangles = 6000;  // blades look round at full zoom

}  // namespace

Expected<BenchTooth> makeBenchTooth(const BuiltinToothEntry& entry) {
    const BuiltinTooth tooth = makeBuiltinTooth(entry.kind);
    Expected<LayeredTooth> layered = LayeredTooth::make(tooth.outer, layersOf(tooth));
    if (!layered) return Unexpected{layered.error()};
    auto shared = std::make_shared<const LayeredTooth>(std::move(*layered));
    return BenchTooth{entry.name,
                      std::make_shared<WorkPiece>(std::move(shared), kVoxel),
                      mesialX(tooth.fdi),
                      {{"tooth", "built in: " + tooth.name}}};
}

Expected<BenchTooth> loadBenchTooth(const ToothSource& source) {
    Expected<OpenedTooth> opened = loadTooth(source, std::nullopt, kVoxel);
    if (!opened) return Unexpected{opened.error()};
    return BenchTooth{source.outer.filename().string(), std::move(opened->piece), 1, std::move(opened->provenance)};
}

Expected<BenchBur> makeBenchBur(const BurSpec& spec) {
    const Bur felt = makeBur(spec);
    Expected<CuttingTool> cutting = makeCuttingTool(felt.surface, spec.sharpness);
    if (!cutting) return Unexpected{cutting.error()};
    auto blurred = std::make_shared<const TriangleMesh>(spinningShape(cutting->envelope));
    return BenchBur{spec.name,
                    {std::make_shared<const ToolShape>(felt.surface), std::move(*cutting)},
                    std::make_shared<const TriangleMesh>(makeBur(spec, kShownBurTriangles).surface),
                    std::move(blurred),
                    spec.material,
                    {}};
}

Expected<BenchBur> loadBenchBur(const std::filesystem::path& path) {
    Expected<TriangleMesh> mesh = loadMesh(path);
    if (!mesh) return Unexpected{mesh.error()};
    Expected<CuttingTool> cutting = makeCuttingTool(*mesh);
    if (!cutting) return unexpected(path.string() + ": " + cutting.error().message);
    auto shown = std::make_shared<const TriangleMesh>(*mesh);
    auto blurred = std::make_shared<const TriangleMesh>(spinningShape(cutting->envelope));
    return BenchBur{
        path.filename().string(), {std::make_shared<const ToolShape>(std::move(*mesh)), std::move(*cutting)},
        std::move(shown),         std::move(blurred),
        BurMaterial::carbide,     path};
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
