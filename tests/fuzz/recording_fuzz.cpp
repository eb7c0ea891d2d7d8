// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
// Whatever the bytes: a recording is refused with a sentence, or is a loop that plays finite samples.
#include <cmath>

#include "fuzz/fuzz_target.h"
#include "sound/files/recording_file.h"
#include "sound/voices/loop_player.h"

// libsndfile 1.2 gives up on a damaged Ogg head without giving back what libvorbis took. Read by the leak sanitizer.
extern "C" const char* __lsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer's name
extern "C" const char* __lsan_default_suppressions() { return "leak:vorbis_info_init\n"; }

namespace tactooth::test {
namespace {

bool accepts(std::span<const std::byte> bytes) {
    const auto recording = parseRecording(bytes, "fuzz");
    if (!recording) return requireSentence(recording.error()), false;
    LoopPlayer player;
    for (int i = 0; i < 2000; ++i)
        require(std::isfinite(player.next(*recording, 0.01 * (i % 800))), "samples are finite");
    return true;
}

const AddFuzzTarget added({"recording", accepts});

}  // namespace
}  // namespace tactooth::test
