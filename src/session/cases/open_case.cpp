// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/cases/open_case.h"

#include <algorithm>

#include "collision/bvh/closest_point.h"
#include "collision/solid/solid_file.h"
#include "geometry/io/mesh_bytes.h"
#include "geometry/util/byte_text.h"
#include "geometry/util/messages.h"
#include "instruments/builtin_tooth.h"
#include "session/cases/messages.h"
#include "session/io/material_file.h"
#include "session/io/unicode_text.h"

namespace tactooth {
namespace {

bool isSame(const Pose& pose) { return pose.position.isZero(0) && pose.rotation.vec().isZero(0); }

/// The solid of a file, transformed to another frame. With the identity a solid without defects keeps every bit.
Expected<TriangleMesh> readSurface(const CaseStore& store, const std::string& entry, const Pose& pose,
                                   std::vector<ImportNote>& importNotes) {
    const auto bytes = store.read(entry);
    if (!bytes) return Unexpected{bytes.error()};
    auto mesh = parseMesh(*bytes, store.shown(entry));
    if (mesh)
        mesh = solidFrom(std::move(*mesh), store.shown(entry), msg::kTheSurface, {.dropsSpecks = false}, &importNotes);
    if (!mesh || isSame(pose)) return mesh;
    return transformed(*mesh, pose);
}

/// Gathers the bodies of a case into one tooth.
class Assembly {
public:
    Assembly(const CaseStore& store, const CaseDescription& description, const CaseTooth& chosen)
        : store_(store), description_(description), chosen_(chosen), caseInTooth_(chosen.toothInCase.inverse()) {}

    /// Notes on repairs of the surfaces.
    [[nodiscard]] std::vector<ImportNote> takeImportNotes() { return std::move(importNotes_); }

    Expected<std::shared_ptr<const LayeredTooth>> assemble() {
        if (chosen_.fdi != 0) toothContext_.mesialX = mesialX(chosen_.fdi);
        // The chosen tooth first, so that its triangles keep their indices.
        if (auto done = add(chosen_); !done) return Unexpected{done.error()};
        for (const CaseTooth& tooth : description_.teeth) {
            if (&tooth == &chosen_) continue;
            if (auto done = add(tooth); !done) return Unexpected{done.error()};
        }
        for (const CaseSurrounding& body : description_.around) {
            auto mesh = readSurface(store_, body.surface, caseInTooth_ * body.bodyInCase, importNotes_);
            if (!mesh) return Unexpected{mesh.error()};
            append(outer_, *mesh);
            layers_.push_back({body.name, body.material, std::move(*mesh)});
        }
        const bool isPlain = description_.teeth.size() == 1 && description_.around.empty() && chosen_.layers.empty();
        if (isPlain) layers_.clear();
        auto tooth = LayeredTooth::make(std::move(outer_), std::move(layers_), chosen_.material, toothContext_,
                                        *description_.registry);
        if (!tooth) return unexpected(msg::kNamed, store_.shown(std::string(kCaseText)), tooth.error());
        return std::shared_ptr<const LayeredTooth>(std::make_shared<const LayeredTooth>(std::move(*tooth)));
    }

private:
    Expected<void> add(const CaseTooth& tooth) {
        const bool isChosen = &tooth == &chosen_;
        const Pose pose = isChosen ? Pose() : caseInTooth_ * tooth.toothInCase;
        const std::string prefix = isChosen ? "" : tooth.name + " ";
        auto outer = readSurface(store_, tooth.outer, pose, importNotes_);
        if (!outer) return Unexpected{outer.error()};
        if (isChosen) toothContext_.firstAdjacent = static_cast<std::uint32_t>(outer->triangles.size());
        for (const auto& [id, file] : tooth.layers) {
            auto mesh =
                file == tooth.outer ? Expected<TriangleMesh>(*outer) : readSurface(store_, file, pose, importNotes_);
            if (!mesh) return Unexpected{mesh.error()};
            layers_.push_back({prefix + description_.registry->nameOf(id), id, std::move(*mesh)});
        }
        if (tooth.layers.empty()) {
            layers_.push_back({prefix + description_.registry->nameOf(tooth.material), tooth.material, *outer});
        }
        append(outer_, *outer);
        return {};
    }

