// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sound_command.h"

#include "app/cli/exit_code.h"
#include "app/cli/output.h"
#include "app/common/spectrogram_image.h"
#include "geometry/atomic_file.h"
#include "geometry/file_set.h"
#include "session/sound_preset.h"
#include "session/sound_profile.h"
#include "sound/audio_libraries.h"
#include "sound/wav_file.h"

namespace tactooth {
namespace {

const SpindlePreset& driveNamed(const std::string& name) {
    return spindlePresets()[name == "electric" ? 1 : name == "low-speed" ? 2 : 0];
}

Expected<void> write(const SoundOptions& options, const StereoSamples& samples) {
    const auto bytes = wavBytes(samples);
    if (!bytes) return Unexpected{bytes.error()};
    auto wav = AtomicFile::create(options.out);
    if (!wav) return Unexpected{wav.error()};
    wav->write(std::span<const std::byte>(*bytes));
    if (!options.spectrogram.empty()) {
        if (auto done = writeSpectrogram(options.spectrogram, samples); !done) return done;
    }
    return wav->commit();
}

}  // namespace

int runSound(const SoundOptions& options) {
    FileSet files;
    for (const auto& input : {options.profile, options.sounds}) files.reads(input);
    for (const auto& output : {options.out, options.spectrogram}) {
        if (const auto opened = files.open(output); !opened) return refuse(opened.error());
    }
    auto track = readSoundProfile(options.profile, driveNamed(options.drive));
    if (!track) return refuse(track.error());
    for (TimedSoundState& moment : *track) {
        moment.state.blades = options.blades;
        if (options.water) moment.state.water = moment.state.pedal;
        if (options.suction) moment.state.suction = 1;
    }
    OfflineSettings settings;
    if (!options.sounds.empty()) {
        const auto kit = readSoundKit(options.sounds, driveNamed(options.drive));
        if (!kit) return refuse(kit.error());
        settings.kit = *kit;
    }
    prepareAudioLibraries();
    settings.headphones = options.headphones;
    const auto samples = renderOffline(*track, track->back().time, settings);
    if (!samples) return refuse(samples.error());
    if (const auto done = write(options, *samples); !done) return refuse(done.error());
    if (const auto done = files.commit(); !done) return refuse(done.error());
    say("{:.3f} s of sound written to {}\n", track->back().time, options.out.string());
    if (!options.spectrogram.empty()) say("its spectrum over time is in {}\n", options.spectrogram.string());
    return kExitOk;
}

}  // namespace tactooth
