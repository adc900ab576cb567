// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/workbench/mill_controller.h"

#include <QTimer>

#include <map>
#include <optional>

namespace burin {

/// Keeps the workpiece in the project as its recordings left it, when the hand has come to rest: opening the project
/// then cuts nothing again. Its hash is found at the same time. In the background; what can't be kept is no fault.
class WorkpieceKeeper final : public Controller {
    Q_OBJECT
public:
    WorkpieceKeeper(const Desk& desk, WorkpieceController& workpiece, SessionRunner& session, MillController& mill,
                    QObject* parent);
    /// The project or the setup is another one.
    void forget();
    /// Of the workpiece that stands (core/volume/operations/fingerprint.h); nothing: it is not known yet.
    const std::optional<std::uint64_t>& hash() const noexcept { return hash_; }

private:
    void wait();
    void keep();
    /// What the project says of the workpiece that stands.
    struct Wanted {
        RecordedState state;
        bool keeps = false; ///< it is not kept yet, and may be
    };
    void look(const Wanted& wanted, std::map<std::int64_t, std::size_t> strokes, VolumeSnapshot workpiece);
    void store(const RecordedState& state, KeptWorkpiece kept);

    WorkpieceController& workpiece_;
    SessionRunner& session_;
    MillController& mill_;
    QTimer rest_;
    quint64 generation_ = 0; ///< counts what makes the workpiece another
    std::optional<std::uint64_t> hash_;
};

} // namespace burin
