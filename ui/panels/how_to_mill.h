// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace burin {

/// A short list of what mouse and keys do in mill mode.
class HowToMill : public QWidget {
    Q_OBJECT
public:
    explicit HowToMill(QWidget* parent = nullptr);
};

} // namespace burin
