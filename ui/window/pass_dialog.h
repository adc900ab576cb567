// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/sample.h"
#include "ui/panels/quantity_field.h"
#include "ui/workbench/pass_controller.h"

#include <QDialog>

#include <optional>
#include <vector>

class QCheckBox;
class QPushButton;

namespace burin {

class ChoiceBox;
class FieldRow;
class Notice;

/// What figures of a pass are where the user states none, mm.
struct PassDefaults {
    double roughStep = 0.0, fineStep = 0.0; ///< step-overs
    double levelDepth = 0.0, stairs = 0.0;
    double top = 0.0;     ///< of the stock
    double bottom = 0.0;  ///< the part's lowest point
    double partTop = 0.0; ///< the part's highest point, the bottom of facing
};

/// Asks what a pass is to do: its kind, the figures that belong to it, the drawing of its area and what leads it.
/// Dialog "passDialog" with "passKind", a field a figure ("passStepOver", …), "passArea", "passLines", "passUnit",
/// "computePassButton", "cancelPassButton".
class PassDialog final : public QDialog {
    Q_OBJECT
public:
    /// What it begins with, and what it may choose from.
    struct Offer {
        QString toolName;
        std::vector<TakeInfo> takes; ///< whose strokes may lead
        WantedPass last;             ///< what was asked for before
        PassDefaults defaults;
        PlanRegion painted; ///< empty: nothing is
        QString folder;     ///< of drawings
        LengthUnit unit = LengthUnit::millimetre;
    };
    PassDialog(const Offer& offer, QWidget* parent);

    const WantedPass& wanted() const noexcept { return wanted_; } ///< after it was accepted

private:
    /// One figure, and the kinds that it counts for.
    struct Figure {
        QuantityField* field = nullptr;
        FieldRow* row = nullptr;
        double PassRequest::*member = nullptr;
        std::optional<double> PassRequest::*height = nullptr; ///< in place of a member
        std::vector<PassKind> kinds;
        bool edited = false; ///< its value is the user's
    };
    struct Switch {
        QCheckBox* box = nullptr;
        bool PassRequest::*member = nullptr;
        std::vector<PassKind> kinds;
    };
    void layOut(const Offer& offer);
    void addFigures();
    void addFigure(Figure figure, const char* name, const QString& label, const QString& toolTip, Quantity quantity,
                   double low, double high);
    void addSwitch(Switch one, const char* name, const QString& label, const QString& toolTip);
    void addDrawings(const Offer& offer);
    void chooseDrawing(ChoiceBox* box, QString& file);
    PassKind kind() const;
    double defaultOf(const Figure& figure) const;
    void showDefaults();
    QString missing(const WantedPass& wanted) const;
    void update();
    void confirm();

    LengthUnit unit_;
    PassDefaults defaults_;
    QString folder_, areaFile_, linesFile_;
    PlanRegion painted_;
    std::vector<TakeInfo> takes_;
    WantedPass wanted_;
    ChoiceBox *kind_ = nullptr, *area_ = nullptr, *lines_ = nullptr, *fileUnit_ = nullptr;
    QCheckBox* areaOnPart_ = nullptr;
    FieldRow *areaRow_ = nullptr, *linesRow_ = nullptr, *fileUnitRow_ = nullptr;
    std::vector<Figure> figures_;
    std::vector<Switch> switches_;
    Notice* notice_ = nullptr;
};

} // namespace burin
