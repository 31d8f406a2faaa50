// Draws a mesh.
#pragma once

#include "../../core/mesh.hpp"
#include "canvas.hpp"
#include "colouring.hpp"

namespace pardel::cli {

/// Draws triangles, their edges and the constrained edges. Lines become thinner where triangles are small. Triangles
/// smaller than a few pixels become an image of their mean colours. Unless colours show a scale, it is
/// darker where triangles are smaller.
void draw_mesh(Canvas& canvas, const Mesh& mesh, const Colouring& colouring);

}  // namespace pardel::cli
