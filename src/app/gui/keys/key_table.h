// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/util/message.h"

namespace tactooth {

/// All that a key can do in the window: the rows of the table of keys, in its order.
enum class KeyId {
    // Touching and cutting.
    Touch,
    Cut,
    Pedal,
    Press,
    MoveLeft,
    MoveRight,
    MoveUp,
    MoveDown,
    Lean,
    FineDepth,
    Upright,
    TurnHandleLeft,
    TurnHandleRight,
    Hold,
    TakeTurbine,
    TakeContraAngle,
    TakeLowSpeed,
    TakeExplorer,
    TakeProbe,
    TakeExcavator,
    Water,
    Suction,
    Undo,
    Redo,
    ResetTooth,
    // Looking.
    TurnTooth,
    Zoom,
    Nearer,
    Farther,
    DentistView,
    Occlusal,
    Buccal,
    Lingual,
    Mesial,
    Distal,
    Fit,
    SecondNone,
    SecondOcclusal,
    SecondBuccal,
    SecondLingual,
    SecondMesial,
    SecondDistal,
    Mirror,
    HoldMirror,
    PlaceMirror,
    ParkMirror,
    Distance,
    Angle,
    Taper,
    RemainingDentin,
    Turbine,
    Aim,
    Ghost,
    Glass,
    Magnifier,
    ScaleBar,
    SoftTissues,
    Letters,
    Cube,
    Fogged,
    Drops,
    // Files and program.
    Welcome,
    Open,
    Import,
    Chart,
    Burs,
    Save,
    Export,
    Finish,
    Dark,
    Mute,
    Help,
    Settings,
    Quit,
    // Replay of a recording.
    ReplayPlay,
    ReplayPrevious,
    ReplayBack,
    ReplayOn,
    ReplayNext,
    ReplaySideBySide,
    ReplayLeave,
};

enum class KeyGroup { Cutting, View, Program, Replay };

/// What may be a key of a row, and where it works.
enum class KeyKind {
    Shortcut,      ///< with or without modifiers; in the whole window
    Single,        ///< without modifiers, which do not count: a key that is held, or that the picture takes
    Arrow,         ///< the same, and works in the picture together with a HandModifier
    HandModifier,  ///< Shift, Ctrl, Alt or Meta, with the mouse or an Arrow
    WheelModifier  ///< the same, with the wheel
};

/// One thing that a key can do.
struct KeyRow {
    KeyId id;
    const char* name;   ///< in the settings
    const char* usual;  ///< its key, in Qt's English text; more than one with "; " between them
    KeyKind kind;
    KeyGroup group;
    const MessageText* text;  ///< what it does
};

/// The only list of the keys of the window: the actions get their keys from it, and so do the picture, the page of the
/// keys and the editor.
[[nodiscard]] std::span<const KeyRow> keyTable();
[[nodiscard]] const KeyRow& keyRow(KeyId id);
[[nodiscard]] const MessageText& titleOf(KeyGroup group);

/// Mouse, gamepad and keys that cannot be changed, for the page of the keys.
struct FixedControls {
    struct Row {
        const MessageText* what;
        const MessageText* effect;
    };
    const MessageText* title;
    std::span<const Row> rows;
};
[[nodiscard]] std::span<const FixedControls> fixedControls();

}  // namespace tactooth
