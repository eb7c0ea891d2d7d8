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
#include "geometry/util/message.h"
#include "session/hands/mouse_manipulator.h"
#include "sound/voices/sound_mixer.h"
#include "tooth/model/material_registry.h"

namespace tactooth {

/// The physical values of built-in enamel.
[[nodiscard]] inline const Material& enamelNumbers() {
    return builtinMaterials()[builtinMaterials().withRole(MaterialRole::Enamel)].numbers;
}

/// What ends a press of the mouse (PressMode).
inline constexpr const char* kMouseToDepth = "depth";
inline constexpr const char* kMouseByForce = "force";

/// The settings of the force panel.
struct ForceSettings {
    bool fromMaterial = true;
    double spring = enamelNumbers().stiffness;  ///< N/mm
    double damper = enamelNumbers().damping;    ///< N*s/mm
    double scale = 1;
    double press = MouseManipulator::kUsualPressDepth;  ///< press depth of the mouse, mm
    std::string mouse = kMouseToDepth;         ///< what ends a press of the mouse: kMouseToDepth or kMouseByForce
    double depth = DepthControl::kUsualDepth;  ///< at which kMouseToDepth ends, mm
    bool flatFloor = false;                    ///< the depth counts from one plane
    bool depthStop = false;                    ///< a device stops at that depth, too
    bool guide = false;                        ///< a device feels the walls of the target
    double friction = enamelNumbers().friction;

    bool operator==(const ForceSettings&) const = default;
};
/// The settings of the device panel.
struct DeviceSettings {
    std::string device = "mouse";       ///< see openDevice
    std::string secondDevice = "none";  ///< of the other hand, likewise
    double motionScaling = 1;           ///< mm of the hand for each mm of the tool, or kAutoScaling
    double rate = 1000;                 ///< of the servo, Hz
    bool leftHanded = false;
    double swapButton = 1;  ///< swaps turbine and mirror; buttons count from 1, 0 is none
    double cutButton = 2;   ///< touch or cut
    double clutchButton = 3;
    std::string pedal;  ///< see parsePedal
    double pedalUp = 0, pedalDown = 1;
    std::string pedalKey = "Space";  ///< Qt's English name of the key

    bool operator==(const DeviceSettings&) const = default;
};
inline constexpr double kAutoScaling = 0;                 ///< motion scaling by SessionModel::fit
inline constexpr double kMinRate = 500, kMaxRate = 4000;  ///< Hz
inline constexpr double kMaxButton = 8;

// Ranges: a desk-top device renders 1 N/mm cleanly and 3 N/mm at best. A hand does not feel 2 N*s/m as viscous; it
// feels ten times that.
inline constexpr double kMaxSpring = 3;     ///< N/mm
inline constexpr double kMaxDamper = 0.02;  ///< N*s/mm
inline constexpr double kMaxForceScale = 3;
inline constexpr double kMaxFriction = 1;
inline constexpr double kMinTextScale = 1, kMaxTextScale = 2;
inline constexpr double kMinRecordingGigabytes = 0.1, kMaxRecordingGigabytes = 1000;

/// The settings of the mouth mirror.
struct MirrorSettings {
    std::string number = "4";  ///< its size number, see kMirrorSizes
    bool fogged = false;
    bool wet = false;
    bool dims = true;  ///< breath and dirt come by themselves

    bool operator==(const MirrorSettings&) const = default;
};
struct MirrorSize {
    const char* number;
    double diameter;  ///< of its head, mm
};
inline constexpr std::array<MirrorSize, 3> kMirrorSizes = {{{"2", 18}, {"4", 22}, {"5", 24}}};

/// What helps to find one's way in the picture.
struct ViewAids {
    bool glass = true;        ///< handles and the shank turn to glass where they hide the bur's head
    bool scaleBar = true;     ///< in mm
    bool letters = true;      ///< of the directions, at the picture's edge
    bool cube = true;         ///< that shows and chooses the side from which one looks
    bool magnifier = false;   ///< of the bur's head
    bool softTissues = true;  ///< cheeks, lips and tongue around the whole mouth

