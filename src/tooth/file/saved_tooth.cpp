// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "tooth/file/saved_tooth.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

#include "geometry/util/assert.h"
#include "geometry/util/byte_stream.h"
#include "tooth/file/tooth_snapshot.h"
#include "tooth/model/messages.h"

namespace tactooth {
namespace {

constexpr std::string_view kMagic = "TACTOOTH";
// Version 1 had no ToothContext, 2 no table of materials, 3 no work, 4 no materials of the tooth's own. A file has the
// lowest version that holds it, so that older programs read it as well.
constexpr std::uint32_t kVersion = 5, kWithoutOwnMaterials = 4, kWithoutWork = 3;
constexpr std::size_t kLongestTitle = 2000;  // bytes, of a material
constexpr std::uint32_t kMaxNumbers = 200;   // of a material
constexpr std::uint8_t kOldMaterials = 6;    // materials of versions 1 and 2: those with the codes 0 to 5
constexpr double kWidestBand = 2;            // voxels; the first files kept the cut distance in a wider band
constexpr double kFinestVoxel = 0.005;       // mm, the limit of the command line
constexpr double kCoarsestVoxel = 0.5;       // mm
constexpr int kFarthestBrick = 1 << 16;      // bricks from the origin: 13 m at the default voxel
constexpr std::size_t kMaxLayers = 2000;     // of a case: 200 bodies of a few layers each
constexpr std::size_t kMaxNotes = 10'000;
constexpr std::size_t kMaxWork = std::size_t{4} << 20;  // bytes

void putMesh(ByteWriter& out, const TriangleMesh& mesh) {
    TACTOOTH_ASSERT(mesh.vertices.size() <= std::numeric_limits<std::uint32_t>::max());
    TACTOOTH_ASSERT(mesh.triangles.size() <= std::numeric_limits<std::uint32_t>::max());
    out.put(static_cast<std::uint32_t>(mesh.vertices.size()));
    out.put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Vec3f& vertex : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) out.put(vertex[axis]);
    }
    out.putAll(std::span<const Triangle>(mesh.triangles));
}

/// Writes one part of each node's value: first a bit for each node that differs from the untouched value, then these
/// values.
template <class Value, class Part = std::identity>
void putField(ByteWriter& out, const std::array<Value, kBrickNodes>& values, const Value& unchanged, Part part = {}) {
    const auto& untouched = std::invoke(part, unchanged);
    for (int word = 0; word < kBrickNodes / 64; ++word) {
        std::uint64_t bits = 0;
        for (int i = 0; i < 64; ++i)
            bits |= std::uint64_t{!(std::invoke(part, values[64 * word + i]) == untouched)} << i;
        out.put(bits);
    }
    for (const Value& value : values) {
        if (!(std::invoke(part, value) == untouched)) out.put(std::invoke(part, value));
    }
}

void putBrick(ByteWriter& out, const BrickKey& key, const CutField& field, const CutField& untouched) {
    TACTOOTH_ASSERT(key.isInRange());
    for (const int place : {key.x, key.y, key.z}) out.put(std::int32_t{place});
    putField(out, field.cut, untouched.cut[0]);
    putField(out, field.cutNormal, untouched.cutNormal[0]);
    for (int axis = 0; axis < 3; ++axis) {
        putField(out, field.boundary[axis], untouched.boundary[axis][0], &HermiteSample::place);
        putField(out, field.boundary[axis], untouched.boundary[axis][0], &HermiteSample::normal);
    }
}

/// Reads a whole file and keeps the first error.
class ToothReader {
public:
    ToothReader(std::span<const std::byte> bytes, const std::string& name, const MaterialRegistry& materials)
        : in_(bytes), bytes_(bytes), name_(name) {
        tooth_.materials = &materials;
    }

    Expected<SavedTooth> read() {
        readHead();
        if (failure_.empty()) readNotes();
        if (failure_.empty()) readWork();
        if (failure_.empty()) readMaterialTable();
        if (failure_.empty()) readMesh(tooth_.outer);
        if (failure_.empty()) readLayers();
        if (failure_.empty()) readToothContext();
        if (failure_.empty()) readVolume();
        if (failure_.empty()) readEnd();
        if (!failure_.empty()) return unexpected(msg::kSavedToothRefused, name_, in_.at(), failure_);
        return std::move(tooth_);
    }

private:
    struct Named {
        std::uint8_t code;
        std::string name;
        std::optional<MaterialDefinition> own;  // what the file says of it
    };

