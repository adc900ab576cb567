// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/milling_session.h"
#include "ui/workbench/controller.h"

#include <QTimer>

#include <functional>
#include <memory>

namespace burin {

/// Runs one milling session at a time: starts and ends it, and polls it at the rate of the screen. Operations that need
/// the project are done in the order in which they were requested. Faults that do not end the session are reported by
/// `failed`.
class SessionRunner final : public Controller {
    Q_OBJECT
public:
    SessionRunner(const Desk& desk, QObject* parent);
    ~SessionRunner() override; ///< ends the session; its recording is kept

    using Then = std::function<void(bool)>;
    /// What a session mills, its bounds and its history of strokes, for the duration of the session.
    struct Place {
        std::shared_ptr<MillingContext> milling;
        std::shared_ptr<const ToolBounds> bounds;
        StrokeHistory* strokes = nullptr;
    };
    void begin(const Place& place, AnyStylus stylus, const SessionRequest& request, Then then);
    void end(Then then = {});
    void startRecording(const QString& name, Then then = {});
    void stopRecording(Then then = {});
    void undoStroke(Then then);
    void redoStroke(Then then);
    void setAllowance(double millimetres);
    void setLayer(std::size_t layer, bool on); ///< MillingSession::setLayer
    void setStockLayer(bool on);               ///< MillingSession::setStockLayer
    Result<void> setGuides(const GuideSettings& guides);
    void stepGuides(int levels);
    void setWorkspace(const WorkspaceSettings& workspace);

    bool running() const noexcept { return session_ != nullptr; }
    const SessionState& state() const noexcept { return state_; }
    const DeviceHealth& health() const noexcept { return health_; } ///< as last read; empty without a session
    /// The newest one; empty without a session
    const VolumeSnapshot& workpiece() const noexcept { return view_.workpiece; }

signals:
    void ticked(); ///< `state` is new
    void viewed(const burin::WorkpieceView& view);
    void traced(const std::vector<burin::TracePoint>& points);
    void healthRead(); ///< several times a second during a session
    void recordingStarted();
    void endedByItself(); ///< the stylus ended it, or a fault did; `end` must still be called
    void ended();         ///< the workpiece may be accessed by its owner again

private:
    void look();
    void readHealth();
    void withSession(std::function<Result<void>(MillingSession&)> use, Then then);

    Place place_;
    std::unique_ptr<AnyStylus> stylus_;
    std::unique_ptr<MillingSession> session_;
    SessionState state_;
    std::vector<TracePoint> trace_;
    WorkpieceView view_;
    DeviceHealth health_;
    QTimer frame_, healthTimer_;
    bool ended_ = false; ///< whether `endedByItself` was emitted
};

} // namespace burin
