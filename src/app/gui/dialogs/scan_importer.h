// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <atomic>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/gui/dialogs/import_dialog.h"
#include "app/gui/model/recent_file.h"
#include "session/model/session_tooth.h"
#include "session/model/task.h"

namespace tactooth {

/// Imports a scan from files: reads it, shows the assumptions to the user, and makes the layers. Background threads do
/// the work; it ends early when the user cancels. A second scan replaces the first.
class ScanImporter final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~ScanImporter() override;

    /// `files`: surfaces of one tooth, either one file or layers named as for a case (case_names.h). `parent` owns the
    /// dialog.
    void begin(const std::vector<std::filesystem::path>& files, QWidget* parent);
    /// Takes over finished work. Call it often from the window's thread; it returns at once.
    void poll();
    [[nodiscard]] bool isBusy() const { return examining_.isBusy() || building_.isBusy(); }

signals:
    /// `from`: the surfaces, or the case that was made of them.
    void imported(SessionTooth tooth, RecentFile from);
    void failed(const QString& sentence);

private:
    struct Examined {
        std::shared_ptr<const Scan> scan;
        Expected<ExaminedScan> examined;
        std::shared_ptr<const Surface> shown;  // null if it cannot be imported
    };
    struct Control {
        std::atomic<double> part{0};
        std::atomic<bool> stops{false};
    };
    void examine();
    void build();
    void stop();

    std::vector<std::filesystem::path> files_;
    RecentFile from_;  // what is being built
    QPointer<ImportDialog> dialog_;
    std::shared_ptr<const Scan> scan_;  // null until it is read
    std::shared_ptr<const ExaminedScan> examined_;
    std::shared_ptr<Control> control_;
    Task<Examined> examining_;
    Task<SessionTooth> building_;
};

}  // namespace tactooth
