// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

#include <vector>

namespace burin {

class Notice;

/// The doubtful findings of the embedding, as sentences. The height follows the text and the widget is hidden while
/// there are none, so it belongs at the bottom of a page.
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
