// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_preset.h"

#include <cmath>
#include <string>

#include "geometry/files/file_bytes.h"
#include "geometry/util/number_text.h"
#include "session/audio/material_sound.h"
#include "session/cases/case_store.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"
#include "session/io/toml_reader.h"
#include "sound/files/recording_file.h"

namespace tactooth {
namespace {

constexpr double kSlowest = 100, kFastest = 1e6;  // rev/min of a recorded bur
constexpr double kSoftest = -40, kLoudest = 20;   // dB

static_assert(kMaxRecordedMaterials >= kMaxMaterials, "each material may have a recording");

/// Reads the parts of a preset into a kit, up to the first mistake.
class PresetReader {
public:
    PresetReader(const std::string& name, const MaterialRegistry* materials, const RecordingReader& readNamed)
        : toml_(name), materials_(materials), readNamed_(readNamed) {}

    Expected<SoundKit> read(std::string_view text) {
        const toml::table root = toml_.parse(text);
        for (auto&& [key, node] : root) {
            const bool isRead = key.str() == "cutting" ? readCutting(node) : readNamedPart(key, node);
            if (!isRead) break;
        }
        if (toml_.error()) return Unexpected{*toml_.error()};
        return std::move(kit_);
    }

private:
    bool readNamedPart(const toml::key& key, const toml::node& node) {
        if (key.str() == "motor") return readPart(key.str(), node, true, kit_.motor.emplace());
        if (key.str() == "water") return readPart(key.str(), node, false, kit_.water.emplace());
        if (key.str() == "suction") return readPart(key.str(), node, false, kit_.suction.emplace());
        return fail(key, {msg::kSoundPartUnknown, quotedWord(key.str()), msg::kSoundParts});
    }

    bool readCutting(const toml::node& node) {
        const toml::table* recordings = node.as_table();
        if (recordings == nullptr) return fail(node, msg::kCuttingNeedsMaterial);
        for (auto&& [key, part] : *recordings) {
            if (!isMaterial(key)) return false;
            RecordedMaterial& material = kit_.cutting.emplace_back();
            material.kind = soundKindOf(key.str());
            if (!readPart(key.str(), part, false, material.part)) return false;
        }
        return true;
    }

    bool isMaterial(const toml::key& key) {
        if (kit_.cutting.size() == kMaxRecordedMaterials)
            return fail(key, {msg::kTooManyMaterials, kMaxRecordedMaterials});
        if (materials_ == nullptr)
            return isMaterialName(key.str()) || fail(key, {msg::kMaterialNameRefused, quotedWord(key.str())});
        return materials_->find(key.str()) ||
               fail(key, {msg::kMaterialUnknown, quotedWord(key.str()), materials_->names()});
    }

    bool readPart(std::string_view part, const toml::node& node, bool needsSpeed, RecordedPart& into) {
        const toml::table* table = node.as_table();
        if (table == nullptr) return fail(node, {msg::kSoundPartNotTable, quotedWord(part), msg::kSoundKeys});
        for (auto&& [key, value] : *table) {
            if (!readKey(key, value, into)) return false;
        }
        const toml::node* file = table->get("file");
        if (file == nullptr) return fail(node, {msg::kSoundPartNoRecording, quotedWord(part)});
        if (needsSpeed && into.speedRpm == 0) return fail(node, {msg::kSoundPartNoSpeed, quotedWord(part)});
        return readFile(*file, into);
    }

    bool readKey(const toml::key& key, const toml::node& node, RecordedPart& part) {
        double decibel = 0;
        if (key.str() == "file") return node.is_string() || fail(node, msg::kSoundFileNotText);
        if (key.str() == "speed_rpm") return readNumber(key.str(), node, kSlowest, kFastest, part.speedRpm);
        if (key.str() != "gain_db") {
            return fail(key, {msg::kUnknownKey, msg::kARecording, quotedWord(key.str()), msg::kSoundKeys});
        }
        if (!readNumber(key.str(), node, kSoftest, kLoudest, decibel)) return false;
        part.gain = std::pow(10, decibel / 20);
        return true;
    }

    bool readNumber(std::string_view key, const toml::node& node, double low, double high, double& value) {
        const auto number = toml_.numberOf(node, key, low, high);
        if (number) value = *number;
        return number.has_value();
    }

    bool readFile(const toml::node& file, RecordedPart& part) {
        const auto entry = *file.value<std::string>();
        if (!isSafeEntry(entry)) {
            return fail(file, {msg::kMustLieBeside, quotedWord(entry)});
        }
        auto recording = readNamed_(entry);
        if (!recording) return fail(file, recording.error());
        part.recording = std::make_shared<const Recording>(std::move(*recording));
        return true;
    }

    template <class Where>
    bool fail(const Where& where, const Message& what) {
        toml_.fail(where, what);
        return false;
    }

    TomlReader toml_;
    const MaterialRegistry* materials_;
    const RecordingReader& readNamed_;
    SoundKit kit_;
};

Expected<SoundKit> readPreset(const std::filesystem::path& path, const MaterialRegistry* materials) {
    const Expected<FileBytes> file = readFile(path, kTomlLimits.bytes);
    if (!file) return Unexpected{file.error()};
    const auto readSibling = [&](const std::string& name) -> Expected<Recording> {
        if (!isWithinFolder(path.parent_path(), name)) {
            return unexpected(msg::kSoundLinkLeadsOut, quotedWord(name));
        }
        return readRecording(path.parent_path() / name);
    };
    return parseSoundPreset(file->text(), displayName(path), materials, readSibling);
}

}  // namespace

Expected<SoundKit> parseSoundPreset(std::string_view text, const std::string& name, const MaterialRegistry* materials,
                                    const RecordingReader& readNamed) {
    return PresetReader(name, materials, readNamed).read(text);
}

Expected<std::shared_ptr<const SoundKit>> readSoundKit(const std::filesystem::path& path, const SpindlePreset& drive,
                                                       const MaterialRegistry* materials) {
    SoundKit kit;
    if (path.extension() == ".toml") {
        auto preset = readPreset(path, materials);
        if (!preset) return Unexpected{preset.error()};
        kit = std::move(*preset);
    } else {
        auto recording = readRecording(path);
        if (!recording) return Unexpected{recording.error()};
        kit.motor = RecordedPart{std::make_shared<const Recording>(std::move(*recording)), drive.freeSpeedRpm, 1.0};
    }
    return std::make_shared<const SoundKit>(std::move(kit));
}

}  // namespace tactooth
