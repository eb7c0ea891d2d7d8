// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/quiet_audio_libraries.h"

#include <dlfcn.h>

#include <cstdlib>

namespace tactooth {

namespace {

// From ALSA's <alsa/error.h>; declared here since the library is only looked up at run time.
using AlsaErrorHandler = void (*)(const char* file, int line, const char* function, int error, const char* format, ...);

void ignoreAlsaError(const char*, int, const char*, int, const char*, ...) {}

}  // namespace

void quietAudioLibraries() {
    constexpr int kKeepUsersOwn = 0;
    setenv("ALSOFT_LOGLEVEL", "0", kKeepUsersOwn);
    silenceAlsaMessages();
}

void silenceAlsaMessages() {
    // The handle stays open: the handler lives in the loaded library, which OpenAL shares.
    static void* const alsa = dlopen("libasound.so.2", RTLD_LAZY | RTLD_LOCAL);
    if (alsa == nullptr) return;
    using SetHandler = int (*)(AlsaErrorHandler);
    if (const auto setHandler = reinterpret_cast<SetHandler>(dlsym(alsa, "snd_lib_error_set_handler"))) {
        setHandler(&ignoreAlsaError);
    }
}

}  // namespace tactooth
