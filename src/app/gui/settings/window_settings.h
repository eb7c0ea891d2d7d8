// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/util/expected.h"
#include "sound/voices/sound_mixer.h"
#include "tooth/model/material.h"

namespace tactooth {

/// The box of force parameters as it was set.
struct ForceSettings {
    bool fromMaterial = true;
    double spring = MaterialTable()[MaterialId::Enamel].stiffness;  ///< N/mm
    double damper = MaterialTable()[MaterialId::Enamel].damping;    ///< N*s/mm
    double scale = 1;
    double press = 1;  ///< how deep the mouse presses, mm
    double friction = MaterialTable()[MaterialId::Enamel].friction;

    bool operator==(const ForceSettings&) const = default;
};
/// Which device steers and how, as it was set.
struct DeviceSettings {
    std::string device = "mouse";       ///< see openDevice
    std::string secondDevice = "none";  ///< of the other hand, likewise
    double motionScaling = 1;           ///< mm of the hand for each mm of the tool, or kAutoScaling
    double rate = 1000;                 ///< forces a second
    bool leftHanded = false;
    double swapButton = 1;  ///< turbine or mirror; buttons are counted from 1, 0 is none
    double cutButton = 2;   ///< touch or cut
    double clutchButton = 3;
    std::string pedal;  ///< see parsePedal
    double pedalUp = 0, pedalDown = 1;
    std::string pedalKey = "Space";  ///< as Qt writes keys in English

    bool operator==(const DeviceSettings&) const = default;
};
inline constexpr double kAutoScaling = 0;                 ///< as fine as the device's room allows: see Workbench::fit
inline constexpr double kMinRate = 500, kMaxRate = 4000;  ///< Hz
inline constexpr double kMaxButton = 8;

// Ranges: a desk-top device renders 1 N/mm cleanly and 3 N/mm with luck; 2 N*s/m is what a hand does not feel as
// viscous, ten times that it does.
inline constexpr double kMaxSpring = 3;     ///< N/mm
inline constexpr double kMaxDamper = 0.02;  ///< N*s/mm
inline constexpr double kMaxForceScale = 3;
inline constexpr double kMaxFriction = 1;
inline constexpr double kMinTextScale = 1, kMaxTextScale = 2;

/// The mouth mirror in the window.
struct MirrorSettings {
    std::string number = "4";  ///< its size, as dealers count them: see mirrorSizes
    bool fogged = false;
    bool wet = false;

    bool operator==(const MirrorSettings&) const = default;
};
struct MirrorSize {
    const char* number;
    double diameter;  ///< of its head, mm
};
inline constexpr std::array<MirrorSize, 3> kMirrorSizes = {{{"2", 18}, {"4", 22}, {"5", 24}}};

/// What the window remembers from one start to the next. Empty texts stand for what the window chooses by itself.
struct WindowSettings {
    std::string geometry;  ///< of the window, as Qt packs it, in base64
    std::string docks;     ///< docks and tool bars, likewise
    std::string folder;    ///< in which the last file was opened or saved
    std::string bur;       ///< number in the catalogue
    std::string spindle;   ///< name
    bool showsTurbine = true;
    bool showsMirror = true;
    ForceSettings force;
    DeviceSettings hand;
    SoundMixer sound;
    bool headphones = false;
    std::string ownSounds;  ///< file of the recordings that are played; empty: all synthesised
    std::string language;   ///< "en" or "ja"; empty: that of the system
    bool dark = false;
    std::string recent;  ///< the teeth that were opened last, one path a line, newest first
    MirrorSettings mirror;
    bool water = true;                ///< the spray comes with the pedal
    bool suction = false;             ///< an assistant holds the tube
    double textScale = 1;             ///< of all texts, kMinTextScale..kMaxTextScale
    std::string secondView = "none";  ///< or one of kStandardViews
};

/// One setting: how it is called in the file ([table] key) and on the command line (--table-key), and what it may be.
/// This table is the only list of them.
struct WindowOption {
    using Text = std::string& (*)(WindowSettings&);
    using Switch = bool& (*)(WindowSettings&);
    using Number = double& (*)(WindowSettings&);

    const char* table;
    const char* key;
    std::variant<Text, Switch, Number> value;
    double highest;              ///< of a number
    const char* help;            ///< null: of no use on a command line
    double lowest = 0;           ///< of a number
    const char* zero = nullptr;  ///< a word that stands for 0, which may be below the lowest number
};
[[nodiscard]] std::span<const WindowOption> windowOptions();

/// "--force-spring"
[[nodiscard]] std::string flagOf(const WindowOption& option);

/// Sets one setting from the text of a command line. Fails with a sentence that names the flag.
[[nodiscard]] Expected<void> setWindowOption(WindowSettings& settings, const WindowOption& option,
                                             const std::string& text);

/// `window.toml` in the user's folder for settings.
[[nodiscard]] std::filesystem::path windowSettingsFile();

/// What was read of a file.
struct ParsedSettings : WindowSettings {
    std::vector<Error>
        refused;  ///< for each value that cannot be meant, and has its default: one sentence with its line
};

/// Value by value: one that cannot be meant costs only itself. Fails with one sentence that names the line if the text
/// is not TOML. Keys that are not known belong to another version and are passed over. `name`: of the file, for the
/// sentences.
[[nodiscard]] Expected<ParsedSettings> parseWindowSettings(std::string_view text, std::string_view name);
[[nodiscard]] std::string windowSettingsText(const WindowSettings& settings);

/// The settings of the last time; the defaults if there is no file yet.
[[nodiscard]] Expected<ParsedSettings> readWindowSettings(const std::filesystem::path& file);
/// Puts a file aside that cannot be read, as "window.toml.bad" in the place of an older one of that name, before a new
/// one is written. Fails with a few words of the system.
[[nodiscard]] Expected<std::filesystem::path> backUpInvalidSettings(const std::filesystem::path& file);
/// Puts the defaults in the place of devices that no Tactooth knows, so that a slip of the pen is not kept for ever.
/// One sentence that says so and names the file; empty if all are known.
[[nodiscard]] std::optional<Error> resetUnknownDevices(DeviceSettings& hand, const std::filesystem::path& file);
/// Makes the folder if need be.
[[nodiscard]] Expected<void> writeWindowSettings(const WindowSettings& settings, const std::filesystem::path& file);

}  // namespace tactooth