    void require(bool holds, const MessageText& otherwise) {
        if (!failure_.empty()) return;
        if (!in_.ok()) {
            failure_ = msg::kSavedToothCutShort;
        } else if (!holds) {
            failure_ = otherwise;
        }
    }

    void readHead() {
        const std::span<const std::byte> magic = in_.getBytes(kMagic.size());
        const bool isOurs = in_.ok() && std::memcmp(magic.data(), kMagic.data(), kMagic.size()) == 0;
        if (!isOurs) {
            failure_ = msg::kNoSavedTooth;
            return;
        }
        version_ = in_.get<std::uint32_t>();
        if (in_.ok() && (version_ < 1 || version_ > kVersion)) {
            failure_ = {msg::kSavedToothVersion, version_, kVersion};
        } else {
            require(true, kDamaged);
        }
    }

    void readNotes() {
        const auto count = in_.get<std::uint32_t>();
        require(count <= kMaxNotes, kDamaged);
        for (std::uint32_t i = 0; i < count && failure_.empty(); ++i) {
            std::string key = in_.getText();
            std::string value = in_.getText();
            require(true, kDamaged);
            tooth_.provenance.emplace_back(std::move(key), std::move(value));
        }
    }

    void readWork() {
        if (version_ < 4) return;
        tooth_.work = in_.getText();
        require(tooth_.work.size() <= kMaxWork, kDamaged);
    }

    void readMesh(TriangleMesh& mesh) {
        const auto vertices = in_.get<std::uint32_t>();
        const auto triangles = in_.get<std::uint32_t>();
        const std::vector<std::array<float, 3>> places = in_.getAll<std::array<float, 3>>(vertices);
        mesh.triangles = in_.getAll<Triangle>(triangles);
        require(true, kDamaged);
        mesh.vertices.reserve(places.size());
        for (const auto& [x, y, z] : places) {
            mesh.vertices.emplace_back(x, y, z);
            const Vec3f& vertex = mesh.vertices.back();
            require(vertex.allFinite() && static_cast<double>(vertex.cwiseAbs().maxCoeff()) < kMaxCoordinate, kDamaged);
        }
        for (const Triangle& triangle : mesh.triangles) {
            for (const std::uint32_t corner : triangle) require(corner < places.size(), kDamaged);
        }
    }

    /// The codes of the file, and the names that they stand for.
    void readMaterialTable() {
        std::vector<Named> table;
        if (version_ < 3) {
            for (std::uint8_t code = 0; code < kOldMaterials; ++code) {
                table.push_back({code, builtinMaterials().nameOf(builtinMaterials().findCode(code).value()), {}});
            }
        } else {
            const auto count = in_.get<std::uint32_t>();
            require(count <= kMaxMaterials, kDamaged);
            for (std::uint32_t i = 0; i < count && failure_.empty(); ++i) {
                const auto code = in_.get<std::uint8_t>();
                table.push_back({code, in_.getText(), {}});
                require(isMaterialName(table.back().name), kDamaged);
                if (version_ > kWithoutOwnMaterials) table.back().own = readOwnMaterial();
            }
        }
        if (failure_.empty()) addUnknown(table);
        for (const auto& [code, name, own] : table) {
            if (!failure_.empty()) return;
            const MaterialId id = tooth_.materials->find(name).value();
            for (const FileMaterial& other : table_) require(other.code != code && other.id != id, kDamaged);
            table_.push_back({code, id});
        }
    }

