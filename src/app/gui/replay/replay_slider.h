// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>
#include <vector>

namespace tactooth {

/// The time line of a recording: a slider with marks where something happened. What is not simulated yet is grey.
class ReplaySlider final : public QSlider {
    Q_OBJECT

public:
    explicit ReplaySlider(QWidget* parent = nullptr);

    struct Mark {
        double time = 0;  ///< s
        QString text;
        bool isComment = false;

        friend bool operator==(const Mark&, const Mark&) = default;
    };
    /// By rising time.
    void setMarks(std::vector<Mark> marks);
    [[nodiscard]] const std::vector<Mark>& marks() const { return marks_; }
    /// `length`, and how much of it is there, s.
    void setLength(double length, double ready);
    /// Shows a time without a signal, s. It has no effect while the user holds the handle.
    void show(double time);

signals:
    /// The user has moved the handle there, s.
    void timeChosen(double time);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] double timeAt(double x) const;
    [[nodiscard]] double xOf(double time) const;

    std::vector<Mark> marks_;
    double length_ = 0, ready_ = 0;  // s
};

}  // namespace tactooth
