// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/keys/key_table.h"

#include <array>

#include "app/gui/keys/messages.h"
#include "geometry/util/assert.h"

namespace tactooth {
namespace {

constexpr std::array kRows = {
    KeyRow{KeyId::Touch, "touch", "T", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTouch},
    KeyRow{KeyId::Cut, "cut", "C", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyCut},
    KeyRow{KeyId::Pedal, "pedal", "Space", KeyKind::Single, KeyGroup::Cutting, &msg::kKeyPedal},
    KeyRow{KeyId::Press, "press", "Return", KeyKind::Single, KeyGroup::Cutting, &msg::kKeyPress},
    KeyRow{KeyId::MoveLeft, "move_left", "Left", KeyKind::Arrow, KeyGroup::Cutting, &msg::kKeyMoveLeft},
    KeyRow{KeyId::MoveRight, "move_right", "Right", KeyKind::Arrow, KeyGroup::Cutting, &msg::kKeyMoveRight},
    KeyRow{KeyId::MoveUp, "move_up", "Up", KeyKind::Arrow, KeyGroup::Cutting, &msg::kKeyMoveUp},
    KeyRow{KeyId::MoveDown, "move_down", "Down", KeyKind::Arrow, KeyGroup::Cutting, &msg::kKeyMoveDown},
    KeyRow{KeyId::Lean, "lean", "Shift", KeyKind::HandModifier, KeyGroup::Cutting, &msg::kKeyLean},
    KeyRow{KeyId::FineDepth, "fine_depth", "Shift", KeyKind::WheelModifier, KeyGroup::Cutting, &msg::kKeyFineDepth},
    KeyRow{KeyId::Upright, "upright", "U", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyUpright},
    KeyRow{KeyId::TurnHandleLeft, "turn_handle_left", "Q", KeyKind::Shortcut, KeyGroup::Cutting,
           &msg::kKeyTurnHandleLeft},
    KeyRow{KeyId::TurnHandleRight, "turn_handle_right", "E", KeyKind::Shortcut, KeyGroup::Cutting,
           &msg::kKeyTurnHandleRight},
    KeyRow{KeyId::Hold, "hold", "X", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyHold},
    KeyRow{KeyId::TakeTurbine, "take_turbine", "F2", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTakeTurbine},
    KeyRow{KeyId::TakeContraAngle, "take_contra_angle", "F3", KeyKind::Shortcut, KeyGroup::Cutting,
           &msg::kKeyTakeContraAngle},
    KeyRow{KeyId::TakeLowSpeed, "take_low_speed", "F4", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTakeLowSpeed},
    KeyRow{KeyId::TakeExplorer, "take_explorer", "F5", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTakeExplorer},
    KeyRow{KeyId::TakeProbe, "take_probe", "F6", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTakeProbe},
    KeyRow{KeyId::TakeExcavator, "take_excavator", "F7", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyTakeExcavator},
    KeyRow{KeyId::Water, "water", "W", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyWater},
    KeyRow{KeyId::Suction, "suction", "S", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeySuction},
    KeyRow{KeyId::Undo, "undo", "Ctrl+Z", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyUndo},
    KeyRow{KeyId::Redo, "redo", "Ctrl+Shift+Z; Ctrl+Y", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyRedo},
    KeyRow{KeyId::ResetTooth, "reset_tooth", "Ctrl+R", KeyKind::Shortcut, KeyGroup::Cutting, &msg::kKeyResetTooth},
    KeyRow{KeyId::TurnTooth, "turn_tooth", "Ctrl", KeyKind::HandModifier, KeyGroup::View, &msg::kKeyTurnTooth},
    KeyRow{KeyId::Zoom, "zoom", "Ctrl", KeyKind::WheelModifier, KeyGroup::View, &msg::kKeyZoom},
    KeyRow{KeyId::Nearer, "nearer", "+", KeyKind::Single, KeyGroup::View, &msg::kKeyNearer},
    KeyRow{KeyId::Farther, "farther", "-", KeyKind::Single, KeyGroup::View, &msg::kKeyFarther},
    KeyRow{KeyId::DentistView, "dentist_view", "0", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyDentistView},
    KeyRow{KeyId::Occlusal, "occlusal", "1", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyOcclusal},
    KeyRow{KeyId::Buccal, "buccal", "2", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyBuccal},
    KeyRow{KeyId::Lingual, "lingual", "3", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyLingual},
    KeyRow{KeyId::Mesial, "mesial", "4", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyMesial},
    KeyRow{KeyId::Distal, "distal", "5", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyDistal},
    KeyRow{KeyId::Fit, "fit", "F", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyFit},
    KeyRow{KeyId::SecondNone, "second_none", "Ctrl+0", KeyKind::Shortcut, KeyGroup::View, &msg::kKeySecondNone},
    KeyRow{KeyId::SecondOcclusal, "second_occlusal", "Ctrl+1", KeyKind::Shortcut, KeyGroup::View,
           &msg::kKeySecondOcclusal},
    KeyRow{KeyId::SecondBuccal, "second_buccal", "Ctrl+2", KeyKind::Shortcut, KeyGroup::View, &msg::kKeySecondBuccal},
    KeyRow{KeyId::SecondLingual, "second_lingual", "Ctrl+3", KeyKind::Shortcut, KeyGroup::View,
           &msg::kKeySecondLingual},
    KeyRow{KeyId::SecondMesial, "second_mesial", "Ctrl+4", KeyKind::Shortcut, KeyGroup::View, &msg::kKeySecondMesial},
    KeyRow{KeyId::SecondDistal, "second_distal", "Ctrl+5", KeyKind::Shortcut, KeyGroup::View, &msg::kKeySecondDistal},
    KeyRow{KeyId::Mirror, "mirror", "M", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyMirror},
    KeyRow{KeyId::HoldMirror, "hold_mirror", "V", KeyKind::Single, KeyGroup::View, &msg::kKeyHoldMirror},
    KeyRow{KeyId::PlaceMirror, "place_mirror", "Shift+M", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyPlaceMirror},
    KeyRow{KeyId::ParkMirror, "park_mirror", "Ctrl+Shift+M", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyParkMirror},
    KeyRow{KeyId::Distance, "distance", "I", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyDistance},
    KeyRow{KeyId::Angle, "angle", "Shift+I", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyAngle},
    KeyRow{KeyId::Taper, "taper", "Y", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyTaper},
    KeyRow{KeyId::RemainingDentin, "remaining_dentin", "P", KeyKind::Shortcut, KeyGroup::View,
           &msg::kKeyRemainingDentin},
    KeyRow{KeyId::Turbine, "turbine", "H", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyTurbine},
    KeyRow{KeyId::Aim, "aim", "J", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyAim},
    KeyRow{KeyId::Ghost, "ghost", "G", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyGhost},
    KeyRow{KeyId::Glass, "glass", "L", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyGlass},
    KeyRow{KeyId::Magnifier, "magnifier", "Z", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyMagnifier},
    KeyRow{KeyId::ScaleBar, "scale_bar", "R", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyScaleBar},
    KeyRow{KeyId::SoftTissues, "soft_tissues", "O", KeyKind::Shortcut, KeyGroup::View, &msg::kKeySoftTissues},
    KeyRow{KeyId::Letters, "letters", "A", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyLetters},
    KeyRow{KeyId::Cube, "cube", "K", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyCube},
    KeyRow{KeyId::Fogged, "fogged", "B", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyFogged},
    KeyRow{KeyId::Drops, "drops", "D", KeyKind::Shortcut, KeyGroup::View, &msg::kKeyDrops},
    KeyRow{KeyId::Welcome, "welcome", "Ctrl+N", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyWelcome},
    KeyRow{KeyId::Open, "open", "Ctrl+O", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyOpen},
    KeyRow{KeyId::Import, "import", "Ctrl+I", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyImport},
    KeyRow{KeyId::Chart, "chart", "Ctrl+T", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyChart},
    KeyRow{KeyId::Burs, "burs", "Ctrl+B", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyBurs},
    KeyRow{KeyId::Save, "save", "Ctrl+S", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeySave},
    KeyRow{KeyId::Export, "export", "Ctrl+Shift+S", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyExport},
    KeyRow{KeyId::Finish, "finish", "Ctrl+E", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyFinish},
    KeyRow{KeyId::Dark, "dark", "Ctrl+D", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyDark},
    KeyRow{KeyId::Mute, "mute", "Ctrl+M", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyMute},
    KeyRow{KeyId::Help, "help", "F1", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyHelp},
    KeyRow{KeyId::Settings, "settings", "Ctrl+,", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeySettings},
    KeyRow{KeyId::Quit, "quit", "Ctrl+Q", KeyKind::Shortcut, KeyGroup::Program, &msg::kKeyQuit},
    KeyRow{KeyId::ReplayPlay, "replay_play", "Space", KeyKind::Shortcut, KeyGroup::Replay, &msg::kKeyReplayPlay},
    KeyRow{KeyId::ReplayPrevious, "replay_previous", "Ctrl+PgUp", KeyKind::Shortcut, KeyGroup::Replay,
           &msg::kKeyReplayPrevious},
    KeyRow{KeyId::ReplayBack, "replay_back", ",", KeyKind::Shortcut, KeyGroup::Replay, &msg::kKeyReplayBack},
    KeyRow{KeyId::ReplayOn, "replay_on", ".", KeyKind::Shortcut, KeyGroup::Replay, &msg::kKeyReplayOn},
    KeyRow{KeyId::ReplayNext, "replay_next", "Ctrl+PgDown", KeyKind::Shortcut, KeyGroup::Replay, &msg::kKeyReplayNext},
    KeyRow{KeyId::ReplaySideBySide, "replay_side_by_side", "Shift+S", KeyKind::Shortcut, KeyGroup::Replay,
           &msg::kKeyReplaySideBySide},
    KeyRow{KeyId::ReplayLeave, "replay_leave", "Esc", KeyKind::Shortcut, KeyGroup::Replay, &msg::kKeyReplayLeave},
};

/// A row is found by its place.
constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        if (static_cast<std::size_t>(kRows[i].id) != i) return false;
    }
    return true;
}
static_assert(isInOrder());

