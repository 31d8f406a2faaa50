#include "cairo_library.hpp"

#include <dlfcn.h>
#include <fmt/core.h>

namespace pardel::cli {
namespace {

Error refusal(const char* reason) {
  return {ErrorKind::resources,
          fmt::format("pictures are drawn by the library cairo, which cannot be loaded: {}", reason)};
}

/// Finds functions, and keeps the first name that is missing.
struct Finder {
  void* library;
  const char* missing = nullptr;

  template <class Function>
  void find(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
    if (function == nullptr && missing == nullptr) missing = name;
  }
};

}  // namespace

Result<CairoLibrary> load_cairo() {
  void* library = dlopen("libcairo.so.2", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return refusal(dlerror());
  Finder finder{library};
  CairoLibrary cairo{};
  finder.find(cairo.clip, "cairo_clip");
  finder.find(cairo.close_path, "cairo_close_path");
  finder.find(cairo.create, "cairo_create");
  finder.find(cairo.destroy, "cairo_destroy");
  finder.find(cairo.fill, "cairo_fill");
  finder.find(cairo.fill_preserve, "cairo_fill_preserve");
  finder.find(cairo.get_source, "cairo_get_source");
  finder.find(cairo.image_surface_create, "cairo_image_surface_create");
  finder.find(cairo.image_surface_create_for_data, "cairo_image_surface_create_for_data");
  finder.find(cairo.line_to, "cairo_line_to");
  finder.find(cairo.move_to, "cairo_move_to");
  finder.find(cairo.new_path, "cairo_new_path");
  finder.find(cairo.paint, "cairo_paint");
  finder.find(cairo.pattern_set_filter, "cairo_pattern_set_filter");
  finder.find(cairo.rectangle, "cairo_rectangle");
  finder.find(cairo.restore, "cairo_restore");
  finder.find(cairo.save, "cairo_save");
  finder.find(cairo.scale, "cairo_scale");
  finder.find(cairo.select_font_face, "cairo_select_font_face");
  finder.find(cairo.set_antialias, "cairo_set_antialias");
  finder.find(cairo.set_font_size, "cairo_set_font_size");
  finder.find(cairo.set_line_cap, "cairo_set_line_cap");
  finder.find(cairo.set_line_join, "cairo_set_line_join");
  finder.find(cairo.set_line_width, "cairo_set_line_width");
  finder.find(cairo.set_source_rgb, "cairo_set_source_rgb");
  finder.find(cairo.set_source_surface, "cairo_set_source_surface");
  finder.find(cairo.show_text, "cairo_show_text");
  finder.find(cairo.status, "cairo_status");
  finder.find(cairo.status_to_string, "cairo_status_to_string");
  finder.find(cairo.stroke, "cairo_stroke");
  finder.find(cairo.surface_destroy, "cairo_surface_destroy");
  finder.find(cairo.surface_finish, "cairo_surface_finish");
  finder.find(cairo.surface_status, "cairo_surface_status");
  finder.find(cairo.surface_write_to_png_stream, "cairo_surface_write_to_png_stream");
  finder.find(cairo.svg_surface_create_for_stream, "cairo_svg_surface_create_for_stream");
  finder.find(cairo.translate, "cairo_translate");
  if (finder.missing != nullptr) return refusal(finder.missing);
  return cairo;
}

}  // namespace pardel::cli
