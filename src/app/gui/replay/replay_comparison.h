// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <memory>
#include <optional>

#include "app/gui/replay/first_touch.h"
#include "app/gui/replay/replay_source.h"
#include "app/gui/settings/window_settings.h"
#include "session/model/task.h"

namespace tactooth {

class FileDialogs;
class WindowMessages;

/// The other recording that is compared with the first: which it is, how it is shown, and how far it is shifted in
/// time. Until the user shifts it, both touch the tooth first at the same moment.
class ReplayComparison final : public QObject {
    Q_OBJECT

public:
    enum class Mode {
        Ghost,      ///< blue, in the picture of the first
        SideBySide  ///< in a picture of its own
    };

    ReplayComparison(WindowMessages& messages, FileDialogs& files);

    /// The entry of the menu and the button: shows both side by side; once more brings back what was before.
    [[nodiscard]] QAction& sideBySideAction() { return action_; }
    /// How the next other recording is shown; the window remembers it.
    [[nodiscard]] Mode usualMode() const { return usualMode_; }
    void restore(const WindowSettings& settings) { usualMode_ = settings.sideBySide ? Mode::SideBySide : Mode::Ghost; }
    void store(WindowSettings& settings) const { settings.sideBySide = usualMode_ == Mode::SideBySide; }

    /// The recording that others are compared with; null: none is shown. The other one is closed.
    void setFirst(std::shared_ptr<const SessionTrack> first);
    /// Opens another recording in the background, to be shown in this mode.
    void open(const QString& file, Mode mode);
    /// Opens one that the user chooses, or closes the one that is open.
    void toggle();
    void close();
    /// Gives the other recording away, to become the first.
    [[nodiscard]] std::shared_ptr<ReplaySource> release();
    /// Call it now and then: takes what has been opened, and aligns it.
    void poll();

    [[nodiscard]] bool isOpening() const { return opening_.isBusy(); }
    /// Null: there is none.
    [[nodiscard]] const std::shared_ptr<ReplaySource>& source() const { return source_; }
    [[nodiscard]] bool isGhost() const { return source_ != nullptr && mode_ == Mode::Ghost; }
    [[nodiscard]] bool isSideBySide() const { return source_ != nullptr && mode_ == Mode::SideBySide; }
    /// How much later than the first it begins on the time line, s.
    [[nodiscard]] double shift() const { return shift_; }
    /// Shifts it by hand.
    void setShift(double shift);
    /// Shifts it so that both touch the tooth first at the same moment.
    void align();

signals:
    /// Which recording it is, how it is shown, or its shift.
    void changed();

private:
    void ask(Mode mode);
    void toggleSideBySide();
    void followFirstTouch();
    void showState();

    WindowMessages& messages_;
    FileDialogs& files_;
    QAction action_;
    Task<std::shared_ptr<ReplaySource>> opening_;
    std::shared_ptr<const SessionTrack> first_;
    std::shared_ptr<ReplaySource> source_;
    Mode usualMode_ = Mode::Ghost;
    Mode mode_ = Mode::Ghost;
    bool wasGhost_ = false;                              // before it was shown side by side
    double shift_ = 0;                                   // s
    std::optional<FirstTouch> firstTouch_, otherTouch_;  // while they are looked for
};

}  // namespace tactooth
