// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/panels/plot_colours.h"
#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_source.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "geometry/files/file_bytes.h"

namespace tactooth {
namespace {

bool isSameView(const OrbitCamera& a, const OrbitCamera& b) {
    return a.target() == b.target() && a.distance() == b.distance() && a.direction().azimuth == b.direction().azimuth &&
           a.direction().elevation == b.direction().elevation;
}

}  // namespace

ReplayPanel::ReplayPanel(SoundOutput& sound, QWidget* parent)
    : QWidget(parent),
      sound_(sound),
      sign_(new QLabel),
      first_(new ReplayPicture(sound, "replayView", kFirstRecordingColour)),
      pictures_(new QWidget),
      bar_(new ReplayBar) {
    setObjectName("replayPanel");
    sign_->setObjectName("replaySign");
    sign_->setAlignment(Qt::AlignCenter);
    sign_->setTextFormat(Qt::PlainText);
    sign_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    sign_->setStyleSheet("background: #b45309; color: white; font-weight: bold; padding: 3px;");
    auto* row = new QHBoxLayout(pictures_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    row->addWidget(first_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(sign_);
    column->addWidget(pictures_, 1);
    column->addWidget(bar_);
}

void ReplayPanel::setSource(const ReplaySource& source) {
    first_->setSource(source);
    QStringList parts = {tr("Replay"), translated(source.facts().title)};
    if (!source.facts().date.empty()) parts << QString::fromStdString(source.facts().date);
    parts << QString::fromStdString(displayName(source.file().filename()));
    sign_->setText(parts.join(" — "));
    sign_->setToolTip(tr("Nothing can be cut here. The tooth on the bench waits unchanged."));
}

void ReplayPanel::addOther(const ReplaySource& source) {
    removeOther();
    other_ = new ReplayPicture(sound_, "replayOtherView", kOtherRecordingColour);
    other_->setSource(source);
    shared_ = first_->view().orbitCamera();
    other_->view().setOrbitCamera(shared_);
    pictures_->layout()->addWidget(other_);
    static_cast<QHBoxLayout*>(pictures_->layout())->setStretchFactor(other_, 1);
    for (ReplayPicture* picture : {first_, other_}) picture->setShowsCaption(true);
}

/// Later: its own button may have been clicked.
void ReplayPanel::removeOther() {
    if (other_ == nullptr) return;
    other_->view().setContents({});  // they are of somebody else
    other_->view().setObjectName({});
    other_->hide();
    std::exchange(other_, nullptr)->deleteLater();
    first_->setShowsCaption(false);
}

void ReplayPanel::coupleCameras() {
    if (other_ == nullptr) return;
    for (const ReplayPicture* turned : {first_, other_}) {
        if (isSameView(turned->view().orbitCamera(), shared_)) continue;
        shared_ = turned->view().orbitCamera();
        (turned == first_ ? other_ : first_)->view().setOrbitCamera(shared_);
        return;
    }
}

}  // namespace tactooth