    const CaseStore& store_;
    const CaseDescription& description_;
    const CaseTooth& chosen_;
    Pose caseInTooth_;
    TriangleMesh outer_;
    std::vector<LayerMesh> layers_;
    ToothContext toothContext_;
    std::vector<ImportNote> importNotes_;
};

Expected<const CaseTooth*> findTooth(const CaseDescription& description, const std::string& wanted,
                                     const std::string& where) {
    if (wanted.empty()) return &description.teeth.front();
    std::string names;
    for (const CaseTooth& tooth : description.teeth) {
        if (composed(tooth.name) == composed(wanted) || (tooth.fdi != 0 && std::to_string(tooth.fdi) == wanted))
            return &tooth;
        names.append(names.empty() ? "" : ", ").append(tooth.name);
    }
    return unexpected(msg::kCaseToothUnknown, where, wanted, names);
}

Expected<void> readExtras(const CaseStore& store, OpenedCase& opened) {
    for (const std::string& file : opened.description.burs) {
        const auto bytes = store.read(file);
        if (!bytes) return Unexpected{bytes.error()};
        const std::string folder = file.substr(0, file.rfind('/') + 1);
        auto bur = parseCustomBur(asText(*bytes), store.shown(file),
                                  [&](const std::string& beside) { return store.read(folder + beside); });
        if (!bur) return Unexpected{bur.error()};
        if (!opened.bur) opened.bur = std::move(*bur);
    }
    return {};
}

/// Greatest depth of a vertex of `a` within `b`, mm; 0 if none lies inside.
double deepestIn(const SurfacePart& b, const TriangleMesh& a) {
    double deepest = 0;
    for (const Vec3f& vertex : a.vertices) {
        const Vec3 point = vertex.cast<double>();
        if (b.tree().box().contains(point)) deepest = std::max(deepest, -signedDistance(b, point));
    }
    return deepest;
}

}  // namespace

Expected<CaseDescription> readCaseDescription(const CaseStore& store, const MaterialRegistry* materials) {
    const std::string name(kCaseText);
    const auto bytes = store.read(name);
    if (!bytes) return Unexpected{bytes.error()};
    return parseCase(asText(*bytes), store.shown(name),
                     [&](const std::string& entry) -> Expected<const MaterialRegistry*> {
                         if (materials != nullptr) return materials;
                         const auto text = store.read(entry);
                         if (!text) return Unexpected{text.error()};
                         return parseMaterials(asText(*text), store.shown(entry));
                     });
}

Expected<OpenedCase> openCase(const CaseStore& store, const std::string& tooth, const MaterialRegistry* materials) {
    auto description = readCaseDescription(store, materials);
    if (!description) return Unexpected{description.error()};
    OpenedCase opened;
    opened.description = std::move(*description);
    const auto chosen = findTooth(opened.description, tooth, store.shown(std::string(kCaseText)));
    if (!chosen) return Unexpected{chosen.error()};
    opened.tooth = (*chosen)->name;
    Assembly assembly(store, opened.description, **chosen);
    auto teeth = assembly.assemble();
    if (!teeth) return Unexpected{teeth.error()};
    opened.importNotes = assembly.takeImportNotes();
    opened.teeth = std::move(*teeth);
    opened.box = opened.teeth->ownBox();
    opened.mesialX = opened.teeth->toothContext().mesialX;
    if (auto extras = readExtras(store, opened); !extras) return Unexpected{extras.error()};
    return opened;
}

Expected<OpenedCase> openCase(const std::filesystem::path& path, const std::string& tooth,
                              const MaterialRegistry* materials) {
    const auto store = CaseStore::open(path);
    if (!store) return Unexpected{store.error()};
    return openCase(*store, tooth, materials);
}

Expected<std::vector<CaseBody>> caseBodies(const CaseStore& store, const CaseDescription& description) {
    std::vector<CaseBody> bodies;
    const auto add = [&](const std::string& name, const std::string& entry, const Pose& pose) -> Expected<void> {
        std::vector<ImportNote> importNotes;  // reported when the case was opened
        auto mesh = readSurface(store, entry, pose, importNotes);
        if (!mesh) return Unexpected{mesh.error()};
        bodies.push_back({name, std::move(*mesh)});
        return {};
    };
    for (const CaseTooth& tooth : description.teeth) {
        if (auto done = add(tooth.name, tooth.outer, tooth.toothInCase); !done) return Unexpected{done.error()};
    }
    for (const CaseSurrounding& body : description.around) {
        if (auto done = add(body.name, body.surface, body.bodyInCase); !done) return Unexpected{done.error()};
    }
    return bodies;
}

std::vector<CaseOverlap> overlaps(const std::vector<CaseBody>& bodies) {
    std::vector<SurfacePart> parts;
    parts.reserve(bodies.size());
    for (const CaseBody& body : bodies) parts.emplace_back(body.surface);
    std::vector<CaseOverlap> found;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = i + 1; j < parts.size(); ++j) {
            if (!parts[i].tree().box().intersects(parts[j].tree().box())) continue;
            const double deepest = std::max(deepestIn(parts[i], parts[j].mesh()), deepestIn(parts[j], parts[i].mesh()));
            constexpr double kTouch = 0.001;  // mm: teeth touch each other
            if (deepest > kTouch) found.push_back({bodies[i].name, bodies[j].name, deepest});
        }
    }
    return found;
}

}  // namespace tactooth
