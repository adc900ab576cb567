// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/exchange/plan_drawing.h"
#include "core/geometry/upright_holes.h"
#include "core/recording/sample.h"
#include "ui/window/pass_form.h"
#include "ui/workbench/pass_controller.h"

#include <QDialog>
#include <QTimer>

#include <optional>
#include <vector>

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace burin {

class ChoiceBox;
class FieldRow;
class Notice;

/// Asks for the parameters of a pass: its kind and values (PassForm), the drawing of its area and its guiding lines, or
/// its holes. Dialog "passDialog" with "passArea", "passLines", "passUnit", "passPickedHoles", "pickHolesButton",
/// "allHolesButton", "passShowMeButton", "computePassButton", "cancelPassButton".
class PassDialog final : public QDialog {
    Q_OBJECT
public:
    /// The initial values, and the choices.
    struct Offer {
        QString toolName;
        std::vector<TakeInfo> takes; ///< whose strokes may be used as lines
        RequestedPass last;          ///< the previous request
        PassDefaults defaults;
        PlanRegion painted;               ///< empty: no area is painted
        QString folder;                   ///< of drawings
        std::vector<PassKind> kinds;      ///< that the tool can do
        std::vector<UprightHole> holes{}; ///< of the part, and its studs
        LengthUnit unit = LengthUnit::millimetre;
    };
    PassDialog(const Offer& offer, QWidget* parent);

    /// Result of `exec`: the user is going to pick the holes of `wanted` in the view.
    static constexpr int pickHoles = 2;
    const RequestedPass& wanted() const noexcept { return wanted_; } ///< after it was accepted, or with `pickHoles`

    void fit(); ///< the height of the dialog to its fields
    /// Shows the estimate of the pass: "passPreview". @param text empty: none
    void showPreview(const QString& text);
    /// Whether the view plays how the pass is made; Esc stops that then, instead of closing the dialog.
    void setShowing(bool showing);
    void reject() override;

signals:
    /// Requests a preview of the pass as entered, a moment after a change.
    void previewRequested(const burin::RequestedPass& wanted);
    void previewUnwanted(); ///< the entered pass is incomplete
    /// Requests to play how the pass as entered is made; it may lack lines or an area.
    void showMeRequested(const burin::RequestedPass& wanted);
    void showStopped();

private:
    void layOut(const Offer& offer);
    void addHoles();
    void showHoles();
    void removeChosenHole();
    void goPicking();
    void addDrawings(const Offer& offer);
    void chooseDrawing(ChoiceBox* box, QString& file);
    QString missing(const RequestedPass& wanted) const;
    void update();
    void previewSoon() { previewTimer_.start(); }
    void askPreview();
    Result<PlanDrawing> drawingOf(const QString& file);
    /// Without the requirements of each kind. Errors: those of readDrawing, regionOf and validate.
    Result<RequestedPass> wantedNow();
    void toggleShow();
    void confirm();

    QString folder_, areaFile_, linesFile_;
    PlanRegion painted_;
    std::vector<TakeInfo> takes_;
    std::vector<UprightHole> holes_;
    std::vector<glm::dvec2> picked_; ///< the points of the holes, or studs, that were picked; empty: all that fit
    bool external_ = false;          ///< they are studs
    LengthUnit unit_;
    RequestedPass wanted_;
    PassForm* form_ = nullptr;
    ChoiceBox *area_ = nullptr, *lines_ = nullptr, *fileUnit_ = nullptr;
    QCheckBox* areaOnPart_ = nullptr;
    FieldRow *areaRow_ = nullptr, *linesRow_ = nullptr, *fileUnitRow_ = nullptr;
    Notice* notice_ = nullptr;
    QLabel* preview_ = nullptr;
    QWidget* holesBox_ = nullptr;
    QLabel* holesLabel_ = nullptr;
    QListWidget* holeList_ = nullptr;
    QPushButton *allHoles_ = nullptr, *showMe_ = nullptr;
    bool showing_ = false;
    QTimer previewTimer_;
    struct {
        QString file;
        double unit = 0.0;
        std::optional<PlanDrawing> drawing;
    } read_; ///< the file read last
};

} // namespace burin
