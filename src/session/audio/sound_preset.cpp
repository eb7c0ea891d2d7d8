// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_preset.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/files/file_bytes.h"
#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "session/cases/case_store.h"
#include "session/io/limited_toml.h"
#include "session/io/messages.h"
#include "sound/files/recording_file.h"

namespace tactooth {
namespace {

constexpr double kSlowest = 100, kFastest = 1e6;  // rev/min at which somebody may have recorded a bur
constexpr double kSoftest = -40, kLoudest = 20;   // dB

using Part = std::optional<RecordedPart>;

/// Takes the parts of a preset over into a kit, until something is wrong.
class PresetReader {
public:
    PresetReader(std::string name, const RecordingReader& readNamed) : name_(std::move(name)), readNamed_(readNamed) {}

    Expected<SoundKit> read(const toml::table& root) {
        for (auto&& [key, node] : root) {
            const bool isRead = key.str() == "cutting" ? readCutting(node) : readNamedPart(key, node);
            if (!isRead) return Unexpected{error_};
        }
        return kit_;
    }

private:
    bool readNamedPart(const toml::key& key, const toml::node& node) {
        if (key.str() == "motor") return readPart(key.str(), node, true, kit_.motor);
        if (key.str() == "water") return readPart(key.str(), node, false, kit_.water);
        if (key.str() == "suction") return readPart(key.str(), node, false, kit_.suction);
        return fail(key.source(), {msg::kSoundPartUnknown, quotedWord(key.str()), msg::kSoundParts});
    }

    bool readCutting(const toml::node& node) {
        const toml::table* materials = node.as_table();
        if (materials == nullptr) return fail(node.source(), msg::kCuttingNeedsMaterial);
        const auto names = soundMaterialNames();
        for (auto&& [key, part] : *materials) {
            const auto found = std::find(names.begin(), names.end(), key.str());
            if (found == names.end()) {
                return fail(key.source(), {msg::kSoundMaterialUnknown, quotedWord(key.str())});
            }
            if (!readPart(key.str(), part, false, kit_.cutting[static_cast<std::size_t>(found - names.begin())]))
                return false;
        }
        return true;
    }

    bool readPart(std::string_view part, const toml::node& node, bool needsSpeed, Part& into) {
        const toml::table* table = node.as_table();
        if (table == nullptr) return fail(node.source(), {msg::kSoundPartNotTable, quotedWord(part), msg::kSoundKeys});
        RecordedPart read;
        for (auto&& [key, value] : *table) {
            if (!readKey(key, value, read)) return false;
        }
        const toml::node* file = table->get("file");
        if (file == nullptr) return fail(node.source(), {msg::kSoundPartNoRecording, quotedWord(part)});
        if (needsSpeed && read.speedRpm == 0) return fail(node.source(), {msg::kSoundPartNoSpeed, quotedWord(part)});
        return readFile(*file, read) && (into = std::move(read), true);
    }

    bool readKey(const toml::key& key, const toml::node& node, RecordedPart& part) {
        double decibel = 0;
        if (key.str() == "file") return node.is_string() || fail(node.source(), msg::kSoundFileNotText);
        if (key.str() == "speed_rpm") return readNumber(key.str(), node, kSlowest, kFastest, part.speedRpm);
        if (key.str() != "gain_db") {
            return fail(key.source(), {msg::kUnknownKey, msg::kARecording, quotedWord(key.str()), msg::kSoundKeys});
        }
        if (!readNumber(key.str(), node, kSoftest, kLoudest, decibel)) return false;
        part.gain = std::pow(10, decibel / 20);
        return true;
    }

    bool readNumber(std::string_view key, const toml::node& node, double low, double high, double& value) {
        const std::optional<double> number = node.is_number() ? node.value<double>() : std::nullopt;
        if (!number || !(*number >= low && *number <= high)) {
            return fail(node.source(), {msg::kKeyTakesNumber, quotedWord(key), std::lround(low), std::lround(high)});
        }
        value = *number;
        return true;
    }

    bool readFile(const toml::node& file, RecordedPart& part) {
        const auto entry = *file.value<std::string>();
        if (!isSafeEntry(entry)) {
            return fail(file.source(), {msg::kMustLieBeside, quotedWord(entry)});
        }
        auto recording = readNamed_(entry);
        if (!recording) return fail(file.source(), recording.error());
        part.recording = std::make_shared<const Recording>(std::move(*recording));
        return true;
    }

    bool fail(const toml::source_region& where, const Message& what) {
        error_ = {msg::kAtLine, name_, where.begin.line, what};
        return false;
    }

    std::string name_;
    const RecordingReader& readNamed_;
    SoundKit kit_;
    Error error_;
};

Expected<SoundKit> readPreset(const std::filesystem::path& path) {
    const Expected<FileBytes> file = readFile(path, kTomlLimits.bytes);
    if (!file) return Unexpected{file.error()};
    const auto readSibling = [&](const std::string& name) -> Expected<Recording> {
        if (!isWithinFolder(path.parent_path(), name)) {
            return unexpected(msg::kSoundLinkLeadsOut, quotedWord(name));
        }
        return readRecording(path.parent_path() / name);
    };
    return parseSoundPreset(file->text(), displayName(path), readSibling);
}

}  // namespace

Expected<SoundKit> parseSoundPreset(std::string_view text, const std::string& name, const RecordingReader& readNamed) {
    const Expected<toml::table> root = parseToml(text, name);
    if (!root) return Unexpected{root.error()};
    return PresetReader(name, readNamed).read(*root);
}

Expected<std::shared_ptr<const SoundKit>> readSoundKit(const std::filesystem::path& path, const SpindlePreset& drive) {
    SoundKit kit;
    if (path.extension() == ".toml") {
        auto preset = readPreset(path);
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
