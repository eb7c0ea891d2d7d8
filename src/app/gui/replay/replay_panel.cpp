// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/replay/replay_panel.h"

#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/replay/replay_bar.h"
#include "app/gui/replay/replay_source.h"
#include "app/gui/scene/tooth_view.h"
#include "app/gui/text/translation.h"
#include "geometry/files/file_bytes.h"

namespace tactooth {

ReplayPanel::ReplayPanel(SoundOutput& sound, QWidget* parent)
    : QWidget(parent), model_(sound), sign_(new QLabel), view_(new ToothView(model_)), bar_(new ReplayBar) {
    setObjectName("replayPanel");
    view_->setObjectName("replayView");
    sign_->setObjectName("replaySign");
    sign_->setAlignment(Qt::AlignCenter);
    sign_->setTextFormat(Qt::PlainText);
    sign_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    sign_->setStyleSheet("background: #b45309; color: white; font-weight: bold; padding: 3px;");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(sign_);
    column->addWidget(view_, 1);
    column->addWidget(bar_);
}

/// The view uses the model.
ReplayPanel::~ReplayPanel() { delete view_; }

void ReplayPanel::setSource(const ReplaySource& source) {
    SessionTooth tooth;
    tooth.name = source.facts().title;
    tooth.piece = source.uncut();
    model_.install(std::move(tooth));
    QStringList parts = {tr("Replay"), translated(source.facts().title)};
    if (!source.facts().date.empty()) parts << QString::fromStdString(source.facts().date);
    parts << QString::fromStdString(displayName(source.file().filename()));
    sign_->setText(parts.join(" — "));
    sign_->setToolTip(tr("Nothing can be cut here. The tooth on the bench waits unchanged."));
    view_->resetView();
}

HandpieceMeshes ReplayPanel::handpieces() {
    model_.instruments().poll();
    const std::optional<InstrumentMeshes>& meshes = model_.instruments().meshes();
    return meshes ? meshes->handpieces : HandpieceMeshes();
}

}  // namespace tactooth
