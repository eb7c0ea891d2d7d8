// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#include "sound/output/sound_system_search.h"

#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace tactooth {

namespace {

namespace fs = std::filesystem;

bool isThere(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

template <class Condition>
bool holds(const fs::path& folder, const Condition& condition) {
    std::error_code error;
    const fs::directory_iterator entries(folder, error);
    return std::any_of(begin(entries), end(entries),
                       [&](const fs::directory_entry& entry) { return condition(entry.path()); });
}

auto beginsWith(std::string_view beginning) {
    return [beginning](const fs::path& path) { return path.filename().string().starts_with(beginning); };
}

std::string valueOf(const char* name, const VariableLookup& variable) {
    const char* value = variable(name);
    return value == nullptr ? std::string() : std::string(value);
}

/// Whether the user has configured OpenAL, or a server that may be anywhere.
bool isChosen(const VariableLookup& variable) {
    constexpr const char* kChoices[] = {"ALSOFT_DRIVERS", "PULSE_SERVER", "JACK_DEFAULT_SERVER", "AUDIODEV"};
    const auto isSet = [&](const char* name) { return !valueOf(name, variable).empty(); };
    if (std::any_of(std::begin(kChoices), std::end(kChoices), isSet)) return true;
    // The display of another machine is also the address of its sound server.
    const std::string display = valueOf("DISPLAY", variable);
    return !display.empty() && display.front() != ':';
}

/// The socket of PulseAudio, or of PipeWire in its place.
bool hasServer(const fs::path& root, const fs::path& home, const VariableLookup& variable) {
    const fs::path user = root / "run/user" / std::to_string(getuid());
    if (isThere(user / "pulse/native") || isThere(root / "run/pulse/native")) return true;
    const fs::path runtime = valueOf("XDG_RUNTIME_DIR", variable), own = valueOf("PULSE_RUNTIME_PATH", variable);
    if (!runtime.empty() && isThere(runtime / "pulse/native")) return true;
    if (!own.empty() && isThere(own / "native")) return true;
    // Where a login has no runtime folder: beside the server's settings.
    return !home.empty() &&
           holds(home / ".config/pulse", [](const fs::path& folder) { return isThere(folder / "native"); });
}

}  // namespace

bool hasSoundSystem(const fs::path& root, const VariableLookup& variable) {
#ifdef __linux__
    const fs::path home = valueOf("HOME", variable);
    const bool hasCard = holds(root / "dev/snd", beginsWith("pcm")) || isThere(root / "dev/dsp");
    const bool isSetUp = isThere(root / "etc/asound.conf") || (!home.empty() && isThere(home / ".asoundrc"));
    const bool hasJack = holds(root / "dev/shm", beginsWith("jack_default"));  // not the remains of its clients
    return isChosen(variable) || hasCard || isSetUp || hasJack || hasServer(root, home, variable);
#else
    return true;
#endif
}

}  // namespace tactooth