    bool operator==(const ViewAids&) const = default;
};

/// The settings that the window keeps from one start to the next. An empty text means the default of the window.
struct WindowSettings {
    std::string geometry;       ///< of the window, in Qt's format, base64
    std::string docks;          ///< state of docks and tool bars, likewise
    std::string folder;         ///< of the last file that was opened or saved
    std::string bur = "4";      ///< number in the catalogue; usually round, 1.4 mm: a dentist opens a fissure with it
    std::string favouriteBurs;  ///< numbers in the catalogue: "4, 245"
    std::string spindle;        ///< name
    bool showsTurbine = true;
    bool showsAim = true;
    bool showsMirror = true;
    ForceSettings force;
    DeviceSettings hand;
    SoundMixer sound;
    bool headphones = false;
    bool room = true;       ///< the surgery is heard
    std::string ownSounds;  ///< file of the user's sounds; empty: synthesised sounds
    std::string language;   ///< "en" or "ja"; empty: the language of the system
    bool welcome = true;    ///< the page with exercises and recent work comes at each start
    bool dark = false;
    std::string recent;            ///< what was opened last, RecentFile::text, one a line, newest first
    std::string notation = "fdi";  ///< of the tooth chart: "fdi", "universal" or "palmer"
    MirrorSettings mirror;
    bool water = true;                ///< water flows with the pedal
    bool suction = false;             ///< an assistant holds the suction tube
    double textScale = 1;             ///< of all fonts, kMinTextScale..kMaxTextScale
    std::string secondView = "none";  ///< or one of kStandardViews
    bool recordsSessions = true;      ///< keeps a recording of each session
    double recordingGigabytes = 2;    ///< of all recordings together
    ViewAids aids;
    bool sideBySide = false;  ///< a second recording is shown beside the first, not as a ghost in it
    std::string ownKeys;      ///< see KeyMap::ownText
};

/// The pages of the dialog with the settings.
enum class SettingsPage { None, Appearance, View, Instruments, Force, Hand, Sound, Recording };

/// One setting: its name in the file ([table] key) and on the command line (--table-key), what it does, and its range.
/// windowOptions() is the only list of them. The default is the value in WindowSettings().
struct WindowOption {
    using Text = std::string& (*)(WindowSettings&);
    using Switch = bool& (*)(WindowSettings&);
    using Number = double& (*)(WindowSettings&);

    const char* table;
    const char* key;
    std::variant<Text, Switch, Number> value;
    const MessageText* help = nullptr;  ///< what it does, without a full stop; null: only the window itself sets it
    SettingsPage page = SettingsPage::None;  ///< of the dialog with the settings
    double lowest = 0;                       ///< of a number
    double highest = 0;                      ///< of a number
    const char* zero = nullptr;              ///< a word for 0, which may be below `lowest`
    const char* words = nullptr;             ///< the values that a text may have ("en, ja"); null: any
    const char* unit = nullptr;              ///< of a number
    const MessageText* empty = nullptr;      ///< what an empty text means
    bool isCount = false;                    ///< a number without decimals
    bool hasFlag = true;                     ///< on the command line, if it has a help
};
/// Whether a text is a value of the option: one of its words, or empty, which is the default.
[[nodiscard]] bool takesText(const WindowOption& option, std::string_view text);
[[nodiscard]] std::span<const WindowOption> windowOptions();

/// "--force-spring"
[[nodiscard]] std::string flagOf(const WindowOption& option);
/// The help with range, values, unit and default, in English: for the command line.
[[nodiscard]] std::string flagHelp(const WindowOption& option);

/// Sets one setting from the text of a command line. Fails with a sentence that names the flag.
[[nodiscard]] Expected<void> setWindowOption(WindowSettings& settings, const WindowOption& option,
                                             const std::string& text);

/// `window.toml` in the user's folder for settings.
[[nodiscard]] std::filesystem::path windowSettingsFile();

/// The settings of a file.
struct ParsedSettings : WindowSettings {
    std::vector<Error> refused;  ///< one sentence with its line for each invalid value, which keeps its default
};

/// Reads value by value: an invalid value keeps its default, the others count. Fails with one sentence that names the
/// line if the text is not TOML. Ignores unknown keys, which belong to another version. `name`: of the file, for the
/// sentences.
[[nodiscard]] Expected<ParsedSettings> parseWindowSettings(std::string_view text, std::string_view name);
[[nodiscard]] std::string windowSettingsText(const WindowSettings& settings);

/// The settings in the file; the defaults if there is no file yet.
[[nodiscard]] Expected<ParsedSettings> readWindowSettings(const std::filesystem::path& file);
/// Renames an unreadable file to "window.toml.bad" and replaces an older one of that name. Fails with a few words of
/// the system.
[[nodiscard]] Expected<std::filesystem::path> backUpInvalidSettings(const std::filesystem::path& file);
/// Replaces unknown devices by the defaults, so that a typing error does not stay for ever. Returns one sentence that
/// names the file; nothing if all are known.
[[nodiscard]] std::optional<Error> resetUnknownDevices(DeviceSettings& hand, const std::filesystem::path& file);
/// Makes the folder if it is missing.
[[nodiscard]] Expected<void> writeWindowSettings(const WindowSettings& settings, const std::filesystem::path& file);

}  // namespace tactooth
