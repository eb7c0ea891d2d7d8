// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QObject;
class QProgressBar;

namespace tactooth {

class DevicePanel;
class DrillBar;
class DrivePanel;
class EventPanel;
class ExercisePanel;
class ForcePanel;
class GuidedTour;
class HistoryPanel;
class InspectionPanel;
class InstrumentTray;
class PlotPanel;
class SessionModel;
class SoundPanel;
class StatusLine;
class TimingPanel;
class ToothView;

/// The widgets of the window and the guided tour through them. DockLayout gives the widgets to the window, which then
/// owns them.
struct WindowPanels {
    /// `model` outlives them; `owner` owns the tour.
    WindowPanels(SessionModel& model, QObject& owner);

    ToothView* view;
    DrillBar* drill;
    InstrumentTray* tray;
    DrivePanel* drive;
    ForcePanel* force;
    InspectionPanel* inspection;
    DevicePanel* device;
    SoundPanel* sound;
    PlotPanel* plots;
    EventPanel* events;
    HistoryPanel* history;
    ExercisePanel* exercise;
    TimingPanel* timing;
    StatusLine* status;
    QProgressBar* busy;
    GuidedTour* tour;
};

}  // namespace tactooth
