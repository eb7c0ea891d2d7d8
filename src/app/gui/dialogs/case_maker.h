// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/gui/dialogs/case_dialog.h"
#include "session/model/task.h"

namespace tactooth {

/// Makes a case from folders of scans: imports the surfaces in the background, shows what was assumed to the user, and
/// writes the case. It ends early when the user cancels. A second folder replaces the first.
class CaseMaker final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~CaseMaker() override;

    /// `from`: folders, or surfaces. `parent` owns the dialog.
    void begin(const std::vector<std::filesystem::path>& from, QWidget* parent);
    /// Writes the case that is shown.
    void write(const QString& file);
    /// Takes over finished work. Call it often from the window's thread; it returns at once.
    void poll();
    [[nodiscard]] bool isBusy() const { return making_.isBusy() || writing_.isBusy(); }

signals:
    /// The user accepts the case, which has no file yet. `proposed`: a file beside the folder that does not exist.
    void fileWanted(const QString& proposed);
    void written(const QString& file);
    void failed(const QString& sentence);

private:
    struct Control {
        std::mutex mutex;
        std::string body;  // that is being imported
        double part = 0;
        std::atomic<bool> stops{false};
    };
    void make();
    void stop();

    std::vector<std::filesystem::path> from_;
    QPointer<CaseDialog> dialog_;
    std::shared_ptr<const NewCase> made_;  // null until it is made
    std::shared_ptr<Control> control_;
    Task<NewCase> making_;
    Task<std::filesystem::path> writing_;
};

}  // namespace tactooth
