// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressRange.hxx>

#include <functional>
#include <utility>

namespace burin {

/// Called by the reader with its progress, 0 … 1.
using ReportFraction = std::function<void(double)>;

/// Maps OpenCASCADE's progress of one step to the interval low … high of the total progress.
class ReaderProgress final : public Message_ProgressIndicator {
public:
    ReaderProgress(ReportFraction report, double low, double high)
        : report_(std::move(report)), low_(low), high_(high) {
        report_(low_);
    }
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {
        report_(low_ + (high_ - low_) * GetPosition());
    }

private:
    ReportFraction report_;
    double low_, high_;
};

} // namespace burin
