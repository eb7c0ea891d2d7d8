// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <functional>

#include "app/gui/model/thumbnail_store.h"

namespace tactooth {

class SessionModel;
class ToothController;
class ToothView;

/// Keeps a thumbnail of each file that is opened or saved and of each recording that ends: the picture at rest.
class ThumbnailController final : public QObject {
    Q_OBJECT

public:
    /// What the picture shows.
    enum class Shown { Session, Recording, Loading };
    /// All of them outlive the controller.
    ThumbnailController(SessionModel& model, ToothView& view, ToothController& teeth, std::function<Shown()> shown);
    ~ThumbnailController() override;

    /// Takes the picture if it is another one at rest. Call it some times a second.
    void update();
    /// The picture to come shows this file.
    void expect(const QString& file);
    /// The picture shows this file, which was just written.
    void keep(const QString& file);

private:
    SessionModel& model_;
    ToothView& view_;
    std::function<Shown()> shown_;
    ThumbnailStore store_;
    QImage newest_;     // of the session at rest
    quint64 seen_ = 0;  // pictures that had been drawn when one was taken last
    QString expected_;  // file that the next picture at rest shows; empty: none
};

}  // namespace tactooth