    /// What the file itself says of a material.
    std::optional<MaterialDefinition> readOwnMaterial() {
        const auto isOwn = in_.get<std::uint8_t>();
        require(isOwn <= 1, kDamaged);
        if (isOwn == 0 || !failure_.empty()) return std::nullopt;
        MaterialDefinition own = asSurroundings();
        own.titleEn = in_.getText();
        own.titleJa = in_.getText();
        require(std::max(own.titleEn.size(), own.titleJa.size()) <= kLongestTitle, kDamaged);
        const auto role = materialRoleNamed(in_.getText());
        require(role.has_value(), kDamaged);
        own.role = role.value_or(MaterialRole::None);
        own.nesting = in_.get<std::int32_t>();
        require(own.nesting >= 0 && own.nesting <= kMaxMaterialNesting, kDamaged);
        for (float& part : own.numbers.colour) {
            part = in_.get<float>();
            require(part >= 0 && part <= 1, kDamaged);
        }
        const auto count = in_.get<std::uint32_t>();
        require(count <= kMaxNumbers, kDamaged);
        for (std::uint32_t i = 0; i < count && failure_.empty(); ++i) {
            const std::string name = in_.getText();
            const auto value = in_.get<double>();
            const auto keys = materialNumberKeys();
            const auto key = std::ranges::find(keys, name, &MaterialNumberKey::name);
            if (key == keys.end()) continue;  // of a later program
            require(value >= 0 && value <= key->highest, kDamaged);
            key->set(own.numbers, value);
        }
        return own;
    }

    [[nodiscard]] MaterialDefinition asSurroundings() const {
        MaterialDefinition material = (*tooth_.materials)[tooth_.materials->withRole(MaterialRole::Surroundings)];
        material.role = MaterialRole::None;
        return material;
    }

    /// Materials that the registry does not have are what the file says of them; else they are taken as the
    /// surroundings, under their own names.
    void addUnknown(const std::vector<Named>& table) {
        std::vector<MaterialDefinition> all = tooth_.materials->definitions();
        for (const auto& [code, name, own] : table) {
            if (tooth_.materials->find(name)) continue;
            if (std::ranges::find(all, name, &MaterialDefinition::name) != all.end()) return require(false, kDamaged);
            MaterialDefinition added = own.value_or(asSurroundings());
            added.name = name;
            if (!own) added.titleEn = added.titleJa = name;
            added.code = MaterialRegistry::freeCode(all).value_or(kMaxMaterialCode);
            all.push_back(std::move(added));
            if (!own) tooth_.unknownMaterials.push_back(name);
        }
        if (all.size() > kMaxMaterials) {
            failure_ = {msg::kSavedToothMaterials, kMaxMaterials};
        } else if (all.size() > tooth_.materials->size()) {
            tooth_.materials = &MaterialRegistry::make(std::move(all));
        }
    }

    [[nodiscard]] MaterialId readMaterial() {
        const auto code = in_.get<std::uint8_t>();
        const auto found = std::ranges::find(table_, code, &FileMaterial::code);
        require(found != table_.end(), kDamaged);
        return found != table_.end() ? found->id : MaterialId{};
    }

    void readLayers() {
        const auto count = in_.get<std::uint32_t>();
        require(count <= kMaxLayers, kDamaged);
        for (std::uint32_t i = 0; i < count && failure_.empty(); ++i) {
            LayerMesh layer;
            layer.material = readMaterial();
            layer.name = in_.getText();
            // Files are named after the layer.
            require(layer.name.find_first_of(std::string_view("/\0", 2)) == std::string::npos, kDamaged);
            readMesh(layer.mesh);
            tooth_.layers.push_back(std::move(layer));
        }
        tooth_.body = readMaterial();
    }

    void readToothContext() {
        if (version_ == 1) return;
        const auto mesial = in_.get<std::int8_t>();
        require(mesial == 1 || mesial == -1, kDamaged);
        tooth_.toothContext = {static_cast<double>(mesial), in_.get<std::uint32_t>()};
        require(true, kDamaged);
    }

    void readVolume() {
        tooth_.voxel = in_.get<double>();
        require(tooth_.voxel >= kFinestVoxel && tooth_.voxel <= kCoarsestVoxel, kDamaged);
        for (const FileMaterial& material : table_) {
            double& volume = tooth_.removed[static_cast<std::size_t>(material.id)];
            volume = in_.get<double>();
            require(std::isfinite(volume) && volume >= 0, kDamaged);
        }
        const auto count = in_.get<std::uint64_t>();
        if (!failure_.empty()) return;
        const CutField untouched = CutField::untouched(tooth_.voxel);
        for (std::uint64_t i = 0; i < count && failure_.empty(); ++i) readBrick(untouched);
    }

