// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what the window remembers.
#include <algorithm>
#include <array>

#include "app/gui/settings/messages.h"
#include "app/gui/settings/window_settings.h"
#include "app/gui/text/messages.h"
#include "devices/base/workspace_fit.h"
#include "geometry/util/number_text.h"
#include "session/hands/mouse_manipulator.h"

namespace tactooth {
namespace {

using S = WindowSettings;
using Text = WindowOption::Text;
using Switch = WindowOption::Switch;
using Number = WindowOption::Number;

constexpr std::array kOptions = {
    WindowOption{.table = "window", .key = "geometry", .value = Text([](S& s) -> std::string& { return s.geometry; })},
    WindowOption{.table = "window", .key = "docks", .value = Text([](S& s) -> std::string& { return s.docks; })},
    WindowOption{.table = "window",
                 .key = "folder",
                 .value = Text([](S& s) -> std::string& { return s.folder; }),
                 .help = &msg::kOptionWindowFolder,
                 .page = SettingsPage::Appearance},
    WindowOption{.table = "window", .key = "recent", .value = Text([](S& s) -> std::string& { return s.recent; })},
    WindowOption{.table = "window",
                 .key = "notation",
                 .value = Text([](S& s) -> std::string& { return s.notation; }),
                 .help = &msg::kOptionWindowNotation,
                 .page = SettingsPage::Appearance,
                 .words = "fdi, universal, palmer"},
    WindowOption{.table = "window",
                 .key = "language",
                 .value = Text([](S& s) -> std::string& { return s.language; }),
                 .help = &msg::kOptionWindowLanguage,
                 .page = SettingsPage::Appearance,
                 .words = "en, ja",
                 .empty = &msg::kOptionAsTheSystem},
    WindowOption{.table = "window",
                 .key = "welcome",
                 .value = Switch([](S& s) -> bool& { return s.welcome; }),
                 .help = &msg::kOptionWindowWelcome,
                 .page = SettingsPage::Appearance},
    WindowOption{.table = "window",
                 .key = "dark",
                 .value = Switch([](S& s) -> bool& { return s.dark; }),
                 .help = &msg::kOptionWindowDark,
                 .page = SettingsPage::Appearance},
    WindowOption{.table = "window",
                 .key = "text",
                 .value = Number([](S& s) -> double& { return s.textScale; }),
                 .help = &msg::kOptionWindowText,
                 .page = SettingsPage::Appearance,
                 .lowest = kMinTextScale,
                 .highest = kMaxTextScale},
    WindowOption{.table = "window",
                 .key = "turbine",
                 .value = Switch([](S& s) -> bool& { return s.showsTurbine; }),
                 .help = &msg::kOptionWindowTurbine,
                 .page = SettingsPage::View},
    WindowOption{.table = "window",
                 .key = "mirror",
                 .value = Switch([](S& s) -> bool& { return s.showsMirror; }),
                 .help = &msg::kOptionWindowMirror,
                 .page = SettingsPage::View},
    WindowOption{.table = "window",
                 .key = "aim",
                 .value = Switch([](S& s) -> bool& { return s.showsAim; }),
                 .help = &msg::kOptionWindowAim,
                 .page = SettingsPage::View},
    WindowOption{.table = "window",
                 .key = "second_view",
                 .value = Text([](S& s) -> std::string& { return s.secondView; }),
                 .help = &msg::kOptionWindowSecondView,
                 .page = SettingsPage::View,
                 .words = "occlusal, buccal, lingual, mesial, distal, none"},
    WindowOption{.table = "view",
                 .key = "glass",
                 .value = Switch([](S& s) -> bool& { return s.aids.glass; }),
                 .help = &msg::kOptionViewGlass,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "scale_bar",
                 .value = Switch([](S& s) -> bool& { return s.aids.scaleBar; }),
                 .help = &msg::kOptionViewScaleBar,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "letters",
                 .value = Switch([](S& s) -> bool& { return s.aids.letters; }),
                 .help = &msg::kOptionViewLetters,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "cube",
                 .value = Switch([](S& s) -> bool& { return s.aids.cube; }),
                 .help = &msg::kOptionViewCube,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "magnifier",
                 .value = Switch([](S& s) -> bool& { return s.aids.magnifier; }),
                 .help = &msg::kOptionViewMagnifier,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "soft_tissues",
                 .value = Switch([](S& s) -> bool& { return s.aids.softTissues; }),
                 .help = &msg::kOptionViewSoftTissues,
                 .page = SettingsPage::View},
    WindowOption{.table = "view",
                 .key = "side_by_side",
                 .value = Switch([](S& s) -> bool& { return s.sideBySide; }),
                 .help = &msg::kOptionViewSideBySide,
                 .page = SettingsPage::View},
    WindowOption{.table = "mirror",
                 .key = "size",
                 .value = Text([](S& s) -> std::string& { return s.mirror.number; }),
                 .help = &msg::kOptionMirrorSize,
                 .page = SettingsPage::Instruments,
                 .words = "2, 4, 5"},
    WindowOption{.table = "mirror",
                 .key = "fogged",
                 .value = Switch([](S& s) -> bool& { return s.mirror.fogged; }),
                 .help = &msg::kOptionMirrorFogged,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "mirror",
                 .key = "wet",
                 .value = Switch([](S& s) -> bool& { return s.mirror.wet; }),
                 .help = &msg::kOptionMirrorWet,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "mirror",
                 .key = "dims",
                 .value = Switch([](S& s) -> bool& { return s.mirror.dims; }),
                 .help = &msg::kOptionMirrorDims,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "drill",
                 .key = "bur",
                 .value = Text([](S& s) -> std::string& { return s.bur; }),
                 .help = &msg::kOptionDrillBur,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "drill",
                 .key = "favourites",
                 .value = Text([](S& s) -> std::string& { return s.favouriteBurs; }),
                 .help = &msg::kOptionDrillFavourites,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "drill",
                 .key = "drive",
                 .value = Text([](S& s) -> std::string& { return s.spindle; }),
                 .help = &msg::kOptionDrillDrive,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "drill",
                 .key = "water",
                 .value = Switch([](S& s) -> bool& { return s.water; }),
                 .help = &msg::kOptionDrillWater,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "drill",
                 .key = "suction",
                 .value = Switch([](S& s) -> bool& { return s.suction; }),
                 .help = &msg::kOptionDrillSuction,
                 .page = SettingsPage::Instruments},
    WindowOption{.table = "force",
                 .key = "from_material",
                 .value = Switch([](S& s) -> bool& { return s.force.fromMaterial; }),
                 .help = &msg::kOptionForceFromMaterial,
                 .page = SettingsPage::Force},
    WindowOption{.table = "force",
                 .key = "spring",
                 .value = Number([](S& s) -> double& { return s.force.spring; }),
                 .help = &msg::kOptionForceSpring,
                 .page = SettingsPage::Force,
                 .highest = kMaxSpring,
                 .unit = "N/mm"},
    WindowOption{.table = "force",
                 .key = "damper",
                 .value = Number([](S& s) -> double& { return s.force.damper; }),
                 .help = &msg::kOptionForceDamper,
                 .page = SettingsPage::Force,
                 .highest = kMaxDamper,
                 .unit = "N*s/mm"},
    WindowOption{.table = "force",
                 .key = "friction",
                 .value = Number([](S& s) -> double& { return s.force.friction; }),
                 .help = &msg::kOptionForceFriction,
                 .page = SettingsPage::Force,
                 .highest = kMaxFriction},
    WindowOption{.table = "force",
                 .key = "scale",
                 .value = Number([](S& s) -> double& { return s.force.scale; }),
                 .help = &msg::kOptionForceScale,
                 .page = SettingsPage::Force,
                 .highest = kMaxForceScale},
    WindowOption{.table = "force",
                 .key = "press",
                 .value = Number([](S& s) -> double& { return s.force.press; }),
                 .help = &msg::kOptionForcePress,
                 .page = SettingsPage::Force,
                 .highest = MouseManipulator::kMaxPressDepth,
                 .unit = "mm"},
    WindowOption{.table = "force",
                 .key = "mouse",
                 .value = Text([](S& s) -> std::string& { return s.force.mouse; }),
                 .help = &msg::kOptionForceMouse,
                 .page = SettingsPage::Force,
                 .words = "depth, force"},
    WindowOption{.table = "force",
                 .key = "depth",
                 .value = Number([](S& s) -> double& { return s.force.depth; }),
                 .help = &msg::kOptionForceDepth,
                 .page = SettingsPage::Force,
                 .highest = DepthControl::kMaxDepth,
                 .unit = "mm"},
    WindowOption{.table = "force",
                 .key = "flat_floor",
                 .value = Switch([](S& s) -> bool& { return s.force.flatFloor; }),
                 .help = &msg::kOptionForceFlatFloor,
                 .page = SettingsPage::Force},
    WindowOption{.table = "force",
                 .key = "depth_stop",
                 .value = Switch([](S& s) -> bool& { return s.force.depthStop; }),
                 .help = &msg::kOptionForceDepthStop,
                 .page = SettingsPage::Force},
    WindowOption{.table = "force",
                 .key = "guide",
                 .value = Switch([](S& s) -> bool& { return s.force.guide; }),
                 .help = &msg::kOptionForceGuide,
                 .page = SettingsPage::Force},
    WindowOption{.table = "hand",
                 .key = "device",
                 .value = Text([](S& s) -> std::string& { return s.hand.device; }),
                 .help = &msg::kOptionHandDevice,
                 .page = SettingsPage::Hand,
                 .hasFlag = false},
    WindowOption{.table = "hand",
                 .key = "second_device",
                 .value = Text([](S& s) -> std::string& { return s.hand.secondDevice; }),
                 .help = &msg::kOptionHandSecondDevice,
                 .page = SettingsPage::Hand,
                 .hasFlag = false},
    WindowOption{.table = "hand",
                 .key = "fineness",
                 .value = Number([](S& s) -> double& { return s.hand.motionScaling; }),
                 .help = &msg::kOptionHandMotionScaling,
                 .page = SettingsPage::Hand,
                 .lowest = kMinMotionScaling,
                 .highest = kMaxMotionScaling,
                 .zero = "fit"},
    WindowOption{.table = "hand",
                 .key = "rate",
                 .value = Number([](S& s) -> double& { return s.hand.rate; }),
                 .help = &msg::kOptionHandRate,
                 .page = SettingsPage::Hand,
                 .lowest = kMinRate,
                 .highest = kMaxRate,
                 .unit = "Hz"},
    WindowOption{.table = "hand",
                 .key = "left_handed",
                 .value = Switch([](S& s) -> bool& { return s.hand.leftHanded; }),
                 .help = &msg::kOptionHandLeftHanded,
                 .page = SettingsPage::Hand},
    WindowOption{.table = "hand",
                 .key = "swap_button",
                 .value = Number([](S& s) -> double& { return s.hand.swapButton; }),
                 .help = &msg::kOptionHandSwapButton,
                 .page = SettingsPage::Hand,
                 .highest = kMaxButton,
                 .isCount = true},
    WindowOption{.table = "hand",
                 .key = "cut_button",
                 .value = Number([](S& s) -> double& { return s.hand.cutButton; }),
                 .help = &msg::kOptionHandCutButton,
                 .page = SettingsPage::Hand,
                 .highest = kMaxButton,
                 .isCount = true},
    WindowOption{.table = "hand",
                 .key = "clutch_button",
                 .value = Number([](S& s) -> double& { return s.hand.clutchButton; }),
                 .help = &msg::kOptionHandClutchButton,
                 .page = SettingsPage::Hand,
                 .highest = kMaxButton,
                 .isCount = true},
    WindowOption{.table = "pedal",
                 .key = "source",
                 .value = Text([](S& s) -> std::string& { return s.hand.pedal; }),
                 .help = &msg::kOptionPedalSource,
                 .page = SettingsPage::Hand},
    WindowOption{.table = "pedal",
                 .key = "up",
                 .value = Number([](S& s) -> double& { return s.hand.pedalUp; }),
                 .help = &msg::kOptionPedalUp,
                 .page = SettingsPage::Hand,
                 .highest = 1},
    WindowOption{.table = "pedal",
                 .key = "down",
                 .value = Number([](S& s) -> double& { return s.hand.pedalDown; }),
                 .help = &msg::kOptionPedalDown,
                 .page = SettingsPage::Hand,
                 .highest = 1},
    WindowOption{.table = "pedal",
                 .key = "key",
                 .value = Text([](S& s) -> std::string& { return s.hand.pedalKey; }),
                 .help = &msg::kOptionPedalKey},
    WindowOption{.table = "keys", .key = "own", .value = Text([](S& s) -> std::string& { return s.ownKeys; })},
    WindowOption{.table = "sound",
                 .key = "turbine",
                 .value = Number([](S& s) -> double& { return s.sound.motor; }),
                 .help = &msg::kOptionSoundTurbine,
                 .page = SettingsPage::Sound,
                 .highest = 1},
    WindowOption{.table = "sound",
                 .key = "cutting",
                 .value = Number([](S& s) -> double& { return s.sound.cutting; }),
                 .help = &msg::kOptionSoundCutting,
                 .page = SettingsPage::Sound,
                 .highest = 1},
    WindowOption{.table = "sound",
                 .key = "water",
                 .value = Number([](S& s) -> double& { return s.sound.environment; }),
                 .help = &msg::kOptionSoundWater,
                 .page = SettingsPage::Sound,
                 .highest = 1},
    WindowOption{.table = "sound",
                 .key = "all",
                 .value = Number([](S& s) -> double& { return s.sound.master; }),
                 .help = &msg::kOptionSoundAll,
                 .page = SettingsPage::Sound,
                 .highest = 1},
    WindowOption{.table = "sound",
                 .key = "muted",
                 .value = Switch([](S& s) -> bool& { return s.sound.muted; }),
                 .help = &msg::kOptionSoundMuted,
                 .page = SettingsPage::Sound},
    WindowOption{.table = "sound",
                 .key = "headphones",
                 .value = Switch([](S& s) -> bool& { return s.headphones; }),
                 .help = &msg::kOptionSoundHeadphones,
                 .page = SettingsPage::Sound},
    WindowOption{.table = "sound",
                 .key = "room",
                 .value = Switch([](S& s) -> bool& { return s.room; }),
                 .help = &msg::kOptionSoundRoom,
                 .page = SettingsPage::Sound},
    WindowOption{.table = "sound",
                 .key = "recordings",
                 .value = Text([](S& s) -> std::string& { return s.ownSounds; }),
                 .help = &msg::kOptionSoundRecordings,
                 .page = SettingsPage::Sound},
    WindowOption{.table = "recording",
                 .key = "sessions",
                 .value = Switch([](S& s) -> bool& { return s.recordsSessions; }),
                 .help = &msg::kOptionRecordingSessions,
                 .page = SettingsPage::Recording},
    WindowOption{.table = "recording",
                 .key = "gigabytes",
                 .value = Number([](S& s) -> double& { return s.recordingGigabytes; }),
                 .help = &msg::kOptionRecordingGigabytes,
                 .page = SettingsPage::Recording,
                 .lowest = kMinRecordingGigabytes,
                 .highest = kMaxRecordingGigabytes,
                 .unit = "GB"},
};

}  // namespace

std::span<const WindowOption> windowOptions() { return kOptions; }

std::string flagOf(const WindowOption& option) {
    std::string flag = std::string("--") + option.table + "-" + option.key;
    for (char& c : flag) c = c == '_' ? '-' : c;
    return flag;
}

std::string flagHelp(const WindowOption& option) {
    std::string text(option.help->english);
    if (option.words != nullptr) text += std::string(": ") + option.words;
    WindowSettings usual;
    std::string value;
    if (const auto* number = std::get_if<Number>(&option.value)) {
        text += ": " + numberText(option.lowest) + " to " + numberText(option.highest);
        if (option.unit != nullptr) text += std::string(" ") + option.unit;
        const double held = (*number)(usual);
        value = held == 0 && option.zero != nullptr ? option.zero : numberText(held);
    } else if (const auto* on = std::get_if<Switch>(&option.value)) {
        value = (*on)(usual) ? "yes" : "no";
    } else {
        value = std::get<Text>(option.value)(usual);
        if (value.empty() && option.empty != nullptr) value = option.empty->english;
    }
    return value.empty() ? text : text + " (default: " + value + ")";
}

bool takesText(const WindowOption& option, std::string_view text) {
    if (option.words == nullptr || text.empty()) return true;
    for (std::string_view rest = option.words; !rest.empty();) {
        const std::string_view word = rest.substr(0, rest.find(", "));
        if (word == text) return true;
        rest.remove_prefix(std::min(rest.size(), word.size() + 2));
    }
    return false;
}

Expected<void> setWindowOption(WindowSettings& settings, const WindowOption& option, const std::string& text) {
    if (const auto* value = std::get_if<Text>(&option.value)) {
        if (!takesText(option, text)) return unexpected(msg::kFlagTakesWord, flagOf(option), option.words, text);
        (*value)(settings) = text;
        return {};
    }
    if (const auto* value = std::get_if<Switch>(&option.value)) {
        if (text != "yes" && text != "no") return unexpected(msg::kFlagTakesYesOrNo, flagOf(option), text);
        (*value)(settings) = text == "yes";
        return {};
    }
    double& value = std::get<Number>(option.value)(settings);
    if (option.zero != nullptr && text == option.zero) {
        value = 0;
        return {};
    }
    const auto number = toNumber<double>(text);
    if (!number || !(*number >= option.lowest) || *number > option.highest) {
        const std::string flag = flagOf(option), lowest = numberText(option.lowest),
                          highest = numberText(option.highest);
        if (option.zero == nullptr) return unexpected(msg::kFlagTakesNumber, flag, lowest, highest, text);
        return unexpected(msg::kFlagTakesNumberOr, flag, option.zero, lowest, highest, text);
    }
    value = *number;
    return {};
}

}  // namespace tactooth
