// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/plan_drawing.h"
#include "core/recording/sample.h"
#include "ui/window/pass_form.h"
#include "ui/workbench/pass_controller.h"

#include <QDialog>
#include <QTimer>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;

namespace burin {

class ChoiceBox;
class FieldRow;
class Notice;

/// Asks for the parameters of a pass: its kind and values (PassForm), the drawing of its area and its guiding lines.
/// Dialog "passDialog" with "passArea", "passLines", "passUnit", "computePassButton", "cancelPassButton".
class PassDialog final : public QDialog {
    Q_OBJECT
public:
    /// The initial values, and the choices.
    struct Offer {
        QString toolName;
        std::vector<TakeInfo> takes; ///< whose strokes may be used as lines
        WantedPass last;             ///< the previous request
        PassDefaults defaults;
        PlanRegion painted;  ///< empty: no area is painted
        QString folder;      ///< of drawings
        bool drills = false; ///< the tool is a drill
        QString holes{};     ///< of the part, by diameter; empty: none
        LengthUnit unit = LengthUnit::millimetre;
    };
    PassDialog(const Offer& offer, QWidget* parent);

    const WantedPass& wanted() const noexcept { return wanted_; } ///< after it was accepted

    /// Shows the estimate of the pass: "passPreview". @param text empty: none
    void showPreview(const QString& text);

signals:
    /// Requests a preview of the pass as entered, a moment after a change.
    void previewWanted(const burin::WantedPass& wanted);
    void previewUnwanted(); ///< the entered pass is incomplete

private:
    void layOut(const Offer& offer);
    void addDrawings(const Offer& offer);
    void chooseDrawing(ChoiceBox* box, QString& file);
    QString missing(const WantedPass& wanted) const;
    void update();
    void previewSoon() { previewTimer_.start(); }
    void askPreview();
    Result<PlanDrawing> drawingOf(const QString& file);
    /// Without the requirements of each kind. Errors: those of readDrawing, regionOf and validate.
    Result<WantedPass> wantedNow();
    void confirm();

    QString folder_, areaFile_, linesFile_;
    PlanRegion painted_;
    std::vector<TakeInfo> takes_;
    WantedPass wanted_;
    PassForm* form_ = nullptr;
    ChoiceBox *area_ = nullptr, *lines_ = nullptr, *fileUnit_ = nullptr;
    QCheckBox* areaOnPart_ = nullptr;
    FieldRow *areaRow_ = nullptr, *linesRow_ = nullptr, *fileUnitRow_ = nullptr;
    Notice* notice_ = nullptr;
    QLabel* preview_ = nullptr;
    QTimer previewTimer_;
    struct {
        QString file;
        double unit = 0.0;
        std::optional<PlanDrawing> drawing;
    } read_; ///< the file read last
};

} // namespace burin
