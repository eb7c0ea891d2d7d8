// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_picture.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/common/recorded_eye.h"
#include "app/gui/input/picture_pixels.h"
#include "app/gui/panels/elided_label.h"
#include "app/gui/replay/clock_text.h"
#include "app/gui/replay/replay_source.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "geometry/files/file_bytes.h"
#include "session/recording/mirror_moments.h"

namespace tactooth {

ReplayPicture::ReplayPicture(SoundOutput& sound, const QString& name, const QColor& colour, QWidget* parent)
    : QWidget(parent), model_(sound), view_(new ToothView(model_)), title_(new ElidedLabel), clock_(new QLabel) {
    constexpr int kNarrowest = 200;  // pixels: two of them fit beside the docks of a small screen
    view_->setObjectName(name);
    view_->setMinimumWidth(kNarrowest);
    caption_ = makeCaption(name, colour);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(caption_);
    caption_->hide();
}

/// The view uses the model.
ReplayPicture::~ReplayPicture() { delete view_; }

QWidget* ReplayPicture::makeCaption(const QString& name, const QColor& colour) {
    auto* caption = new QWidget;
    auto* row = new QHBoxLayout(caption);
    row->setContentsMargins(6, 2, 6, 2);
    auto* mark = new QLabel;
    constexpr int kMark = 12;  // pixels
    mark->setFixedSize(kMark, kMark);
    mark->setStyleSheet(QString("background: %1;").arg(colour.name()));
    mark->setToolTip(tr("The colour of this recording in the plots"));
    title_->setObjectName(name + "Title");
    clock_->setObjectName(name + "Clock");
    auto* close = new QToolButton;
    close->setObjectName(name + "Close");
    close->setText("✕");
    close->setAutoRaise(true);
    close->setToolTip(tr("Closes this recording; the other one stays"));
    close->setAccessibleName(close->toolTip());
    connect(close, &QToolButton::clicked, this, &ReplayPicture::closeWanted);
    row->addWidget(mark);
    row->addWidget(title_, 1);
    row->addWidget(clock_);
    row->addWidget(close);
    return caption;
}

void ReplayPicture::setSource(const ReplaySource& source) {
    SessionTooth tooth;
    tooth.name = source.facts().title;
    tooth.piece = source.uncut();
    model_.install(std::move(tooth));
    title_->setText(QString("%1 — %2").arg(QString::fromStdString(displayName(source.file().filename())),
                                           translated(source.facts().title)));
    view_->resetView();
    if (const auto eye = firstEye(source.track()->mirror())) {
        view_->setOrbitCamera(lookingFrom(view_->orbitCamera(), *eye, pictureSize(*view_)));
    }
}

void ReplayPicture::setShowsCaption(bool shows) { caption_->setVisible(shows); }

void ReplayPicture::showTime(double time, double length) {
    const QString text = QString("%1 / %2").arg(clockText(std::min(time, length)), clockText(length));
    if (text != clock_->text()) clock_->setText(text);
}

HandpieceMeshes ReplayPicture::handpieces() {
    model_.instruments().poll();
    const std::optional<InstrumentMeshes>& meshes = model_.instruments().meshes();
    return meshes ? meshes->handpieces : HandpieceMeshes();
}

}  // namespace tactooth
