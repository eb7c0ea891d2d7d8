// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/audio_libraries.h"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "sound/files/sound_format.h"

namespace tactooth {

namespace {

constexpr int kKeepUsersOwn = 0;  // for setenv

// From ALSA's <alsa/error.h>; declared here since the library is loaded at run time only.
using AlsaErrorHandler = void (*)(const char* file, int line, const char* function, int error, const char* format, ...);

void ignoreAlsaError(const char*, int, const char*, int, const char*, ...) {}

// OpenAL Soft reads the length of its periods from configuration files only (it ignores the attribute ALC_REFRESH), and
// $ALSOFT_CONF names one more such file. Ours is in memory, so that nothing is left on the disk.
void askForShortPeriods() {
    if (std::getenv("ALSOFT_CONF") != nullptr) return;
    const std::string rate = std::to_string(kSoundRate), period = std::to_string(kDevicePeriod);
    // rt-prio: the mixer has priority over other programs where the system allows it. A sound server may move the
    // stream when another device becomes the default, such as headphones.
    const std::string settings = "[general]\nfrequency = " + rate + "\nperiod_size = " + period +
                                 "\nperiods = 2\nrt-prio = 1\n[pulse]\nallow-moves = true\n";
    const int file = memfd_create("alsoft.conf", MFD_CLOEXEC);
    if (file < 0) return;
    if (write(file, settings.data(), settings.size()) != static_cast<ssize_t>(settings.size())) {
        close(file);
        return;
    }
    // A file that is opened by name is read from its beginning; the descriptor stays open while the process lives. The
    // name contains the process number, since child processes inherit the variable.
    const std::string name = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(file);
    setenv("ALSOFT_CONF", name.c_str(), kKeepUsersOwn);
}

}  // namespace

void prepareAudioLibraries() {
    setenv("ALSOFT_LOGLEVEL", "0", kKeepUsersOwn);
    askForShortPeriods();
    silenceAlsaMessages();
}

void silenceAlsaMessages() {
    // The handle stays open: the handler is part of the loaded library, which OpenAL shares.
    static void* const alsa = dlopen("libasound.so.2", RTLD_LAZY | RTLD_LOCAL);
    if (alsa == nullptr) return;
    using SetHandler = int (*)(AlsaErrorHandler);
    if (const auto setHandler = reinterpret_cast<SetHandler>(dlsym(alsa, "snd_lib_error_set_handler"))) {
        setHandler(&ignoreAlsaError);
    }
}

}  // namespace tactooth
