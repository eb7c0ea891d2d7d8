// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what the window remembers.
#include <array>

#include "app/gui/input/mouse_manipulator.h"
#include "app/gui/settings/window_settings.h"
#include "app/gui/text/messages.h"
#include "devices/workspace_fit.h"
#include "geometry/util/number_text.h"

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
                 "Folder in which the search for files begins"},
    WindowOption{"window", "recent", Text([](S& s) -> std::string& { return s.recent; }), 0, nullptr},
    WindowOption{"window", "language", Text([](S& s) -> std::string& { return s.language; }), 0,
                 "en or ja (default: the system's)"},
    WindowOption{"window", "dark", Switch([](S& s) -> bool& { return s.dark; }), 0, "Dark colours"},
    WindowOption{"window", "text", Number([](S& s) -> double& { return s.textScale; }), kMaxTextScale,
                 "Size of all texts: 1 (usual) to 2"},
    WindowOption{"window", "turbine", Switch([](S& s) -> bool& { return s.showsTurbine; }), 0, "Show the handpiece"},
    WindowOption{"window", "mirror", Switch([](S& s) -> bool& { return s.showsMirror; }), 0, "Show the mirror"},
    WindowOption{"window", "second_view", Text([](S& s) -> std::string& { return s.secondView; }), 0,
                 "Small picture from another side: occlusal, buccal, lingual, mesial, distal or none"},
    WindowOption{"mirror", "size", Text([](S& s) -> std::string& { return s.mirror.number; }), 0,
                 "2, 4 or 5: 18, 22 or 24 mm"},
    WindowOption{"mirror", "fogged", Switch([](S& s) -> bool& { return s.mirror.fogged; }), 0, "Breath on the glass"},
    WindowOption{"mirror", "wet", Switch([](S& s) -> bool& { return s.mirror.wet; }), 0, "Drops on the glass"},
    WindowOption{"drill", "bur", Text([](S& s) -> std::string& { return s.bur; }), 0,
                 "Number of a bur of the catalogue"},
    WindowOption{"drill", "drive", Text([](S& s) -> std::string& { return s.spindle; }), 0,
                 "Name of a drive, as the window lists it"},
    WindowOption{"drill", "water", Switch([](S& s) -> bool& { return s.water; }), 0, "Water spray with the pedal"},
    WindowOption{"drill", "suction", Switch([](S& s) -> bool& { return s.suction; }), 0, "Suction tube in the mouth"},
    WindowOption{"force", "from_material", Switch([](S& s) -> bool& { return s.force.fromMaterial; }), 0,
                 "Spring and damper are those of the material"},
    WindowOption{"force", "spring", Number([](S& s) -> double& { return s.force.spring; }), kMaxSpring, "N/mm"},
    WindowOption{"force", "damper", Number([](S& s) -> double& { return s.force.damper; }), kMaxDamper, "N*s/mm"},
    WindowOption{"force", "friction", Number([](S& s) -> double& { return s.force.friction; }), kMaxFriction,
                 "Coulomb coefficient"},
    WindowOption{"force", "scale", Number([](S& s) -> double& { return s.force.scale; }), kMaxForceScale,
                 "Multiplies the force"},
    WindowOption{"force", "press", Number([](S& s) -> double& { return s.force.press; }),
                 MouseManipulator::kMaxPressDepth, "How deep the mouse presses, mm"},
    WindowOption{"hand", "device", Text([](S& s) -> std::string& { return s.hand.device; }), 0, nullptr},
    WindowOption{"hand", "second_device", Text([](S& s) -> std::string& { return s.hand.secondDevice; }), 0, nullptr},
    WindowOption{"hand", "fineness", Number([](S& s) -> double& { return s.hand.motionScaling; }), kMaxMotionScaling,
                 "mm that a device's hand moves for each mm of the bur, 1 to 3, or fit: as fine as its room allows",
                 kMinMotionScaling, "fit"},
    WindowOption{"hand", "rate", Number([](S& s) -> double& { return s.hand.rate; }), kMaxRate,
                 "Forces a second: 500 to 4000, usually 1000", kMinRate},
    WindowOption{"hand", "left_handed", Switch([](S& s) -> bool& { return s.hand.leftHanded; }), 0,
                 "Handles leave to the other side, a gamepad's halves change places"},
    WindowOption{"hand", "swap_button", Number([](S& s) -> double& { return s.hand.swapButton; }), kMaxButton,
                 "Button for turbine or mirror; 0: none"},
    WindowOption{"hand", "cut_button", Number([](S& s) -> double& { return s.hand.cutButton; }), kMaxButton,
                 "Button for touch or cut; 0: none"},
    WindowOption{"hand", "clutch_button", Number([](S& s) -> double& { return s.hand.clutchButton; }), kMaxButton,
                 "Button that holds the bur while the hand moves on; 0: none"},
    WindowOption{"pedal", "source", Text([](S& s) -> std::string& { return s.hand.pedal; }), 0,
                 "Foot pedal: axis:N or button:N of a joystick, with :NAME of the joystick"},
    WindowOption{"pedal", "up", Number([](S& s) -> double& { return s.hand.pedalUp; }), 1,
                 "Place of that axis with the foot off, 0 to 1 of its way"},
    WindowOption{"pedal", "down", Number([](S& s) -> double& { return s.hand.pedalDown; }), 1,
                 "Place of that axis with the pedal pressed fully"},
    WindowOption{"pedal", "key", Text([](S& s) -> std::string& { return s.hand.pedalKey; }), 0,
                 "Key that is the pedal (default, and for a name that is no key: Space)"},
    WindowOption{"sound", "turbine", Number([](S& s) -> double& { return s.sound.motor; }), 1, "Volume"},
    WindowOption{"sound", "cutting", Number([](S& s) -> double& { return s.sound.cutting; }), 1, "Volume"},
    WindowOption{"sound", "water", Number([](S& s) -> double& { return s.sound.environment; }), 1, "Volume"},
    WindowOption{"sound", "all", Number([](S& s) -> double& { return s.sound.master; }), 1, "Volume"},
    WindowOption{"sound", "muted", Switch([](S& s) -> bool& { return s.sound.muted; }), 0, "No sound"},
    WindowOption{"sound", "headphones", Switch([](S& s) -> bool& { return s.headphones; }), 0,
                 "Places the sounds around the head"},
    WindowOption{"sound", "recordings", Text([](S& s) -> std::string& { return s.ownSounds; }), 0,
                 "File of your own sounds"},
};

}  // namespace

std::span<const WindowOption> windowOptions() { return kOptions; }

std::string flagOf(const WindowOption& option) {
    std::string flag = std::string("--") + option.table + "-" + option.key;
    for (char& c : flag) c = c == '_' ? '-' : c;
    return flag;
}

Expected<void> setWindowOption(WindowSettings& settings, const WindowOption& option, const std::string& text) {
    if (const auto* value = std::get_if<Text>(&option.value)) {
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
