// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/pass_film.h"
#include "ui/workbench/pass_previewer.h"

#include <QElapsedTimer>
#include <QTimer>

#include <optional>

namespace burin {

/// Plays how the pass that is previewed comes from its stroke, in some ten seconds (PassFilm). Changes nothing.
class PassShow final : public Controller {
    Q_OBJECT
public:
    PassShow(const Desk& desk, const PassPreviewer& previewer, QObject* parent);

    bool showing() const noexcept { return waiting_ || film_.has_value(); }
    /// The present picture; null between shows.
    const PassFilm::Picture* picture() const noexcept { return film_ ? &picture_ : nullptr; }
    /// Plays the preview that was requested last, as soon as it is ready. Another preview stops the show.
    void start();
    void stop();

signals:
    void moved();    ///< to another picture
    void finished(); ///< played to its end, stopped, or there is nothing to show

private:
    void followPreview();
    void begin();
    void advance();

    const PassPreviewer& previewer_;
    std::optional<PassFilm> film_;
    PassFilm::Picture picture_;
    QTimer frames_;
    QElapsedTimer clock_;
    bool waiting_ = false; ///< for the preview
};

} // namespace burin
