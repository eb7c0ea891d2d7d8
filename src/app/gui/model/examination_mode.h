// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "journal/codec/signing_key.h"

namespace tactooth {

class SessionModel;

/// Whether the session is an examination, and what that forbids. It alone decides; menus, panels and controllers ask.
class ExaminationMode final : public QObject {
    Q_OBJECT

public:
    /// `model` outlives the mode.
    explicit ExaminationMode(SessionModel& model) : model_(model) {}

    [[nodiscard]] bool isOn() const { return seal_ != nullptr; }
    /// Signs the recordings; null if there is no examination.
    [[nodiscard]] const std::shared_ptr<const SigningKey>& seal() const { return seal_; }

    /// Undo, redo, the history, and the whole tooth again.
    [[nodiscard]] bool allowsTakingBack() const { return !isOn(); }
    /// Forces, depths, volumes, scores and what they are made of.
    [[nodiscard]] bool showsNumbers() const { return !isOn(); }
    /// The target as ghost or colours, and all other looks into the tooth.
    [[nodiscard]] bool showsTarget() const { return !isOn(); }
    /// Distances and angles on the tooth.
    [[nodiscard]] bool allowsMeasuring() const { return !isOn(); }
    [[nodiscard]] bool allowsReplay() const { return !isOn(); }
    /// Another tooth: not once this one was touched, since that would be another attempt.
    [[nodiscard]] bool allowsAnotherTooth() const;

    /// Begins an examination on a tooth that nobody has touched. `seal` is not null.
    void begin(std::shared_ptr<const SigningKey> seal);
    void finish();

signals:
    /// It has begun, or is over.
    void changed();

private:
    SessionModel& model_;
    std::shared_ptr<const SigningKey> seal_;
};

}  // namespace tactooth
