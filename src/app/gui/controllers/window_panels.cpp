// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/controllers/window_panels.h"

#include <QProgressBar>

#include "app/gui/dialogs/guided_tour.h"
#include "app/gui/panels/device_panel.h"
#include "app/gui/panels/drill_bar.h"
#include "app/gui/panels/drive_panel.h"
#include "app/gui/panels/event_panel.h"
#include "app/gui/panels/exercise_panel.h"
#include "app/gui/panels/force_panel.h"
#include "app/gui/panels/history_panel.h"
#include "app/gui/panels/inspection_panel.h"
#include "app/gui/panels/instrument_tray.h"
#include "app/gui/panels/plot_panel.h"
#include "app/gui/panels/sound_panel.h"
#include "app/gui/panels/status_line.h"
#include "app/gui/panels/timing_panel.h"
#include "app/gui/scene/tooth_view.h"

namespace tactooth {

WindowPanels::WindowPanels(SessionModel& model, QObject& owner)
    : view(new ToothView(model)),
      drill(new DrillBar),
      tray(new InstrumentTray),
      drive(new DrivePanel),
      force(new ForcePanel),
      inspection(new InspectionPanel),
      device(new DevicePanel),
      sound(new SoundPanel),
      plots(new PlotPanel),
      events(new EventPanel),
      history(new HistoryPanel),
      exercise(new ExercisePanel),
      timing(new TimingPanel),
      status(new StatusLine),
      busy(new QProgressBar),
      tour(new GuidedTour(model, *view, *drill, *drive, &owner)) {}

}  // namespace tactooth
