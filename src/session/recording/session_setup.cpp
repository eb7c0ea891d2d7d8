// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geometry/util/byte_stream.h"
#include "geometry/util/fnv1a.h"
#include "session/recording/messages.h"
#include "session/simulation/tooth_source.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMaxMeshVertices = 1 << 24;
constexpr int kMaxFlutes = 1000;
constexpr const char* kHand = "hand";

/// Words of the file for the members of an enum; never change one.
constexpr std::array kModes = {std::pair(ContactMode::Proxy, "proxy"), std::pair(ContactMode::Penalty, "penalty")};
constexpr std::array kFreedoms = {std::pair(Freedom::Translation, "translation"),
                                  std::pair(Freedom::TranslationAndRotation, "translation_and_rotation")};
constexpr std::array kCurves = {std::pair(PedalCurve::Air, "air"), std::pair(PedalCurve::Electric, "electric")};

constexpr std::array kPlacements = {std::pair(Placement::Deferred, "deferred"),
                                    std::pair(Placement::AtOnce, "at_once")};

// Largest values in place of a material's own: what the command `feel` accepts.
constexpr double kMaxGivenStiffness = 1000;  // N/mm
constexpr double kMaxGivenDamping = 100;     // N*s/mm
constexpr double kMaxGivenFriction = 10;

template <class Words, class Value>
const char* wordFor(const Words& words, Value value) {
    return std::ranges::find(words, value, [](const auto& word) { return word.first; })->second;
}

/// A number of a drive: its name in the file and its place.
struct SpindleNumber {
    const char* key;
    double SpindlePreset::*place;
};
constexpr auto kSpindleNumbers = std::to_array<SpindleNumber>({{"free_speed_rpm", &SpindlePreset::freeSpeedRpm},
                                                               {"stall_torque", &SpindlePreset::stallTorque},
                                                               {"brake_torque", &SpindlePreset::brakeTorque},
                                                               {"droop_rpm", &SpindlePreset::droopRpm},
                                                               {"inertia", &SpindlePreset::inertia},
                                                               {"pedal_dead_band", &SpindlePreset::pedalDeadBand},
                                                               {"min_speed_rpm", &SpindlePreset::minSpeedRpm}});

/// A number of a material that the simulation uses.
struct MaterialNumber {
    const char* key;
    double Material::*place;
    double highest;
};
constexpr auto kMaterialNumbers =
    std::to_array<MaterialNumber>({{"stiffness", &Material::stiffness, kMaxMaterialStiffness},
                                   {"damping", &Material::damping, kMaxMaterialDamping},
                                   {"friction", &Material::friction, kMaxMaterialFriction},
                                   {"removal", &Material::removal, 1e6}});

Json jsonOf(const SpindlePreset& spindle) {
    Json json = {{"name", spindle.name}, {"pedal_curve", wordFor(kCurves, spindle.pedalCurve)}};
    for (const auto& [key, place] : kSpindleNumbers) json[key] = spindle.*place;
    return json;
}

Json jsonOf(const MaterialTable& materials) {
    Json json = Json::object();
    for (const MaterialId id : materials.registry().ids()) {
        Json numbers = Json::object();
        for (const auto& [key, place, highest] : kMaterialNumbers) numbers[key] = materials[id].*place;
        json[materials.registry().nameOf(id)] = std::move(numbers);
    }
    return json;
}

/// Reads a setup. The first fault counts.
class SetupReader {
public:
    SetupReader(const Json& json, std::string file) : json_(json), file_(std::move(file)) {}

