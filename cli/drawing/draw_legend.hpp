// The column to the right of the drawing: a headline, some lines of text, and the meaning of the colours or marks.
#pragma once

#include <string>
#include <vector>

#include "../../core/pslg.hpp"
#include "canvas.hpp"
#include "colouring.hpp"

namespace pardel::cli {

/// `text`: the lines above the colours; the first one is the headline. Draws nothing else if the legend has no title.
void draw_legend(Canvas& canvas, const std::vector<std::string>& text, const Legend& legend);
/// The same for a domain, with the marks of draw_domain() and their numbers.
void draw_legend(Canvas& canvas, const std::string& headline, const Pslg& pslg);

}  // namespace pardel::cli
