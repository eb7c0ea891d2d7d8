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
#include "session/model/session_tooth.h"
#include "session/model/task.h"

namespace tactooth {

/// Brings a scan from files to the bench: reads it, asks the person, makes the layers; all work is done by another
/// thread, and ends early when the person cancels. One scan at a time: another one takes the place of the first.
class ScanImporter final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;
    ~ScanImporter() override;

    /// Surfaces of one tooth: one file alone, or layers named as for a case (case_names.h). The dialog belongs to
    /// `parent`.
    void begin(const std::vector<std::filesystem::path>& files, QWidget* parent);
    /// Takes what has been done. Call often, from the window's thread; returns at once.
    void poll();
    [[nodiscard]] bool isBusy() const { return examining_.isBusy() || building_.isBusy(); }

signals:
    void imported(SessionTooth tooth);
    void failed(const QString& sentence);

private:
    struct Examined {
        std::shared_ptr<const Scan> scan;
        Expected<ExaminedScan> examined;
    };
    struct Control {
        std::atomic<double> part{0};
        std::atomic<bool> stops{false};
    };
    void examine();
    void build();
    void stop();

    std::vector<std::filesystem::path> files_;
    QPointer<ImportDialog> dialog_;
    std::shared_ptr<const Scan> scan_;  // null until it has been read
    std::shared_ptr<const ExaminedScan> examined_;
    std::shared_ptr<Control> control_;
    Task<Examined> examining_;
    Task<SessionTooth> building_;
};

}  // namespace tactooth
