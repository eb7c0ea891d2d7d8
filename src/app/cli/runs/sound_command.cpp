// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runs/sound_command.h"

#include <fmt/core.h>

#include <optional>

#include "app/cli/terminal/output.h"
#include "app/common/exit_code.h"
#include "app/common/images/spectrogram_image.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/file_bytes.h"
#include "geometry/files/file_transaction.h"
#include "session/audio/sound_preset.h"
#include "session/audio/sound_profile.h"
#include "session/io/material_file.h"
#include "sound/files/wav_file.h"
#include "sound/output/audio_libraries.h"

namespace tactooth {
namespace {

const SpindlePreset& driveNamed(const std::string& name) {
    return spindlePresets()[name == "electric" ? 1 : name == "low-speed" ? 2 : 0];
}

/// Writes both files, or none. The samples go to the file as they are made: an hour of samples would fill the memory.
Expected<void> write(const SoundOptions& options, std::span<const TimedSoundState> track,
                     const OfflineSettings& settings) {
    const double seconds = track.back().time;
    const std::size_t frames = framesOf(seconds);
    auto wav = WavWriter::create(options.out, frames);
    if (!wav) return Unexpected{wav.error()};
    std::optional<SpectrogramBuilder> spectrogram;
    if (!options.spectrogram.empty()) spectrogram.emplace(frames, kSpectrogramTimes);
    auto rendered = renderInChunks(track, seconds, settings, [&](std::span<const float> stereo) {
        wav->write(stereo);
        if (spectrogram) spectrogram->add(stereo);
    });
    if (!rendered) return rendered;
    if (spectrogram) {
        if (auto done = writeSpectrogram(options.spectrogram, spectrogram->finish(), seconds); !done) return done;
    }
    return wav->commit();
}

}  // namespace

int runSound(const SoundOptions& options) {
    FileTransaction files;
    for (const auto& input : {options.profile, options.sounds, options.materials}) files.reads(input);
    for (const auto& output : {options.out, options.spectrogram}) {
        if (const auto opened = files.open(output); !opened) return reportError(opened.error());
    }
    const auto given = materialsFrom(options.materials);
    if (!given) return reportError(given.error());
    const MaterialRegistry& materials = withDentalMaterials(**given);
    auto track = readSoundProfile(options.profile, driveNamed(options.drive), MaterialTable(materials));
    if (!track) return reportError(track.error());
    for (TimedSoundState& moment : *track) {
        moment.state.blades = options.blades;
        if (options.water) moment.state.water = moment.state.pedal;
        if (options.suction) moment.state.suction = 1;
    }
    OfflineSettings settings;
    if (!options.sounds.empty()) {
        const auto kit = readSoundKit(options.sounds, driveNamed(options.drive), &materials);
        if (!kit) return reportError(kit.error());
        settings.kit = *kit;
    }
    prepareAudioLibraries();
    settings.headphones = options.headphones;
    settings.room = options.room;
    if (const auto done = write(options, *track, settings); !done) return reportError(done.error());
    if (const auto done = files.commit(); !done) return reportError(done.error());
    print("{:.3f} s of sound written to {}\n", track->back().time, displayName(options.out));
    if (!options.spectrogram.empty()) print("its spectrum over time is in {}\n", displayName(options.spectrogram));
    return kExitOk;
}

}  // namespace tactooth
