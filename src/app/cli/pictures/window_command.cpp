// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/pictures/window_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/cli/terminal/default_text.h"
#include "app/cli/terminal/messages.h"
#include "app/common/exit_code.h"
#include "app/gui/settings/window_settings.h"
#include "app/gui/window/run_window.h"
#include "devices/open_device.h"
#include "geometry/util/number_text.h"
#include "session/io/material_file.h"
#include "session/recording/session_recorder.h"

namespace tactooth {
namespace {

constexpr const char* kGroup = "Window";
constexpr const char* kDevice = "--device";
constexpr const char* kSecondDevice = "--second-device";
constexpr const char* kSecondDeviceSetting = "--hand-second-device";

/// Options for the tooth that replaces the built-in one.
void addOwnTooth(CLI::App& program, WindowArguments& arguments) {
    CLI::Option* tooth =
        program.add_option("--tooth,--case,CASE", arguments.tooth,
                           "Opens your own tooth: a case, an STL file (mm) or a saved tooth; or replays a recorded "
                           "session (*.ttsession)");
    tooth->type_name("FILE")->group(kGroup);
    program.add_option("--work-on", arguments.workOn, "Tooth of the case to work on (default: the first)")
        ->type_name("NAME")
        ->needs(tooth)
        ->group(kGroup);
    program.add_option("--layer", arguments.layers, "A closed surface inside it; NAME: " + builtinMaterials().names())
        ->type_name("NAME=FILE")
        ->allow_extra_args(false)
        ->needs(tooth)
        ->group(kGroup);
    program
        .add_option("--materials", arguments.materials,
                    "TOML file that changes the materials of it or adds some (pattern: data/materials.toml)")
        ->type_name("FILE")
        ->needs(tooth)
        ->group(kGroup);
}

/// Options for the devices that move the bur and the mirror.
void addHands(CLI::App& program, WindowArguments& arguments) {
    program
        .add_option(
            kDevice, arguments.device,
            "Device that moves the bur: " + deviceNames() +
                "; replay:FILE.csv follows a trajectory (default: the device of the last session; docs/haptics.md)")
        ->type_name("NAME")
        ->group(kGroup);
    program
        .add_option_function<std::string>(
            kSecondDevice, [&arguments](const std::string& name) { arguments.settings[kSecondDeviceSetting] = name; },
            "Device of the other hand, which holds the mirror: a name as for --device, except mouse, or none. The "
            "window remembers it")
        ->type_name("NAME")
        ->group(kGroup);
    program
        .add_flag(
            "--device-in-process", arguments.deviceInProcess,
            "For debugging: holds devices in this process. Usually tactooth-hand holds them, which cuts the force "
            "if this process fails")
        ->group(kGroup);
}

void addMouthAndBur(CLI::App& program, WindowArguments& arguments) {
    CLI::Option* mouth = program.add_option_function<std::string>(
        "--mouth",
        [&arguments](const std::string& fdi) {
            arguments.mouth = fdi.empty() ? MouthChoice().fdi : toNumber<int>(fdi).value_or(0);
        },
        withDefault("Opens the whole built-in mouth to work on this tooth", MouthChoice().fdi));
    mouth->type_name("[FDI]")->expected(0, 1)->excludes("--tooth")->group(kGroup);
    program.add_flag("--no-cache", arguments.noCache, "Generates teeth and gums again and does not use the cache")
        ->needs(mouth)
        ->group(kGroup);
    program
        .add_option(
            "--bur", arguments.bur,
            "The bur to begin with: its number (as 57), or your own: an STL file (tip at the origin, +z along the "
            "shaft) or its TOML description")
        ->type_name("NUMBER|FILE")
        ->group(kGroup);
}

void addExercise(CLI::App& program, WindowArguments& arguments) {
    program
        .add_option("--exercise", arguments.exercise,
                    "Opens an exercise: a built-in one (as class-1-46), or your own, a TOML file with tooth, bur and "
                    "ideal cavity (docs/exercises.md)")
        ->type_name("NAME|FILE")
        ->excludes("--tooth")
        ->excludes("--mouth")
        ->group(kGroup);
}

void addRecordings(CLI::App& program, WindowArguments& arguments) {
    program
        .add_option("--recordings", arguments.recordings,
                    "Folder where sessions are recorded (default: tactooth/recordings in the user's folder for data)")
        ->type_name("DIR")
        ->group(kGroup);
    program.add_flag("--no-record", arguments.noRecord, "Keeps nothing of this session and offers nothing to restore")
        ->excludes("--recordings")
        ->group(kGroup);
    program
        .add_flag("--sealed", arguments.sealed,
                  "Examination: no undo, no ghost, no numbers, and the recording is signed with the key of this "
                  "station ('session key'). File > Finish examination ends it")
        ->excludes("--no-record")
        ->group(kGroup);
}

void addStream(CLI::App& program, WindowArguments& arguments) {
    program
        .add_option(
            "--stream", arguments.stream,
            "Sends the newest tick there by UDP, at most a thousand times a second (docs/live-stream.md); not in "
            "an examination")
        ->type_name("udp://HOST:PORT")
        ->excludes("--sealed")
        ->group(kGroup);
}

/// One option for each stored setting.
void addSettings(CLI::App& program, WindowArguments& arguments) {
    for (const WindowOption& option : windowOptions()) {
        if (option.help == nullptr || !option.hasFlag) continue;
        const bool isSwitch = std::holds_alternative<WindowOption::Switch>(option.value);
        const bool isNumber = std::holds_alternative<WindowOption::Number>(option.value);
        const std::string flag = flagOf(option);
        program
            .add_option_function<std::string>(
                flag, [&arguments, flag](const std::string& text) { arguments.settings[flag] = text; },
                flagHelp(option))
            ->type_name(isSwitch   ? "yes|no"
                        : isNumber ? "NUMBER"
                                   : "TEXT")
            ->group("Window settings (kept in window.toml)");
    }
}

/// Rejects a device name that cannot be meant. The window would try it, fail and store it.
Expected<void> checkDevices(const WindowArguments& arguments) {
    if (arguments.device) {
        if (auto known = checkDeviceName(*arguments.device, kDevice); !known) return known;
    }
    const auto second = arguments.settings.find(kSecondDeviceSetting);
    if (second == arguments.settings.end()) return {};
    return checkDeviceName(second->second, kSecondDevice, true);
}

}  // namespace

void addWindowArguments(CLI::App& program, WindowArguments& arguments) {
    addOwnTooth(program, arguments);
    addHands(program, arguments);
    addMouthAndBur(program, arguments);
    addExercise(program, arguments);
    addRecordings(program, arguments);
    addStream(program, arguments);
    addSettings(program, arguments);
}

int runWindowCommand(const WindowArguments& arguments) {
    if (const auto known = checkDevices(arguments); !known) return reportError(known.error());
    if (arguments.deviceInProcess) setDeviceHost(DeviceHost::ThisProcess);
    WindowOptions options;
    if (!arguments.tooth.empty()) {
        const std::filesystem::path file = arguments.tooth;
        std::error_code unused;
        if (!file.has_extension() && !std::filesystem::exists(file, unused)) {
            return reportError({msg::kCommandUnknown, arguments.tooth});
        }
        if (file.extension() == kSessionFileEnding) {
            if (!arguments.materials.empty() || !arguments.layers.empty() || !arguments.workOn.empty()) {
                return reportError(msg::kRecordingBringsAll);
            }
            options.recording = file;
        } else {
            options.tooth = ToothSource{.outer = file, .layers = {}};
            options.workOn = arguments.workOn;
        }
    }
    if (arguments.mouth) {
        if (!isPermanentTooth(*arguments.mouth)) {
            return reportError(msg::kMouthNeedsTooth);
        }
        options.mouth = MouthChoice{*arguments.mouth, !arguments.noCache};
    }
    const auto materials = materialsFrom(arguments.materials);
    if (!materials) return reportError(materials.error());
    if (!arguments.materials.empty()) options.tooth->materials = *materials;
    for (const std::string& text : arguments.layers) {
        Expected<ToothSource::Layer> layer = parseLayer(text, **materials);
        if (!layer) return reportError(layer.error());
        options.tooth->layers.push_back(std::move(*layer));
    }
    if (!arguments.exercise.empty()) options.exercise = arguments.exercise;
    if (!arguments.bur.empty()) options.bur = arguments.bur;
    options.recordings = arguments.recordings;
    options.records = !arguments.noRecord;
    options.stream = arguments.stream;
    options.sealed = arguments.sealed;
    options.settings = arguments.settings;
    options.device = arguments.device;
    return runWindow(options);
}

}  // namespace tactooth
