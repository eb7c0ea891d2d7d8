// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/recording/session_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <random>

#include "geometry/util/byte_stream.h"
#include "session/io/run_metadata.h"
#include "session/recording/messages.h"
#include "session/recording/session_setup.h"

namespace tactooth {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxSurroundings = 1000;
constexpr std::uint64_t kMaxParts = 1'000'000;
constexpr const char* kSealed = "sealed";
Json jsonOf(const MaterialDefinition& material) {
    Json json = {{"name", material.name},        {"title_en", material.titleEn},
                 {"title_ja", material.titleJa}, {"role", materialRoleName(material.role)},
                 {"nesting", material.nesting},  {"code", material.code}};
    if (builtinMaterials().find(material.name)) return json;
    for (const MaterialNumberKey& key : materialNumberKeys()) json["numbers"][key.name] = key.of(material.numbers);
    json["numbers"][kMaterialColourKey] = material.numbers.colour;
    return json;
}

std::string textOf(const Json& json, const char* key) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// A whole number from 0 to `highest`.
std::optional<std::uint64_t> numberOf(const Json& json, const char* key, std::uint64_t highest) {
    const auto found = json.is_object() ? json.find(key) : json.end();
    if (found == json.end() || !found->is_number_unsigned()) return std::nullopt;
    const auto value = found->get<std::uint64_t>();
    return value <= highest ? std::optional(value) : std::nullopt;
}

/// Of a material that came with the tooth. What is missing or out of range stays as it is.
void takeNumbers(Material& material, const Json& json) {
    const auto inRange = [](const Json& value, double highest) {
        return value.is_number() && value.get<double>() >= 0 && value.get<double>() <= highest;
    };
    for (const MaterialNumberKey& key : materialNumberKeys()) {
        const auto found = json.find(key.name);
        if (found != json.end() && inRange(*found, key.highest)) key.set(material, found->get<double>());
    }
    const auto colour = json.find(kMaterialColourKey);
    if (colour == json.end() || !colour->is_array() || colour->size() != material.colour.size()) return;
    for (std::size_t i = 0; i < material.colour.size(); ++i) {
        if (inRange((*colour)[i], 1)) material.colour[i] = (*colour)[i].get<float>();
    }
}

std::optional<MaterialDefinition> materialOf(const Json& json) {
    MaterialDefinition material;
    material.name = textOf(json, "name");
    material.titleEn = textOf(json, "title_en");
    material.titleJa = textOf(json, "title_ja");
    const auto role = materialRoleNamed(textOf(json, "role"));
    const auto nesting = numberOf(json, "nesting", kMaxMaterialNesting),
               code = numberOf(json, "code", kMaxMaterialCode);
    if (!role || !nesting || !code || !isMaterialName(material.name)) return std::nullopt;
    material.role = *role;
    material.nesting = static_cast<int>(*nesting);
    material.code = static_cast<std::uint8_t>(*code);
    // The setup of each bur brings the numbers that count for the simulation; the others are as in this program.
    const MaterialRegistry& builtin = builtinMaterials();
    const auto same = builtin.find(material.name);
    material.numbers = builtin[same.value_or(builtin.withRole(MaterialRole::Surroundings))].numbers;
    const auto numbers = json.find("numbers");
    if (!same && numbers != json.end() && numbers->is_object()) takeNumbers(material.numbers, *numbers);
    return material;
}

/// Null if the list is none that MaterialRegistry::make accepts.
const MaterialRegistry* registryOf(const Json& json) {
    if (!json.is_array() || json.size() > kMaxMaterials) return nullptr;
    std::vector<MaterialDefinition> all;
    for (const Json& one : json) {
        std::optional<MaterialDefinition> material = materialOf(one);
        if (!material) return nullptr;
        const auto isSame = [&](const MaterialDefinition& other) {
            return other.name == material->name || other.code == material->code;
        };
        if (std::ranges::any_of(all, isSame)) return nullptr;
        all.push_back(std::move(*material));
    }
    for (std::size_t role = 1; role < kMaterialRoleCount; ++role) {
        if (std::ranges::find(all, static_cast<MaterialRole>(role), &MaterialDefinition::role) == all.end())
            return nullptr;
    }
    return &MaterialRegistry::make(std::move(all));
}

RecordingPart partOfJson(const Json& json) {
    const auto part = json.is_object() ? json.find("part") : json.end();
    if (part == json.end()) return {};
    const auto number = numberOf(*part, "number", kMaxParts);
    if (!number || *number == 0) return {};
    return {textOf(*part, "session"), static_cast<std::uint32_t>(*number)};
}

}  // namespace

std::string workAttachment(std::size_t index) { return fmt::format("work-{}", index); }

std::string surroundingAttachment(std::size_t index) { return fmt::format("surrounding-{}", index); }

std::vector<std::byte> surroundingBytes(const SurfacePart& body) {
    ByteWriter out;
    out.put(body.firstAdjacent());
    out.put(static_cast<std::uint64_t>(body.tags().size()));
    out.putAll(std::span(body.tags()));
    out.putAll(std::span<const std::byte>(attachmentOf(body.mesh()).content));
    return out.take();
}

