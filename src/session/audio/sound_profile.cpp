// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "session/audio/sound_profile.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "geometry/util/messages.h"
#include "geometry/util/number_text.h"
#include "session/audio/material_sound.h"
#include "session/audio/tick_sound.h"
#include "session/io/csv_table.h"
#include "session/io/messages.h"

namespace tactooth {
namespace {

constexpr std::array<std::string_view, 3> kNumbers = {"t", "speed_rpm", "power"};
constexpr std::array<std::string_view, 1> kWords = {"material"};
constexpr std::string_view kNothing = "none";

constexpr double kMaxSpeed = 1e6;        // rev/min: twice the fastest turbine on sale
constexpr double kMaxPower = 1000;       // W: the strongest dental drive gives 60
constexpr double kImpactSpeed = 20;      // mm/s: a careful hand
constexpr double kSlowestSpeedRpm = 60;  // rev/min; below it torque = power / speed is meaningless

/// Torque on the bur as a share of the drive's stall torque.
double loadShare(double speedRpm, double watt, const SpindlePreset& drive) {
    constexpr double kMilli = 1000;  // W over rad/s is N*m
    const double radPerSecond = std::max(speedRpm, kSlowestSpeedRpm) * std::numbers::pi / 30;
    return std::min(1.0, kMilli * watt / radPerSecond / drive.stallTorque);
}

DrillSoundState stateAt(double speedRpm, double watt, const SpindlePreset& drive) {
    DrillSoundState state;
    state.motor = motorOf(drive);
    state.speedRpm = speedRpm;
    state.freeSpeedRpm = drive.freeSpeedRpm;
    state.removalPower = watt;
    state.load = loadShare(speedRpm, watt, drive);
    state.pedal = std::min(1.0, (speedRpm + state.load * drive.droopRpm) / drive.freeSpeedRpm);
    return state;
}

std::optional<Message> faultIn(const CsvTable& table, std::size_t row, const MaterialRegistry& materials) {
    const double time = table.at(row, 0), speed = table.at(row, 1), power = table.at(row, 2);
    const std::string& material = table.wordAt(row, 0);
    if (row > 0 && time < table.at(row - 1, 0)) return msg::kProfileBackwards;
    if (speed < 0 || speed > kMaxSpeed) return Message(msg::kProfileSpeed, numberText(speed));
    if (power < 0 || power > kMaxPower) return Message(msg::kProfilePower, numberText(power));
    if (material != kNothing && !materials.find(material))
        return Message(msg::kProfileMaterial, quotedWord(material), materials.names());
    return std::nullopt;
}

/// A row without a material gets that of the next row that has one, which is what sounds between the two.
void nameMaterials(const CsvTable& table, const MaterialTable& materials, std::vector<TimedSoundState>& track) {
    SoundCharacter coming;
    for (std::size_t row = table.rows(); row-- > 0;) {
        const std::string& name = table.wordAt(row, 0);
        if (name != kNothing) coming = characterOf(materials, materials.registry().find(name).value());
        track[row].state.material = coming;
    }
}

Expected<std::vector<TimedSoundState>> soundsOf(const Expected<CsvTable>& table, const SpindlePreset& drive,
                                                const MaterialTable& materials) {
    if (!table) return Unexpected{table.error()};
    std::vector<TimedSoundState> track;
    track.reserve(table->rows());
    std::uint32_t contactOnsets = 0;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        if (const auto fault = faultIn(*table, row, materials.registry()))
            return unexpected(msg::kNamedSentence, table->where(row), *fault);
        const bool cuts = table->wordAt(row, 0) != kNothing;
        if (cuts && row > 0 && table->wordAt(row - 1, 0) == kNothing) ++contactOnsets;
        DrillSoundState state = stateAt(table->at(row, 1), cuts ? table->at(row, 2) : 0, drive);
        state.contactCount = contactOnsets;
        state.contactSpeed = kImpactSpeed;
        track.push_back({table->at(row, 0) - table->at(0, 0), state, {}});
    }
    if (track.back().time <= 0) {
        return unexpected(msg::kProfileNoTime, table->where(table->rows() - 1));
    }
    if (track.back().time > kMaxSoundLength) {
        return unexpected(msg::kProfileTooLong, table->where(table->rows() - 1));
    }
    nameMaterials(*table, materials, track);
    return track;
}

}  // namespace

Expected<std::vector<TimedSoundState>> readSoundProfile(const std::filesystem::path& path, const SpindlePreset& drive,
                                                        const MaterialTable& materials) {
    return soundsOf(readCsv(path, kNumbers, kWords), drive, materials);
}

Expected<std::vector<TimedSoundState>> parseSoundProfile(std::string_view text, std::string_view name,
                                                         const SpindlePreset& drive, const MaterialTable& materials) {
    return soundsOf(parseCsv(text, name, kNumbers, kWords), drive, materials);
}

}  // namespace tactooth
