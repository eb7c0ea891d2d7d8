// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/manual/context_help.h"

#include <QWidget>
#include <array>

namespace tactooth {
namespace {

constexpr const char* kFirst = "user/first-ten-minutes.md";

/// A class or an object name, and what explains it.
struct Row {
    const char* what;
    const char* page;
    int section = 0;
};
/// The first row that fits counts: the picture of a replay is a picture, too.
constexpr std::array kRows = {
    Row{"tactooth::ReplayPanel", "user/replay.md"},
    Row{"finishExamination", "user/examinations.md"},
    Row{"tactooth::EditorPanel", "user/editor.md"},
    Row{"tactooth::ReportDialog", "user/finish.md"},
    Row{"tactooth::HandInDialog", "user/finish.md"},
    Row{"tactooth::KeyEditor", "user/keys.md"},
    Row{"tactooth::ImportDialog", kFirst, 7},
    Row{"tactooth::OpenToothDialog", kFirst, 7},
    Row{"tactooth::SettingsDialog", kFirst, 10},
    Row{"tactooth::ToothView", "user/keys.md"},
    Row{"tactooth::DrillBar", kFirst, 3},
    Row{"tactooth::DrivePanel", kFirst, 3},
    Row{"tactooth::ForcePanel", kFirst, 3},
    Row{"tactooth::HistoryPanel", kFirst, 3},
    Row{"tactooth::DevicePanel", kFirst, 8},
    Row{"tactooth::InspectionPanel", kFirst, 5},
    Row{"tactooth::ExercisePanel", kFirst, 6},
    Row{"tactooth::PlotPanel", kFirst, 2},
    Row{"tactooth::EventPanel", kFirst, 10},
    Row{"tactooth::SoundPanel", kFirst, 10},
    Row{"tactooth::TimingPanel", kFirst, 10},
};

}  // namespace

ManualPlace manualPlaceFor(const QWidget* focus) {
    for (const Row& row : kRows) {
        for (const QWidget* each = focus; each != nullptr; each = each->parentWidget()) {
            if (each->inherits(row.what) || each->objectName() == row.what) return {row.page, row.section};
        }
    }
    return {kFirst, 0};
}

std::vector<ManualPlace> manualPlaces() {
    std::vector<ManualPlace> places = {{kFirst, 0}};
    for (const Row& row : kRows) places.push_back({row.page, row.section});
    return places;
}

}  // namespace tactooth
