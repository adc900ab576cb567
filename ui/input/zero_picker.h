// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/setup/program_zero.h"
#include "ui/input/face_picker.h"

namespace burin {

/// Asks for a place of the part or of the stock's box: the next click on one of them answers, the part's first, as the
/// stock hides it. Esc cancels the question. Thread: user interface.
class ZeroPicker final : public FacePicker {
    Q_OBJECT
public:
    using FacePicker::FacePicker;
    void setStock(const Box& stock) { stock_ = stock; } ///< mm, setup frame; empty: none

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    QString escapeMeaning() override;

signals:
    /// Its corner, middle of an edge or face that is nearest to where the sight meets it.
    void stockChosen(const std::array<burin::BoxSide, 3>& sides);

private:
    Box stock_;
    bool taken_ = false; ///< the press that is under way was on the stock
};

/// Where a sight meets a box from outside; nothing: it does not.
std::optional<glm::dvec3> boxOn(const Sight& sight, const Box& box) noexcept;

} // namespace burin
