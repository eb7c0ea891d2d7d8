// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// How long the sound of one block takes to make, against the 2.5 ms that it lasts. One CSV line for each scene.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "session/audio/material_sound.h"
#include "sound/files/sound_format.h"
#include "sound/voices/soundscape.h"

namespace tactooth {
namespace {

// Processor time of this thread, us: what else the machine does meanwhile does not count.
double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

void measure(const char* scene, const DrillSoundState& state) {
    constexpr int kBlocks = 24000;  // a minute of sound
    Soundscape soundscape;
    SoundBlock block;
    std::vector<double> micros;
    double loudest = 0.0;  // keeps the samples from being optimised away
    for (int i = 0; i < kBlocks; ++i) {
        const double start = now();
        soundscape.render(state, block);
        micros.push_back(now() - start);
        for (const float sample : block[0]) loudest = std::max(loudest, static_cast<double>(sample));
    }
    double total = 0.0;
    for (const double value : micros) total += value;
    std::sort(micros.begin(), micros.end());
    const double blockMicros = 1e6 * kSoundBlock / kSoundRate;
    std::printf("%s,%.2f,%.2f,%.2f,%.3f,%.3f\n", scene, micros[kBlocks / 2], micros[kBlocks * 99 / 100], micros.back(),
                100.0 * total / kBlocks / blockMicros, loudest);
}

}  // namespace
}  // namespace tactooth

int main() {
    using namespace tactooth;
    DrillSoundState still, coasting, cutting;
    coasting.speedRpm = 100000.0;  // all tones audible
    cutting.speedRpm = 300000.0;
    cutting.pedal = 1.0;
    cutting.load = 0.25;
    cutting.removalPower = 10.0;
    cutting.material = characterOf(MaterialTable(), builtinMaterials().withRole(MaterialRole::Enamel));
    std::puts("scene,p50_us,p99_us,max_us,core_percent,peak");
    measure("standstill", still);
    measure("coasting", coasting);
    measure("cutting", cutting);
    cutting.water = cutting.suction = 1.0;
    measure("cutting with spray and suction", cutting);
}