constexpr std::array kMouse = {
    FixedControls::Row{&msg::kMouseMoveWhat, &msg::kMouseMove},
    FixedControls::Row{&msg::kMouseLeftWhat, &msg::kMouseLeft},
    FixedControls::Row{&msg::kMouseWheelWhat, &msg::kMouseWheel},
    FixedControls::Row{&msg::kMouseRightWhat, &msg::kMouseRight},
    FixedControls::Row{&msg::kMouseMiddleWhat, &msg::kMouseMiddle},
    FixedControls::Row{&msg::kMouseCubeWhat, &msg::kMouseCube},
};
constexpr std::array kPad = {
    FixedControls::Row{&msg::kPadSticksWhat, &msg::kPadSticks},
    FixedControls::Row{&msg::kPadLeftWhat, &msg::kPadLeft},
    FixedControls::Row{&msg::kPadRightWhat, &msg::kPadRight},
    FixedControls::Row{&msg::kPadButtonsWhat, &msg::kPadButtons},
    FixedControls::Row{&msg::kPadCrossWhat, &msg::kPadCross},
    FixedControls::Row{&msg::kPadPressedWhat, &msg::kPadPressed},
    FixedControls::Row{&msg::kPadMirrorWhat, &msg::kPadMirror},
    FixedControls::Row{&msg::kPadMeasureWhat, &msg::kPadMeasure},
    FixedControls::Row{&msg::kPadMenusWhat, &msg::kPadMenus},
    FixedControls::Row{&msg::kPadFrontWhat, &msg::kPadFront},
};
constexpr std::array kEverywhere = {
    FixedControls::Row{&msg::kFixedTabWhat, &msg::kFixedTab},
    FixedControls::Row{&msg::kFixedAltWhat, &msg::kFixedAlt},
    FixedControls::Row{&msg::kFixedEscapeWhat, &msg::kFixedEscape},
};

constexpr std::array kControls = {FixedControls{&msg::kKeyGroupMouse, kMouse}, FixedControls{&msg::kKeyGroupPad, kPad},
                                  FixedControls{&msg::kKeyGroupFixed, kEverywhere}};

}  // namespace

std::span<const KeyRow> keyTable() { return kRows; }

const KeyRow& keyRow(KeyId id) {
    const auto place = static_cast<std::size_t>(id);
    TACTOOTH_ASSERT(place < kRows.size());
    return kRows[place];
}

const MessageText& titleOf(KeyGroup group) {
    switch (group) {
        case KeyGroup::Cutting:
            return msg::kKeyGroupCutting;
        case KeyGroup::View:
            return msg::kKeyGroupView;
        case KeyGroup::Program:
            return msg::kKeyGroupProgram;
        case KeyGroup::Replay:
            break;
    }
    return msg::kKeyGroupReplay;
}

std::span<const FixedControls> fixedControls() { return kControls; }

}  // namespace tactooth