    [[nodiscard]] Expected<BeginEvent> read(const MaterialRegistry& materials, const MeshFinder& findMesh) {
        HapticSettings settings;
        settings.materials = MaterialTable(materials);
        readSettings(settings);
        const Json& bur = part(json_, "bur");
        const std::string mesh = text(bur, "surface");
        const double sharpness = number(bur, "sharpness", 0, 1e3);
        const BurEdge edge{static_cast<int>(number(bur, "flutes", 0, kMaxFlutes)), number(bur, "grit_um", 0, 1e4)};
        const bool cuts = !isFalse(bur, "cuts");
        const HandInstrumentSpec* const hand = handOf(bur);
        if (fault_) return Unexpected{*fault_};
        std::optional<TriangleMesh> surface = findMesh(mesh);
        if (!surface) return unexpected(msg::kRecordingBurMissing, file_, mesh);
        if (hand != nullptr) {
            auto shape = std::make_shared<const ToolShape>(std::move(*surface));
            return BeginEvent{handTool(hand->kind, std::move(shape)), std::move(settings), placement_};
        }
        if (!cuts) {
            auto shape = std::make_shared<const ToolShape>(std::move(*surface));
            return BeginEvent{touchingTool(std::move(shape)), std::move(settings), placement_};
        }
        Expected<CuttingTool> cutting = makeCuttingTool(*surface, sharpness);
        if (!cutting) return unexpected(msg::kRecordingBurRefused, file_, cutting.error());
        auto shape = std::make_shared<const ToolShape>(std::move(*surface));
        return BeginEvent{{std::move(shape), std::move(*cutting), edge}, std::move(settings), placement_};
    }

private:
    const Json& part(const Json& json, const char* key) {
        static const Json none = Json::object();
        const auto found = json.is_object() ? json.find(key) : json.end();
        if (found != json.end() && found->is_object()) return *found;
        fail(key);
        return none;
    }
    std::string text(const Json& json, const char* key) {
        const auto found = json.find(key);
        if (found != json.end() && found->is_string()) return found->get<std::string>();
        fail(key);
        return {};
    }
    /// Null for a bur, and for a tool that only touches.
    const HandInstrumentSpec* handOf(const Json& bur) {
        if (!bur.contains(kHand)) return nullptr;
        const HandInstrumentSpec* const spec = findHandInstrument(text(bur, kHand));
        if (spec == nullptr) fail(kHand);
        return spec;
    }
    /// A missing key is not false.
    static bool isFalse(const Json& json, const char* key) {
        const auto found = json.find(key);
        return found != json.end() && found->is_boolean() && !found->get<bool>();
    }
    double number(const Json& json, const char* key, double lowest, double highest) {
        const auto found = json.find(key);
        const double value = found != json.end() && found->is_number() ? found->get<double>() : std::nan("");
        if (value >= lowest && value <= highest) return value;
        fail(key);
        return lowest;
    }
    /// Nothing for a number that is not there.
    std::optional<double> given(const Json& json, const char* key, double highest) {
        if (!json.contains(key)) return std::nullopt;
        return number(json, key, 0, highest);
    }
    template <class Words>
    auto word(const Json& json, const char* key, const Words& words) {
        const std::string given = text(json, key);
        const auto found = std::ranges::find_if(words, [&](const auto& one) { return given == one.second; });
        if (found == words.end()) fail(key);
        return found != words.end() ? found->first : words.front().first;
    }
    void readSettings(HapticSettings& settings) {
        const Json& json = part(json_, "settings");
        settings.mode = word(json, "contact", kModes);
        settings.freedom = word(json, "freedom", kFreedoms);
        if (json.contains("placement")) placement_ = word(json, "placement", kPlacements);
        const bool isLimited = json.contains("tick_budget") && !json["tick_budget"].is_null();
        settings.tickBudget = isLimited ? static_cast<Work>(number(json, "tick_budget", 1, 1e12)) : kUnlimitedWork;
        const Json& spindle = part(json, "spindle");
        settings.spindle.name = text(spindle, "name");
        settings.spindle.pedalCurve = word(spindle, "pedal_curve", kCurves);
        for (const auto& [key, place] : kSpindleNumbers) settings.spindle.*place = number(spindle, key, 0, 1e9);
        const Json& force = part(json, "force");
        settings.force.stiffness = given(force, "stiffness", kMaxGivenStiffness);
        settings.force.damping = given(force, "damping", kMaxGivenDamping);
        settings.force.friction = given(force, "friction", kMaxGivenFriction);
        const Json& materials = part(json, "materials");
        for (const MaterialId id : settings.materials.registry().ids()) {
            const Json& material = part(materials, settings.materials.registry().nameOf(id).c_str());
            for (const auto& [key, place, highest] : kMaterialNumbers) {
                settings.materials[id].*place = number(material, key, 0, highest);
            }
        }
    }

