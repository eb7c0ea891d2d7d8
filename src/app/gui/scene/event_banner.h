// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "session/simulation/cut_events.h"

namespace tactooth {

/// A sentence in the picture, where the student looks: what has just happened at the tooth. It goes by itself, and the
/// mouse works through it.
class EventBanner final : public QWidget {
    Q_OBJECT

public:
    /// At the top of `picture`, and as long as it lives.
    explicit EventBanner(QWidget* picture);

    /// How much an event matters to the one who cuts.
    enum class Weight {
        None,     ///< no banner
        Caution,  ///< to be noticed
        Harm      ///< the tooth or another one is harmed
    };
    [[nodiscard]] static Weight weightOf(CutEventKind kind);

    /// Shows an event of some weight for some seconds. Harm is not replaced by less while it is shown.
    /// Whether it is shown.
    bool announce(CutEventKind kind);
    /// The sentence that is shown; empty while the banner is hidden.
    [[nodiscard]] QString text() const { return isHidden() ? QString() : text_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    QString text_;
    Weight weight_ = Weight::None;
    QTimer gone_;
};

}  // namespace tactooth
