// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

namespace burin {

/// Converts SIGINT, SIGTERM and SIGHUP into a Qt signal, so that the window ends as if it had been closed. Only one
/// object may exist.
class UnixSignals final : public QObject {
    Q_OBJECT
public:
    explicit UnixSignals(QObject* parent = nullptr);
    ~UnixSignals() override;

signals:
    void endRequested();
};

} // namespace burin
