// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The cutting force over the run time of a program without its tool changes, which are marked: the maximum in each
/// pixel column, with the peak labelled in N. A click selects the program line of the motion at that time.
class LoadChart : public QWidget {
    Q_OBJECT
public:
    explicit LoadChart(QWidget* parent = nullptr);
    /// Sets the report whose loads are shown; null: none. Does nothing if it is already shown.
    void setReport(std::shared_ptr<const VerifyReport> report);
    void showTime(std::optional<double> seconds); ///< marks a time; std::nullopt: no mark

    QSize sizeHint() const override;

signals:
    void lineChosen(int line); ///< from 1

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    std::span<const LoadStep> loads() const;
    /// A tool change, during which nothing is cut.
    struct Pause {
        double start = 0.0, length = 0.0; ///< s, program time
    };
    double seconds() const;                       ///< the total time that the chart shows, s
    double shownAt(double time) const;            ///< chart time of a program time, s
    double timeAt(double shown) const;            ///< the inverse of `shownAt`; where a pause is, the time after it
    std::vector<double> columns(int count) const; ///< maximum force in each column, N
    const MotionLoad* at(double seconds) const;   ///< the load at that time, or the last one before it
    void choose(double x);

    std::shared_ptr<const VerifyReport> report_;
    std::vector<Pause> pauses_; ///< in ascending order
    double peak_ = 0.0;         ///< N
    std::optional<double> time_;
};

} // namespace burin
