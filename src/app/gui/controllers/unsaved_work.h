// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMessageBox>
#include <QObject>
#include <QPointer>
#include <functional>
#include <optional>

namespace tactooth {

class FileWriter;
class SessionModel;

/// Asks before cuts are lost that were neither saved nor exported, and before an exercise is lost that is being made.
/// Whatever replaces the tooth or ends the program goes through `confirmDiscard`, and nothing else may: ToothController
/// does it for all that loads a tooth, and the window when it closes.
class UnsavedWork final : public QObject {
    Q_OBJECT

public:
    /// All of them outlive it; `window` shows a star in its title while there are such cuts.
    UnsavedWork(SessionModel& model, const FileWriter& writer, QWidget& window)
        : model_(model), writer_(writer), window_(window) {}

    using Function = std::function<void()>;
    /// Lets the user save, and calls its argument if the tooth was saved.
    using Saver = std::function<void(Function saved)>;
    void setSaver(Saver saver) { save_ = std::move(saver); }

    /// Other work that is lost with the tooth: an exercise that is being made.
    struct Other {
        std::function<bool()> isUnsaved;
        /// Asks about it: calls `then` where it was saved or may be lost, `otherwise` where it may not.
        std::function<void(Function then, Function otherwise)> confirm;
    };
    void setOther(Other other) { other_ = std::move(other); }
    /// Whether anything would be asked.
    [[nodiscard]] bool isUnsaved() const;

    /// Calls `then` at once if nothing is lost by it. Otherwise it asks, and returns at once: Save calls `then` after
    /// the tooth was saved, unless it was cut meanwhile; Discard calls it, Cancel calls `otherwise`. While a question
    /// is open, another one is cancelled. While a file is being written, which may be the tooth, it asks afterwards.
    void confirmDiscard(Function then, const Function& otherwise = {});
    /// Brings the star up to date, and asks what was to wait for a file. Call it in every step.
    void update();

private:
    struct Waiting {
        Function then, otherwise;
    };
    void confirmCuts(Function then, const Function& otherwise);

    SessionModel& model_;
    const FileWriter& writer_;
    QWidget& window_;
    Saver save_;
    Other other_;
    QPointer<QMessageBox> question_;
    std::optional<Waiting> waiting_;  // for a file
};

}  // namespace tactooth
