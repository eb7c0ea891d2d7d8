// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <vector>

#include "app/gui/controllers/window_panels.h"
#include "app/gui/model/long_work.h"
#include "app/gui/settings/window_settings.h"
#include "session/model/session_model.h"

namespace tactooth {

class ExaminationMode;
class InstrumentMenus;

/// Undo, Redo and the history panel. Notes what the user changes besides cutting: bur, drive, water, suction, mirror,
/// force parameters, and what is seen of the tooth.
class HistoryActions final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive the controller.
    HistoryActions(SessionModel& model, const ExaminationMode& mode, const WindowPanels& panels,
                   InstrumentMenus& instruments);

    /// Another runner has started: maybe with another bur.
    void takeRunner();
    /// Notes what has changed since the last call, and shows the history. Call it some times a second.
    void update();
    /// An undo, a redo or a jump that is under way.
    [[nodiscard]] std::optional<LongWork> undoing();

private:
    /// What can be changed, as the window keeps it.
    struct Setup {
        WindowSettings settings;  // spindle, mirror, water, suction, force
        int enamel = 0, dentin = 0;
    };
    /// One thing of it.
    struct Aspect {
        QString name;
        std::function<bool(const Setup&, const Setup&)> isSame;
        std::function<void(const Setup&)> apply;
    };

    void addAspects();
    [[nodiscard]] Setup setup() const;
    void note(const Aspect& aspect, int kind, const Setup& before, const Setup& after);
    void install(const SessionBur& bur);

    SessionModel& model_;
    const ExaminationMode& mode_;
    WindowPanels panels_;
    InstrumentMenus& instruments_;
    std::vector<Aspect> aspects_;
    Setup seen_;
    const CutModel* seenTooth_ = nullptr;
    std::optional<SessionBur> seenBur_;
    const ToolShape* expectedBur_ = nullptr;  // that undo or redo puts into the handpiece
};

}  // namespace tactooth