    void fail(const char* key) {
        if (!fault_) fault_ = Error(msg::kRecordingSetupKey, file_, key);
    }

    const Json& json_;
    std::string file_;
    Placement placement_ = Placement::Deferred;
    std::optional<Error> fault_;
};

/// Whether every corner names a vertex, and every vertex is where readers of surfaces accept one.
bool isWhole(const TriangleMesh& mesh) {
    const auto isVertex = [&](std::uint32_t corner) { return corner < mesh.vertices.size(); };
    const auto isNear = [](const Vec3f& vertex) {
        return vertex.allFinite() && static_cast<double>(vertex.cwiseAbs().maxCoeff()) <= kMaxCoordinate;
    };
    return std::ranges::all_of(mesh.vertices, isNear) &&
           std::ranges::all_of(mesh.triangles,
                               [&](const Triangle& triangle) { return std::ranges::all_of(triangle, isVertex); });
}

}  // namespace

MeshAttachment attachmentOf(const TriangleMesh& mesh) {
    ByteWriter out;
    out.put(static_cast<std::uint64_t>(mesh.vertices.size()));
    out.put(static_cast<std::uint64_t>(mesh.triangles.size()));
    for (const Vec3f& vertex : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) out.put(vertex[axis]);
    }
    for (const Triangle& triangle : mesh.triangles) out.put(triangle);
    const std::uint64_t hash = Fnv1a().addBytes(out.bytes()).value();
    return {fmt::format("surface-{:016x}", hash), out.take()};
}

std::optional<TriangleMesh> meshOf(std::span<const std::byte> content) {
    ByteReader in(content);
    const auto vertices = in.get<std::uint64_t>(), triangles = in.get<std::uint64_t>();
    if (!in.ok() || vertices > kMaxMeshVertices || triangles > 2 * kMaxMeshVertices) return std::nullopt;
    if (in.left() != vertices * 3 * sizeof(float) + triangles * sizeof(Triangle)) return std::nullopt;
    TriangleMesh mesh;
    mesh.vertices.resize(vertices);
    for (Vec3f& vertex : mesh.vertices) {
        for (int axis = 0; axis < 3; ++axis) vertex[axis] = in.get<float>();
    }
    mesh.triangles = in.getAll<Triangle>(triangles);
    if (!in.ok() || !isWhole(mesh)) return std::nullopt;
    return mesh;
}

std::string setupText(const BeginEvent& event, const std::string& bur) {
    const HapticSettings& settings = event.settings;
    Json force = Json::object();
    if (settings.force.stiffness) force["stiffness"] = *settings.force.stiffness;
    if (settings.force.damping) force["damping"] = *settings.force.damping;
    if (settings.force.friction) force["friction"] = *settings.force.friction;
    const Json budget = settings.tickBudget == kUnlimitedWork ? Json(nullptr) : Json(settings.tickBudget);
    Json json = {{"bur",
                  {{"surface", bur},
                   {"cuts", event.instrument.cuts},
                   {"sharpness", event.instrument.cutting.sharpness},
                   {"flutes", event.instrument.edge.flutes},
                   {"grit_um", event.instrument.edge.gritMicrometres}}},
                 {"settings",
                  {{"contact", wordFor(kModes, settings.mode)},
                   {"freedom", wordFor(kFreedoms, settings.freedom)},
                   {"tick_budget", budget},
                   {"placement", wordFor(kPlacements, event.placement)},
                   {"spindle", jsonOf(settings.spindle)},
                   {"force", force},
                   {"materials", jsonOf(settings.materials)}}}};
    if (event.instrument.hand) json["bur"][kHand] = specOf(*event.instrument.hand).name;
    return json.dump();
}

Expected<BeginEvent> parseSetup(const std::string& text, const MaterialRegistry& materials, const MeshFinder& findMesh,
                                const std::string& file) {
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (json.is_discarded()) return unexpected(msg::kRecordingSetupJson, file);
    return SetupReader(json, file).read(materials, findMesh);
}

}  // namespace tactooth
