// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what the window remembers.
#include <algorithm>
#include <array>

#include "app/gui/settings/window_settings.h"
#include "app/gui/text/messages.h"
#include "devices/base/workspace_fit.h"
#include "geometry/util/number_text.h"
#include "session/model/mouse_manipulator.h"

namespace tactooth {
namespace {

using S = WindowSettings;
using Text = WindowOption::Text;
using Switch = WindowOption::Switch;
using Number = WindowOption::Number;

constexpr std::array kOptions = {
    WindowOption{"window", "geometry", Text([](S& s) -> std::string& { return s.geometry; }), 0, nullptr},
    WindowOption{"window", "docks", Text([](S& s) -> std::string& { return s.docks; }), 0, nullptr},
    WindowOption{"window", "folder", Text([](S& s) -> std::string& { return s.folder; }), 0,
                 "Folder that file dialogs open first"},
    WindowOption{"window", "recent", Text([](S& s) -> std::string& { return s.recent; }), 0, nullptr},
    WindowOption{"window", "notation", Text([](S& s) -> std::string& { return s.notation; }), 0,
                 "Numbers of the teeth in the tooth chart: fdi (default), universal or palmer", 0, nullptr,
                 "fdi, universal, palmer"},
    WindowOption{"window", "language", Text([](S& s) -> std::string& { return s.language; }), 0,
                 "en or ja (default: the system's)", 0, nullptr, "en, ja"},
    WindowOption{"window", "dark", Switch([](S& s) -> bool& { return s.dark; }), 0, "Dark colours"},
    WindowOption{"window", "text", Number([](S& s) -> double& { return s.textScale; }), kMaxTextScale,
                 "Size of all texts: 1 (default) to 2"},
    WindowOption{"window", "turbine", Switch([](S& s) -> bool& { return s.showsTurbine; }), 0, "Shows the handpiece"},
    WindowOption{"window", "mirror", Switch([](S& s) -> bool& { return s.showsMirror; }), 0, "Shows the mirror"},
    WindowOption{"window", "aim", Switch([](S& s) -> bool& { return s.showsAim; }), 0,
                 "Shows where the bur will land, and the depth at its tip"},
    WindowOption{"window", "second_view", Text([](S& s) -> std::string& { return s.secondView; }), 0,
                 "Second view: occlusal, buccal, lingual, mesial, distal or none", 0, nullptr,
                 "occlusal, buccal, lingual, mesial, distal, none"},
    WindowOption{"view", "glass", Switch([](S& s) -> bool& { return s.aids.glass; }), 0,
                 "Handles turn to glass where they hide the bur's head (default: yes)"},
    WindowOption{"view", "scale_bar", Switch([](S& s) -> bool& { return s.aids.scaleBar; }), 0,
                 "Scale bar in mm (default: yes)"},
    WindowOption{"view", "letters", Switch([](S& s) -> bool& { return s.aids.letters; }), 0,
                 "Letters of the directions at the edge of the picture (default: yes)"},
    WindowOption{"view", "cube", Switch([](S& s) -> bool& { return s.aids.cube; }), 0,
                 "Cube that shows and chooses the side from which one looks (default: yes)"},
    WindowOption{"view", "magnifier", Switch([](S& s) -> bool& { return s.aids.magnifier; }), 0,
                 "Magnifier of the bur's head (default: no)"},
    WindowOption{"mirror", "size", Text([](S& s) -> std::string& { return s.mirror.number; }), 0,
                 "2, 4 or 5: 18, 22 or 24 mm", 0, nullptr, "2, 4, 5"},
    WindowOption{"mirror", "fogged", Switch([](S& s) -> bool& { return s.mirror.fogged; }), 0, "Fog on the glass"},
    WindowOption{"mirror", "wet", Switch([](S& s) -> bool& { return s.mirror.wet; }), 0, "Drops on the glass"},
    WindowOption{"drill", "bur", Text([](S& s) -> std::string& { return s.bur; }), 0,
                 "Number of a bur of the catalogue"},
    WindowOption{"drill", "favourites", Text([](S& s) -> std::string& { return s.favouriteBurs; }), 0,
                 "Numbers of the favourite burs, as \"4, 245\""},
    WindowOption{"drill", "drive", Text([](S& s) -> std::string& { return s.spindle; }), 0,
                 "Name of a drive, as the window lists it"},
    WindowOption{"drill", "water", Switch([](S& s) -> bool& { return s.water; }), 0, "Water spray with the pedal"},
    WindowOption{"drill", "suction", Switch([](S& s) -> bool& { return s.suction; }), 0, "Suction tube in the mouth"},
    WindowOption{"force", "from_material", Switch([](S& s) -> bool& { return s.force.fromMaterial; }), 0,
                 "Takes stiffness and damping from the material"},
    WindowOption{"force", "spring", Number([](S& s) -> double& { return s.force.spring; }), kMaxSpring,
                 "Stiffness, N/mm"},
    WindowOption{"force", "damper", Number([](S& s) -> double& { return s.force.damper; }), kMaxDamper,
                 "Damping, N*s/mm"},
    WindowOption{"force", "friction", Number([](S& s) -> double& { return s.force.friction; }), kMaxFriction,
                 "Coulomb coefficient"},
    WindowOption{"force", "scale", Number([](S& s) -> double& { return s.force.scale; }), kMaxForceScale,
                 "Factor of the force"},
    WindowOption{"force", "press", Number([](S& s) -> double& { return s.force.press; }),
                 MouseManipulator::kMaxPressDepth,
                 "How far the mouse presses beyond the surface, mm: 1 mm is about 1 N on enamel"},
    WindowOption{"force", "mouse", Text([](S& s) -> std::string& { return s.force.mouse; }), 0,
                 "What ends a press of the mouse: depth (default) or force", 0, nullptr, "depth, force"},
    WindowOption{"force", "depth", Number([](S& s) -> double& { return s.force.depth; }), DepthControl::kMaxDepth,
                 "Depth below the uncut surface at which a press of the mouse ends, mm"},
    WindowOption{"force", "flat_floor", Switch([](S& s) -> bool& { return s.force.flatFloor; }), 0,
                 "That depth gives a flat floor; no: the floor follows the surface"},
    WindowOption{"hand", "device", Text([](S& s) -> std::string& { return s.hand.device; }), 0, nullptr},
    WindowOption{"hand", "second_device", Text([](S& s) -> std::string& { return s.hand.secondDevice; }), 0, nullptr},
    WindowOption{"hand", "fineness", Number([](S& s) -> double& { return s.hand.motionScaling; }), kMaxMotionScaling,
                 "Motion scaling: mm that the device moves for each mm of the bur, 1 to 3; fit: from the workspace of "
                 "the device",
                 kMinMotionScaling, "fit"},
    WindowOption{"hand", "rate", Number([](S& s) -> double& { return s.hand.rate; }), kMaxRate,
                 "Force updates per second: 500 to 4000 (default: 1000)", kMinRate},
    WindowOption{"hand", "left_handed", Switch([](S& s) -> bool& { return s.hand.leftHanded; }), 0,
                 "Left-handed: handles point to the other side, the sticks of a gamepad are swapped"},
    WindowOption{"hand", "swap_button", Number([](S& s) -> double& { return s.hand.swapButton; }), kMaxButton,
                 "Button that swaps turbine and mirror; 0: none"},
    WindowOption{"hand", "cut_button", Number([](S& s) -> double& { return s.hand.cutButton; }), kMaxButton,
                 "Button that switches between touch and cut; 0: none"},
    WindowOption{"hand", "clutch_button", Number([](S& s) -> double& { return s.hand.clutchButton; }), kMaxButton,
                 "Clutch button: holds the bur while the hand moves; 0: none"},
    WindowOption{"pedal", "source", Text([](S& s) -> std::string& { return s.hand.pedal; }), 0,
                 "Foot pedal: axis:N or button:N of a joystick, with :NAME of the joystick"},
    WindowOption{"pedal", "up", Number([](S& s) -> double& { return s.hand.pedalUp; }), 1,
                 "Position of that axis without the foot, 0 to 1"},
    WindowOption{"pedal", "down", Number([](S& s) -> double& { return s.hand.pedalDown; }), 1,
                 "Position of that axis with the pedal pressed fully, 0 to 1"},
    WindowOption{"pedal", "key", Text([](S& s) -> std::string& { return s.hand.pedalKey; }), 0,
                 "Key that works as the pedal (default: Space)"},
    WindowOption{"sound", "turbine", Number([](S& s) -> double& { return s.sound.motor; }), 1,
                 "Volume of turbine, 0 to 1"},
    WindowOption{"sound", "cutting", Number([](S& s) -> double& { return s.sound.cutting; }), 1,
                 "Volume of cutting, 0 to 1"},
    WindowOption{"sound", "water", Number([](S& s) -> double& { return s.sound.environment; }), 1,
                 "Volume of water and suction, 0 to 1"},
    WindowOption{"sound", "all", Number([](S& s) -> double& { return s.sound.master; }), 1,
                 "Volume of all sounds, 0 to 1"},
    WindowOption{"sound", "muted", Switch([](S& s) -> bool& { return s.sound.muted; }), 0, "No sound"},
    WindowOption{"sound", "headphones", Switch([](S& s) -> bool& { return s.headphones; }), 0,
                 "Places the sounds around the head (HRTF)"},
    WindowOption{"sound", "recordings", Text([](S& s) -> std::string& { return s.ownSounds; }), 0,
                 "File with your own sounds"},
    WindowOption{"recording", "sessions", Switch([](S& s) -> bool& { return s.recordsSessions; }), 0,
                 "Keeps a recording of each session on this computer"},
    WindowOption{"recording", "gigabytes", Number([](S& s) -> double& { return s.recordingGigabytes; }),
                 kMaxRecordingGigabytes, "Most that all recordings take, in GB; the oldest ones go (default: 2)",
                 kMinRecordingGigabytes},
};

}  // namespace

std::span<const WindowOption> windowOptions() { return kOptions; }

std::string flagOf(const WindowOption& option) {
    std::string flag = std::string("--") + option.table + "-" + option.key;
    for (char& c : flag) c = c == '_' ? '-' : c;
    return flag;
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