    void readBrick(const CutField& untouched) {
        const BrickKey key{in_.get<std::int32_t>(), in_.get<std::int32_t>(), in_.get<std::int32_t>()};
        for (const int place : {key.x, key.y, key.z}) require(std::abs(place) < kFarthestBrick, kDamaged);
        require(tooth_.cuts.empty() || tooth_.cuts.rbegin()->first < key, kDamaged);
        CutField field = untouched;
        field.isCut = true;
        const float band = untouched.cut[0];
        const auto widest = static_cast<float>(kWidestBand * tooth_.voxel);
        readField(field.cut, [&](float distance) { return distance >= -widest && distance <= widest; });
        for (float& distance : field.cut) distance = std::clamp(distance, -band, band);
        const auto anyDirection = [](const OctahedralNormal&) { return true; };
        readField(field.cutNormal, anyDirection);
        for (auto& crossings : field.boundary) {
            readField(
                crossings, [](float place) { return place >= 0 && place <= 1; }, &HermiteSample::place);
            readField(crossings, anyDirection, &HermiteSample::normal);
        }
        if (failure_.empty()) tooth_.cuts.emplace_hint(tooth_.cuts.end(), key, field);
    }

    /// Reads one part of each node's value, as putField writes it.
    template <class Value, class IsValid, class Part = std::identity>
    void readField(std::array<Value, kBrickNodes>& values, const IsValid& isValid, Part part = {}) {
        std::array<std::uint64_t, kBrickNodes / 64> touched{};
        for (std::uint64_t& word : touched) word = in_.get<std::uint64_t>();
        for (int node = 0; node < kBrickNodes && in_.ok(); ++node) {
            if ((touched[node / 64] >> (node % 64) & 1) == 0) continue;
            auto& value = std::invoke(part, values[node]);
            value = in_.get<std::remove_reference_t<decltype(value)>>();
            require(isValid(value), kDamaged);
        }
        require(true, kDamaged);
    }

    void readEnd() {
        const std::uint64_t expected = checksum(bytes_.first(in_.at()));
        const auto found = in_.get<std::uint64_t>();
        require(found == expected, kDamaged);
        require(in_.left() == 0, msg::kSavedToothTooLong);
    }

    static constexpr const MessageText& kDamaged = msg::kSavedToothDamaged;

    ByteReader in_;
    std::span<const std::byte> bytes_;
    const std::string& name_;
    SavedTooth tooth_;
    std::uint32_t version_ = 0;
    struct FileMaterial {
        std::uint8_t code;
        MaterialId id;
    };
    std::vector<FileMaterial> table_;  // in the order of the file
    Message failure_;
};

/// The materials that a file must name: those of the layers and the body, and all that something was removed of.
std::vector<MaterialId> materialsIn(const LayeredTooth& tooth, const MaterialVolumes& removed) {
    std::vector<MaterialId> found;
    for (const MaterialId id : tooth.materials().ids()) {
        const bool isLayer =
            std::ranges::find(tooth.layers(), id, &LayeredTooth::Layer::material) != tooth.layers().end();
        if (isLayer || id == tooth.body() || removed[static_cast<std::size_t>(id)] > 0) found.push_back(id);
    }
    return found;
}

/// A material that not every program knows.
bool isOwn(const MaterialDefinition& material) { return !builtinMaterials().find(material.name); }

void putMaterial(ByteWriter& out, const MaterialDefinition& material, bool withNumbers) {
    out.put(material.code);
    out.putText(material.name);
    if (!withNumbers) return;
    out.put(std::uint8_t{isOwn(material)});
    if (!isOwn(material)) return;
    out.putText(material.titleEn);
    out.putText(material.titleJa);
    out.putText(std::string(materialRoleName(material.role)));
    out.put(std::int32_t{material.nesting});
    for (const float part : material.numbers.colour) out.put(part);
    const auto keys = materialNumberKeys();
    out.put(static_cast<std::uint32_t>(keys.size()));
    for (const MaterialNumberKey& key : keys) {
        out.putText(std::string(key.name));
        out.put(key.of(material.numbers));
    }
}

}  // namespace

