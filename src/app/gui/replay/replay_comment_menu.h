// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "session/track/replay_comments.h"

class QMenu;
class QWidget;

namespace tactooth {

class WindowMessages;

/// The comments on a recording: asks for their texts, lists them, and removes them.
class ReplayCommentMenu final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive this object.
    ReplayCommentMenu(QMenu& menu, WindowMessages& messages, QWidget& window);

    /// The comments on another recording. A damaged file is reported; then there are none, and none can be added.
    void open(const std::filesystem::path& recording);
    [[nodiscard]] std::vector<ReplayComment> all() const;
    /// Asks for a comment at this time, s.
    void askFor(double time);
    /// Pins a comment; reports if it cannot be written.
    void add(double time, const QString& text);
    /// The cursor is at this time, s: its comment can be removed.
    void setTime(double time) { time_ = time; }

signals:
    void changed();
    /// The user has chosen a comment of this time, s.
    void timeChosen(double time);

private:
    void fill();
    [[nodiscard]] std::optional<std::size_t> here() const;

    QMenu& menu_;
    WindowMessages& messages_;
    QWidget& window_;
    std::optional<ReplayComments> comments_;  // none: the file is damaged
    double time_ = 0;                         // of the cursor, s
};

}  // namespace tactooth