std::shared_ptr<const SurfacePart> surroundingOf(std::span<const std::byte> content) {
    ByteReader in(content);
    const auto firstAdjacent = in.get<std::uint32_t>();
    std::vector<SurfaceTag> tags = in.getAll<SurfaceTag>(in.get<std::uint64_t>());
    if (!in.ok()) return nullptr;
    std::optional<TriangleMesh> mesh = meshOf(in.getBytes(in.left()));
    if (!mesh || mesh->empty() || (!tags.empty() && tags.size() != mesh->triangles.size())) return nullptr;
    if (std::ranges::any_of(tags, [](SurfaceTag tag) { return tag >= kMaxMaterials; })) return nullptr;
    return std::make_shared<const SurfacePart>(std::move(*mesh), std::move(tags), firstAdjacent);
}

std::vector<std::byte> touchedBytes(const LayeredTooth& tooth) {
    ByteWriter out;
    out.put(std::uint32_t{tooth.isClosed() ? 1U : 0U});
    out.putAll(std::span<const std::byte>(surroundingBytes(*tooth.outer())));
    return out.take();
}

std::optional<LayeredTooth> touchedOf(std::span<const std::byte> content, const MaterialRegistry& materials) {
    ByteReader in(content);
    const auto closed = in.get<std::uint32_t>();
    if (!in.ok() || closed > 1) return std::nullopt;
    std::shared_ptr<const SurfacePart> surface = surroundingOf(in.getBytes(in.left()));
    if (surface == nullptr) return std::nullopt;
    if (std::ranges::any_of(surface->tags(), [&](SurfaceTag tag) { return tag >= materials.size(); })) return {};
    return LayeredTooth::touchOnly(std::move(surface), closed == 1, materials);
}

RecordingPart firstPart() {
    std::random_device random;
    return {fmt::format("{:08x}{:08x}", random(), random())};
}

std::string recordingHeader(const CutModel& model, const std::string& title, const PublicKey* seal,
                            const RecordingPart& part) {
    const RunMetadata run = currentRunMetadata();
    Json materials = Json::array();
    for (const MaterialDefinition& material : model.tooth().materials().definitions()) {
        materials.push_back(jsonOf(material));
    }
    Json json = {{"format", "Tactooth session"},
                 {"title", title},
                 {"build", {{"commit", run.commit}, {"compiler", run.compiler}}},
                 {"machine", run.machine},
                 {"date", run.date},
                 {"grid",
                  {{"position_mm", TickInput::kPositionStep},
                   {"rotation", TickInput::kRotationStep},
                   {"pedal", TickInput::kPedalStep},
                   {"time_s", TickInput::kTimeStep}}},
                 {"touches_only", model.tooth().isTouchOnly()},
                 {"surroundings", model.surroundings().size()},
                 {"materials", materials}};
    if (seal != nullptr) {
        json[kSealed] = {{"public_key", keyText(*seal)}, {"signature", "Ed25519"}, {"digest", "BLAKE2b-256"}};
    }
    if (!part.session.empty()) json["part"] = {{"session", part.session}, {"number", part.number}};
    return json.dump();
}

std::optional<std::string> unsealedHeader(const std::string& text) {
    Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    const auto sealed = json.is_object() ? json.find(kSealed) : json.end();
    if (sealed == json.end()) return std::nullopt;
    const std::string key = textOf(*sealed, "public_key");
    json.erase(kSealed);
    json["copy_of_sealed_by"] = key;
    return json.dump();
}

RecordingPart partOf(const std::string& headerJson) {
    return partOfJson(Json::parse(headerJson, nullptr, /*allow_exceptions=*/false));
}

Expected<RecordingFacts> parseHeader(const std::string& text, const std::string& file) {
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!json.is_object()) return unexpected(msg::kRecordingSetupJson, file);
    RecordingFacts facts;
    facts.title = textOf(json, "title");
    facts.commit = textOf(json.value("build", Json::object()), "commit");
    facts.compiler = textOf(json.value("build", Json::object()), "compiler");
    facts.machine = textOf(json, "machine");
    facts.date = textOf(json, "date");
    const auto touchesOnly = json.find("touches_only");
    facts.touchesOnly = touchesOnly != json.end() && touchesOnly->is_boolean() && touchesOnly->get<bool>();
    facts.isSealed = json.contains(kSealed);
    if (facts.isSealed) facts.sealKey = parseKey(textOf(json[kSealed], "public_key"));
    facts.part = partOfJson(json);
    const auto surroundings = numberOf(json, "surroundings", kMaxSurroundings);
    if (!surroundings) return unexpected(msg::kRecordingSetupKey, file, "surroundings");
    facts.surroundings = *surroundings;
    facts.materials = registryOf(json.value("materials", Json::array()));
    if (facts.materials == nullptr) return unexpected(msg::kRecordingSetupKey, file, "materials");
    return facts;
}

std::string endText(const RecordedEnd& end) {
    Json json = Json::object();
    if (end.toothHash) json["tooth_hash"] = fmt::format("{:016x}", *end.toothHash);
    if (end.hasGap) json["gap"] = true;
    return Json{{"end", json}}.dump();
}

std::optional<RecordedEnd> parseEnd(const std::string& text) {
    const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
    if (!json.is_object() || !json.contains("end")) return std::nullopt;
    const Json& gap = json["end"].is_object() && json["end"].contains("gap") ? json["end"]["gap"] : Json();
    if (gap.is_boolean() && gap.get<bool>()) return RecordedEnd{.hasGap = true};
    const std::string hash = textOf(json["end"], "tooth_hash");
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(hash.data(), hash.data() + hash.size(), value, 16);
    if (error != std::errc() || end != hash.data() + hash.size() || hash.empty()) return std::nullopt;
    return RecordedEnd{.toothHash = value};
}

}  // namespace tactooth
