// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QTimer>
#include <QToolBar>
#include <functional>
#include <optional>
#include <vector>

#include "assessment/exercise.h"
#include "instruments/hand_instruments.h"
#include "instruments/spindle.h"
#include "session/model/instrument_set.h"

class QActionGroup;

namespace tactooth {

/// The tool bar with a picture of each instrument: the handpieces of the drives, and the hand instruments. The pictures
/// come one after the other while the window is in use already.
class InstrumentTray final : public QToolBar {
    Q_OBJECT

public:
    explicit InstrumentTray(QWidget* parent = nullptr);

    /// Shows what is in the hand; emits nothing. `drive`: name of the preset; it counts if there is no hand instrument.
    void show(std::optional<HandInstrument> hand, const QString& drive);
    using Rule = std::function<bool(const TrayInstrument& instrument)>;
    /// Offers only what the rule allows, and says at the rest why; without a rule all. What is in the hand stays.
    void setAllowed(const Rule& rule);
    /// From now on the handpieces can be drawn.
    void setHandpieces(const HandpieceMeshes& handpieces);
    [[nodiscard]] bool isDrawing() const;

signals:
    void handpieceChosen(const SpindlePreset& drive);
    void handInstrumentChosen(HandInstrument kind);

private:
    /// One of them is null.
    struct Place {
        QAction* action;
        const SpindlePreset* drive;
        const HandInstrumentSpec* hand;
        QString tip;  // with %1 for the key
        bool isDrawn = false;
    };
    void add(const Place& place, const char* icon);
    void choose(const QAction* action);
    [[nodiscard]] QImage drawn(const Place& place, QSize size) const;
    void drawNext();

    QActionGroup* group_;
    std::vector<Place> places_;
    std::optional<HandpieceMeshes> handpieces_;
    QTimer drawing_;
};

}  // namespace tactooth
