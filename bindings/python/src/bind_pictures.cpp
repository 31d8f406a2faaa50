// Pictures: what the program's command `draw` draws, with cairo. Without the headers of cairo this file is not
// compiled.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "../../../cli/drawing/colouring.hpp"
#include "../../../cli/drawing/draw_domain.hpp"
#include "../../../cli/drawing/draw_legend.hpp"
#include "../../../cli/drawing/draw_mesh.hpp"
#include "../../../cli/drawing/names.hpp"
#include "../../../cli/plural.hpp"
#include "bind.hpp"
#include "call.hpp"
#include "errors.hpp"
#include "held_mesh.hpp"

namespace py = pybind11;

namespace pardel::python {
namespace {

/// Its arguments have been checked. window: x and y of two corners. title: none if there is no legend.
struct Picture {
  std::filesystem::path file;
  std::optional<std::array<double, 4>> window;
  int pixels = 1000;
  std::optional<std::string> title;

  [[nodiscard]] cli::Canvas canvas(std::span<const Point> points) const {
    const cli::Window around =
        window ? cli::Window{{(*window)[0], (*window)[1]}, {(*window)[2], (*window)[3]}} : cli::window_around(points);
    const auto format = file.extension() == ".png" ? cli::PictureFormat::png : cli::PictureFormat::svg;
    return {value_of(cli::load_cairo()),
            file,
            around,
            {.format = format,
             .pixels = static_cast<double>(pixels),
             .legend = title.has_value(),
             .cut = window.has_value()}};
  }
};

/// The words that the program's option --by takes, and if they need the report of the run that made the mesh.
std::map<std::string, bool> colours() {
  std::map<std::string, bool> words;
  for (std::size_t k = 0; k < cli::colour_names.size(); ++k)
    words.emplace(cli::colour_names.names[k], static_cast<cli::ColourBy>(k) >= cli::ColourBy::tile);
  return words;
}

cli::ColourBy colour_by(const std::string& word) {
  const auto& names = cli::colour_names.names;
  return static_cast<cli::ColourBy>(std::ranges::find(names, word) - names.begin());
}

/// `by`: one of colours(). `report`: the file that it needs, or empty.
void draw_mesh(const Picture& picture, const HeldMesh& held, const std::string& by,
               const std::filesystem::path& report) {
  const Mesh& mesh = held.usable();
  Call().run([&] {
    const cli::Colouring coloured = value_of(cli::colouring(mesh, colour_by(by), report));
    cli::Canvas canvas = picture.canvas(mesh.points.span());
    cli::draw_mesh(canvas, mesh, coloured);
    if (picture.title)
      cli::draw_legend(canvas,
                       {*picture.title, cli::plural(mesh.points.size(), "vertex", "vertices"),
                        cli::plural(mesh.triangles.size(), "triangle")},
                       coloured.legend);
    require(canvas.finish());
    return Done{};
  });
}

void draw_domain(const Picture& picture, const Pslg& domain) {
  Call().run([&] {
    cli::Canvas canvas = picture.canvas(domain.points);
    cli::draw_domain(canvas, domain);
    if (picture.title) cli::draw_legend(canvas, *picture.title, domain);
    require(canvas.finish());
    return Done{};
  });
}

}  // namespace

void bind_pictures(py::module_& module) {
  py::class_<Picture>(module, "Picture")
      .def(py::init([](std::filesystem::path file, std::optional<std::array<double, 4>> window, int pixels,
                       std::optional<std::string> title) {
             return Picture{std::move(file), window, pixels, std::move(title)};
           }),
           py::arg("file"), py::arg("window"), py::arg("pixels"), py::arg("title"));
  module.def("colours", &colours);
  module.def("draw_mesh", &draw_mesh, py::arg("picture"), py::arg("mesh"), py::arg("by"), py::arg("report"));
  module.def("draw_domain", &draw_domain, py::arg("picture"), py::arg("domain"));
}

}  // namespace pardel::python
