// The library cairo, loaded when the first picture is drawn: it brings seventeen other libraries, which would double
// the time in which every other command starts.
#pragma once

#include <cairo-svg.h>
#include <cairo.h>

#include "../../core/result.hpp"

namespace pardel::cli {

/// The functions of cairo that draw pictures; each has the name that it has in cairo, without "cairo_".
struct CairoLibrary {
  decltype(&cairo_clip) clip;
  decltype(&cairo_close_path) close_path;
  decltype(&cairo_create) create;
  decltype(&cairo_destroy) destroy;
  decltype(&cairo_fill) fill;
  decltype(&cairo_fill_preserve) fill_preserve;
  decltype(&cairo_get_source) get_source;
  decltype(&cairo_image_surface_create) image_surface_create;
  decltype(&cairo_image_surface_create_for_data) image_surface_create_for_data;
  decltype(&cairo_line_to) line_to;
  decltype(&cairo_move_to) move_to;
  decltype(&cairo_new_path) new_path;
  decltype(&cairo_paint) paint;
  decltype(&cairo_pattern_set_filter) pattern_set_filter;
  decltype(&cairo_rectangle) rectangle;
  decltype(&cairo_restore) restore;
  decltype(&cairo_save) save;
  decltype(&cairo_scale) scale;
  decltype(&cairo_select_font_face) select_font_face;
  decltype(&cairo_set_antialias) set_antialias;
  decltype(&cairo_set_font_size) set_font_size;
  decltype(&cairo_set_line_cap) set_line_cap;
  decltype(&cairo_set_line_join) set_line_join;
  decltype(&cairo_set_line_width) set_line_width;
  decltype(&cairo_set_source_rgb) set_source_rgb;
  decltype(&cairo_set_source_surface) set_source_surface;
  decltype(&cairo_show_text) show_text;
  decltype(&cairo_status) status;
  decltype(&cairo_status_to_string) status_to_string;
  decltype(&cairo_stroke) stroke;
  decltype(&cairo_surface_destroy) surface_destroy;
  decltype(&cairo_surface_finish) surface_finish;
  decltype(&cairo_surface_status) surface_status;
  decltype(&cairo_surface_write_to_png_stream) surface_write_to_png_stream;
  decltype(&cairo_svg_surface_create_for_stream) svg_surface_create_for_stream;
  decltype(&cairo_translate) translate;
};

/// Loads libcairo.so.2. It stays loaded. Error: resources, with the reason, if it or one of its functions is missing.
[[nodiscard]] Result<CairoLibrary> load_cairo();

}  // namespace pardel::cli
