// Draws a domain.
#pragma once

#include "../../core/pslg.hpp"
#include "canvas.hpp"

namespace pardel::cli {

/// Draws segments, points, holes (crosses) and the seeds of regions (diamonds with their attributes).
void draw_domain(Canvas& canvas, const Pslg& pslg);

/// The marks of draw_domain(), at a place of the picture.
void draw_dot(Canvas& canvas, Point place, double radius);
void draw_cross(Canvas& canvas, Point place);
void draw_diamond(Canvas& canvas, Point place);

}  // namespace pardel::cli
