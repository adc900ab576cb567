// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <vector>

namespace burin {

class Notice;

/// What embedding found doubtful, in sentences. As high as they are, and hidden while there are none: it has its place
/// below all else of a page.
class EmbeddingFindings : public QWidget {
    Q_OBJECT
public:
    explicit EmbeddingFindings(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setFindings(const std::vector<EmbeddingFinding>& findings);

private:
    void refresh();

    std::vector<EmbeddingFinding> findings_;
    LengthUnit unit_ = LengthUnit::millimetre;
    Notice* notice_;
};

} // namespace burin
