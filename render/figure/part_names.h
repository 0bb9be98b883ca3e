#pragma once
// What parts of a figure are called where something is said of them: by their text, or, where they
// have none, by their number, which counts from 1.

#include <cstddef>
#include <string>

#include "base/statement.h"
#include "render/figure/diagram.h"

namespace tribolog::render::figure {

/// "series 'rising'", "series 3"
Statement name_of_series(const std::string& label, std::size_t index);

/// "block 'g(ω)'", "block 2"
Statement name_of_block(const Diagram& diagram, std::size_t index);

/// "wire 3"
Statement name_of_wire(std::size_t index);

/// "the text 'T_{f}'"
Statement name_of_text(const std::string& text);

/// "the part 'm_{3}'", of a scene
Statement name_of_part(const std::string& label);

}  // namespace tribolog::render::figure
