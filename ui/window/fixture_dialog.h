// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/fixture_kind.h"
#include "ui/theme/length_unit.h"

#include <QDialog>
#include <QEvent>

#include <array>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace burin {

class ChoiceBox;
class FixtureDrawing;
class Notice;
class QuantityField;

/// What the dialog shows.
struct FixtureDialogState {
    FixtureDesign design;
    glm::dvec3 zero{0.0}; ///< program zero, mm, setup frame: positions are displayed relative to it
    LengthUnit unit = LengthUnit::millimetre;
    bool changing = false; ///< whether a fixture of the setup is being changed, whose kind stays
    QString problem;       ///< why it can't be accepted; empty: it can
    double gap = 0.0;      ///< between it and the stock that it has to touch, mm; infinity: no stock is there
};

/// A modeless dialog for kind, sizes and position of a fixture of the library. Its object name is "fixtureDialog"; it
/// contains "fixtureKind", "fixtureDrawing", a field for each size ("fixture-KEY"), "fixturePlaceX" …, "fixtureTurn",
/// "acceptFixtureButton", "cancelFixtureButton", "fixtureNotice".
class FixtureDialog final : public QDialog {
    Q_OBJECT
public:
    explicit FixtureDialog(QWidget* parent);
    void fit();                                     ///< gives it the height that its content needs
    void setState(const FixtureDialogState& state); ///< never emits
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void kindChosen(burin::FixtureKind kind);
    void valueEdited(std::size_t parameter, double value); ///< mm
    void placeEdited(const glm::dvec3& place);             ///< mm, setup frame
    void turnEdited(double turn);                          ///< rad
    void turnedBy(double angle);                           ///< rad
    void acceptRequested();

private:
    void addKind(QVBoxLayout& column);
    void paintKinds();
    void addSizes(QVBoxLayout& column);
    void addPosition(QVBoxLayout& column);
    void addTurns(QVBoxLayout& column);
    void addButtons(QVBoxLayout& column);
    void rebuildSizes(FixtureKind kind);

    FixtureDialogState state_;
    std::optional<FixtureKind> built_; ///< whose sizes have fields
    ChoiceBox* kind_ = nullptr;
    QLabel *about_ = nullptr, *placeTitle_ = nullptr;
    FixtureDrawing* drawing_ = nullptr;
    QWidget* sizes_ = nullptr;
    std::vector<QuantityField*> values_;
    std::array<QuantityField*, 3> place_{};
    QuantityField* turn_ = nullptr;
    Notice* notice_ = nullptr;
    QPushButton* accept_ = nullptr;
};

} // namespace burin
