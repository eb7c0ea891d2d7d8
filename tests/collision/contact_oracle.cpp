// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "collision/contact_oracle.h"

#include <cmath>
#include <numbers>

#include "geometry/io/mesh_file.h"
#include "instruments/builtin_tooth.h"
#include "instruments/bur_shape.h"
#include "support/test_data.h"

// Solid angle of a triangle: A. van Oosterom, J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Trans.
// Biomedical Engineering 30(2), 1983.

namespace tactooth::test {
namespace {

std::vector<NamedMesh> loadTeeth() {
    std::vector<NamedMesh> teeth;
    if (const auto folder = realTeethFolder()) {
        for (const std::string name : {"L1", "L3", "L6"}) {
            auto mesh = loadMesh(*folder / "openmandible/whole" / (name + "_whole.stl"));
            if (mesh) teeth.push_back({name, std::move(*mesh)});
        }
        return teeth;
    }
    using enum BuiltinToothKind;
    for (const BuiltinToothKind kind : {UpperCentralIncisor, UpperCanine, LowerFirstMolar}) {
        BuiltinTooth tooth = makeBuiltinTooth(kind);
        teeth.push_back({tooth.name, std::move(tooth.outer)});
    }
    return teeth;
}

/// A file of the real data, its coordinates times `scale`: two models of molars came in units of their own.
struct ToothFile {
    const char* path;
    float scale;
};

/// Every body of the real data that is one tooth; of the teeth that are there in layers alone, the crown.
constexpr ToothFile kToothFiles[] = {
    {"openmandible/whole/L1_whole.stl", 1},    {"openmandible/layered/L2_enamel.stl", 1},
    {"openmandible/whole/L3_whole.stl", 1},    {"openmandible/layered/L4_enamel.stl", 1},
    {"openmandible/layered/L5_enamel.stl", 1}, {"openmandible/whole/L6_whole.stl", 1},
    {"openmandible/layered/L7_enamel.stl", 1}, {"cc0-molar/molar.stl", 10},
    {"chai3d/molar_outer.stl", 0.04F},         {"microct-meshes/tooth_2_outer.stl", 1},
};

std::vector<NamedMesh> loadEveryTooth() {
    std::vector<NamedMesh> teeth;
    using enum BuiltinToothKind;
    for (const BuiltinToothKind kind : {UpperCentralIncisor, UpperCanine, LowerFirstMolar}) {
        BuiltinTooth tooth = makeBuiltinTooth(kind);
        teeth.push_back({tooth.name, std::move(tooth.outer)});
    }
    const auto folder = realTeethFolder();
    if (!folder) return teeth;
    for (const ToothFile& file : kToothFiles) {
        auto mesh = loadMesh(*folder / file.path);
        if (!mesh) continue;
        for (Vec3f& vertex : mesh->vertices) vertex *= file.scale;
        teeth.push_back({std::filesystem::path(file.path).stem().string(), std::move(*mesh)});
    }
    return teeth;
}

std::vector<NamedMesh> loadTools() {
    std::vector<NamedMesh> tools;
    for (const char* number : {"4", "57"}) tools.push_back({number, makeBur(findBur(number).value()).surface});
    if (const auto folder = realTeethFolder()) {
        if (auto mesh = loadMesh(*folder / "tools/bur_tapered.stl")) tools.push_back({"tapered", std::move(*mesh)});
    }
    return tools;
}

std::vector<NamedMesh> loadEveryKindOfTool() {
    std::vector<NamedMesh> tools = oracleTools();
    for (const char* number : {"330", "856-016"}) tools.push_back({number, makeBur(findBur(number).value()).surface});
    return tools;
}

}  // namespace

const std::vector<NamedMesh>& oracleTeeth() {
    static const std::vector<NamedMesh> teeth = loadTeeth();
    return teeth;
}

const std::vector<NamedMesh>& everyTooth() {
    static const std::vector<NamedMesh> teeth = loadEveryTooth();
    return teeth;
}

const std::vector<NamedMesh>& everyKindOfTool() {
    static const std::vector<NamedMesh> tools = loadEveryKindOfTool();
    return tools;
}

const std::vector<NamedMesh>& oracleTools() {
    static const std::vector<NamedMesh> tools = loadTools();
    return tools;
}

std::shared_ptr<const Surface> surfaceOf(TriangleMesh mesh, bool closed) {
    auto surface = std::make_shared<Surface>();
    surface->base = std::make_shared<const SurfacePart>(std::move(mesh));
    surface->closed = closed;
    return surface;
}

std::shared_ptr<const ToolShape> toolOf(TriangleMesh mesh) {
    return std::make_shared<const ToolShape>(std::move(mesh));
}

bool Oracle::encloses(const Pose& toolInTooth) const {
    const Vec3 point = toolInTooth * tool_.corner(0, 0);
    double angle = 0;
    for (std::size_t i = 0; i < tooth_.triangles.size(); ++i) {
        const Vec3 a = tooth_.corner(i, 0) - point;
        const Vec3 b = tooth_.corner(i, 1) - point;
        const Vec3 c = tooth_.corner(i, 2) - point;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        angle += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle > 2 * std::numbers::pi;  // 4 pi inside, 0 outside
}

}  // namespace tactooth::test