namespace {

/// The cut bricks of a volume or of a snapshot, in ascending order of the keys.
using CutBricks = std::vector<std::pair<BrickKey, const CutField*>>;

std::vector<std::byte> bytesOf(const LayeredTooth& tooth, double voxel, const MaterialVolumes& removed,
                               const CutBricks& bricks, const Provenance& provenance, const std::string& work) {
    TACTOOTH_ASSERT(work.size() <= kMaxWork);
    ByteWriter out;
    out.putAll(std::span(kMagic.data(), kMagic.size()));
    const std::vector<MaterialId> materials = materialsIn(tooth, removed);
    const bool hasOwn = std::ranges::any_of(materials, [&](MaterialId id) { return isOwn(tooth.materials()[id]); });
    const std::uint32_t version = hasOwn ? kVersion : work.empty() ? kWithoutWork : kWithoutOwnMaterials;
    out.put(version);
    out.put(static_cast<std::uint32_t>(provenance.size()));
    for (const auto& [key, value] : provenance) out.putText(key), out.putText(value);
    if (version > kWithoutWork) out.putText(work);
    out.put(static_cast<std::uint32_t>(materials.size()));
    for (const MaterialId id : materials) putMaterial(out, tooth.materials()[id], hasOwn);
    putMesh(out, tooth.outer()->mesh());
    out.put(static_cast<std::uint32_t>(tooth.layers().size()));
    for (const LayeredTooth::Layer& layer : tooth.layers()) {
        out.put(tooth.materials()[layer.material].code);
        out.putText(layer.name);
        putMesh(out, layer.part->mesh());
    }
    out.put(tooth.materials()[tooth.body()].code);
    out.put(static_cast<std::int8_t>(tooth.toothContext().mesialX < 0 ? -1 : 1));
    out.put(tooth.toothContext().firstAdjacent);

    out.put(voxel);
    for (const MaterialId id : materials) {
        const double gone = removed[static_cast<std::size_t>(id)];
        TACTOOTH_ASSERT(std::isfinite(gone) && gone >= 0);
        out.put(gone);
    }
    out.put(static_cast<std::uint64_t>(bricks.size()));
    const CutField untouched = CutField::untouched(voxel);
    for (const auto& [key, field] : bricks) putBrick(out, key, *field, untouched);
    out.put(checksum(out.bytes()));
    return out.take();
}

}  // namespace

std::vector<std::byte> savedToothBytes(const CutVolume& volume, const MaterialVolumes& removed,
                                       const Provenance& provenance, const std::string& work) {
    CutBricks bricks;
    for (const BrickKey& key : volume.cutBricks()) bricks.emplace_back(key, volume.bricks().find(key));
    return bytesOf(*volume.tooth(), volume.lattice().spacing(), removed, bricks, provenance, work);
}

ToothSnapshot snapshotOf(const CutVolume& volume, const MaterialVolumes& removed) {
    ToothSnapshot snapshot{volume.tooth(), volume.lattice().spacing(), removed, {}};
    const std::vector<BrickKey> keys = volume.cutBricks();
    snapshot.cuts.reserve(keys.size());
    for (const BrickKey& key : keys) snapshot.cuts.emplace_back(key, *volume.bricks().find(key));
    return snapshot;
}

std::vector<std::byte> savedToothBytes(const ToothSnapshot& snapshot, const Provenance& provenance,
                                       const std::string& work) {
    CutBricks bricks;
    for (const auto& [key, field] : snapshot.cuts) bricks.emplace_back(key, &field);
    return bytesOf(*snapshot.tooth, snapshot.voxel, snapshot.removed, bricks, provenance, work);
}

Expected<SavedTooth> parseSavedTooth(std::span<const std::byte> bytes, const std::string& name,
                                     const MaterialRegistry& materials) {
    return ToothReader(bytes, name, materials).read();
}

}  // namespace tactooth
