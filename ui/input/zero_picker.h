// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/box.h"
#include "core/setup/program_zero.h"
#include "ui/input/face_picker.h"

namespace burin {

/// Picks a point of the part or of the stock's box: the next click selects it; the part has priority, as the stock
/// hides it. Esc cancels. Thread: user interface.
class ZeroPicker final : public FacePicker {
    Q_OBJECT
public:
    using FacePicker::FacePicker;
    void setStock(const Box& stock) { stock_ = stock; } ///< mm, setup frame; empty: none

    bool press(const ViewportEvent& event) override;
    bool release(const ViewportEvent& event) override;
    QString escapeMeaning() override;

signals:
    /// The corner, or middle of an edge or face, of the box nearest to the intersection with the line of sight.
    void stockChosen(const std::array<burin::BoxSide, 3>& sides);

private:
    Box stock_;
    bool taken_ = false; ///< the current press was on the stock
};

/// The intersection of a line of sight with a box from outside; empty: none.
std::optional<glm::dvec3> boxOn(const Sight& sight, const Box& box) noexcept;

} // namespace burin
