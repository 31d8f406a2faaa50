// Readers and writers of files: Triangle's formats, VTU, Gmsh's MSH, OFF, legacy VTK, SMS's 2DM, the grids of SCHISM
// and ADCIRC, Abaqus' INP, SVG. Numbers are written with enough digits to read back the same double. A writer never
// leaves a partial file under the final name: it writes to a new file without a name, or with another one, and gives it
// the name on success (docs/formats.md). A byte order mark at the beginning of a file is skipped. A device or a pipe is
// written directly. Every error message names the file; for text files it also names the line. These functions are in
// the library pardel::formats.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "join_pieces.hpp"
#include "mesh.hpp"
#include "part_of_points.hpp"
#include "piece_of_mesh.hpp"
#include "pslg.hpp"
#include "ranks.hpp"
#include "raster.hpp"
#include "result.hpp"
#include "size_rules.hpp"

namespace pardel {

/// A question that readers and writers ask every few milliseconds, in the calling thread: may they go on? If it returns
/// false, they end with an error `cancelled`; nothing is written then. Empty: they are not asked.
using GoOn = std::function<bool()>;

/// Reads Triangle's .poly or .node. If the point section of the .poly is empty, the points are read from the .node of
/// the same name. Points must be numbered consecutively from 0 or 1; the numbers of segments, holes and regions are
/// ignored. Coordinates and attributes must be finite. Text after the fields of a line, or after the last section, is
/// ignored.
[[nodiscard]] Result<Pslg> read_pslg(const std::filesystem::path& file, const GoOn& go_on = {});
/// Reads a .poly from `text`; messages use `name` as the file name. A .poly whose points are in a .node is an error.
[[nodiscard]] Result<Pslg> parse_poly(std::string_view text, const std::string& name);

/// Reads what read_pslg() reads, but of the points and of the segments only the part of this rank: those in about an
/// equal part of the bytes. All ranks read all holes and regions. Collective; all ranks see the same regular files. All
/// ranks return the error of the first rank that failed, with its line: that of read_pslg().
[[nodiscard]] Result<PartOfPslg> read_part_of_pslg(const std::filesystem::path& file, Ranks& ranks);

/// base: the number of the first vertex in Triangle's files, 0 or 1. The file of a domain without points is read with
/// the points of the .node of the same name.
[[nodiscard]] Status write_poly(const Pslg& pslg, const std::filesystem::path& file, int base = 1,
                                const GoOn& go_on = {});

/// The formats of meshes: single files, and Triangle's .node, .ele and .poly. gr3: .gr3 and .14 (ADCIRC's fort.14).
enum class MeshFormat : std::uint8_t { msh, off, svg, vtu, vtk, two_dm, gr3, inp, triangle };
/// The format that the suffix of a file sets; empty if it is not the suffix of a mesh.
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& file);

/// Reads a mesh written by any program; the suffix determines the format. A file without a suffix, such as `-`
/// (standard input), is a .msh, .vtu, .vtk, .off or .2dm; its first characters tell which. In the result, indices are
/// in range and numbers are finite. Nothing else is verified: triangles may be clockwise, flat or overlapping (see the
/// checker). Neighbours are computed from the triangles by rebuild_neighbours(). Region attributes are in ascending
/// order. z is ignored. There are no constrained edges if the format has none.
///   .node, .ele  either name reads both files. Constrained edges come from the .poly of the same name if it has no
///                points of its own, else from the marked edges of the .edge. A .neigh must agree with the triangles.
///                Of six nodes per triangle the first three are read. Nodes that are only middles of edges are left
///                out, and the nodes after them get smaller indices.
///   .msh         versions 4.1 and 2.x, ASCII or binary. Triangles are read, lines become constrained edges, points are
///                ignored. The attribute of a region and the marker of an edge are X and N for physical groups named
///                `region X` and `marker N`, else the tag of the group, of which the name is kept. Points get no
///                markers and no attributes. $NodeData and $ElementData are fields.
///   .vtu         not compressed or compressed by zlib; arrays as text, base64 or raw bytes. Triangles are read, lines
///                become constrained edges. Cell arrays `region` and `marker` (of lines), point arrays `marker` and
///                `attributes`; other arrays of numbers at points and in cells are fields. Several pieces are joined by
///                the numbers in the point array `GlobalNodeId` if all have it; otherwise their points are different.
/// What else a file has beside the mesh is listed in Mesh::left_out.
///   .off         triangles, and the constrained edges that write_off() lists in comments.
///   .vtk         legacy files of VTK in ASCII, an unstructured grid; cells and arrays as of a .vtu.
///   .2dm         the triangles E3T; nodes by their numbers, whose z is the attribute of the point. The first material
///                of a triangle is the attribute of its region. Nodestrings are constrained edges; the integer after
///                the end of a nodestring is their marker, or else the number of the nodestring, from 1 on.
///   .gr3, .14    depths are the attribute of the points. The edges of boundaries are constrained edges: those of land
///                have the marker 1, those of open boundary k have 1 + k. A file may end after the elements.
/// In .msh and .vtu triangles may have six nodes and lines three, as in an .ele.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& file, const GoOn& go_on = {});
struct MeshOfFile {
  Mesh mesh;
  MeshFormat format;  ///< also of a file without a suffix; of a .pvtu that of its pieces
};
/// The same, and the format.
[[nodiscard]] Result<MeshOfFile> read_mesh_and_format(const std::filesystem::path& file, const GoOn& go_on = {});

/// Reads a domain or a mesh. A .poly is a domain, and so is a .node without an .ele of the same name. A file without a
/// suffix is a .poly unless it begins like a mesh.
[[nodiscard]] Result<std::variant<Pslg, Mesh>> read_pslg_or_mesh(const std::filesystem::path& file,
                                                                 const GoOn& go_on = {});
/// The same of the text of a file without a suffix. `file`: its name, for messages, and for a .node beside it.
[[nodiscard]] Result<std::variant<Pslg, Mesh>> parse_pslg_or_mesh(std::string_view text,
                                                                  const std::filesystem::path& file);
/// The text of a file, or of standard input, as all readers read it: without a byte order mark. Error: `io`.
[[nodiscard]] Result<std::string> read_text(const std::filesystem::path& file, const GoOn& go_on = {});

enum class MshEncoding : std::uint8_t { ascii, binary };
/// The order of the elements of a file. second: a triangle has six nodes, and a constrained edge three. The middles of
/// edges follow the vertices; their attributes and fields are the means of those of the ends of the edge.
enum class ElementOrder : std::uint8_t { first, second };

/// Writes a mesh. The suffix of `file` determines the format, unless `format` is given, as it has to be for `-`
/// (standard output). Triangle's format: writes .node, .ele and .poly, either all of them or, after an error, none.
/// MSH: uses the encoding `msh`.
/// Preconditions of this and all other writers of meshes: indices are in range, and arrays per point and per triangle
/// have the right lengths; for .edge, .neigh and second order, Triangle::n is correct.
[[nodiscard]] Status write_mesh(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& file,
                                MshEncoding msh = MshEncoding::binary, std::optional<MeshFormat> format = {});

/// How a mesh is written, where its format leaves a choice.
struct MeshFileOptions {
  MshEncoding msh = MshEncoding::binary;
  std::optional<MeshFormat> format{};           ///< as `format` above
  ElementOrder elements = ElementOrder::first;  ///< second: for .node and .ele, .msh and .vtu
  std::vector<int> open_boundaries{};           ///< .gr3, .14: see write_gr3()
  GoOn go_on{};
};
/// The same with these options. Error: `usage` for elements of second order in another format; as write_gr3().
[[nodiscard]] Status write_mesh(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& file,
                                const MeshFileOptions& options);
/// True if a file of the format can have elements of second order.
[[nodiscard]] bool has_second_order(MeshFormat format);

/// The names of all files that write_mesh() writes for `file`.
[[nodiscard]] std::vector<std::string> written_files(const std::filesystem::path& file);

/// The files and parts of files that Triangle's switches select.
struct TriangleFiles {
  int base = 1;
  bool write_node = true;
  bool write_ele = true;
  bool write_poly = true;  ///< without points; the constrained edges are its segments; with holes and regions
  bool write_edge = false;
  bool write_neigh = false;
  bool markers = true;
  bool second_order = false;  ///< .ele has six nodes per triangle; .node ends with the midpoints of the edges
  std::string command{};      ///< if not empty, each file ends with the comment `# Generated by COMMAND`
  GoOn go_on{};
};
/// Writes stem.node, stem.ele and so on, as selected by `files`. If the mesh has no point markers, the .node has none.
[[nodiscard]] Status write_triangle_files(const Mesh& mesh, const Pslg& pslg, const std::filesystem::path& stem,
                                          const TriangleFiles& files);

/// Writes stem.node, stem.ele and stem.poly of a mesh in pieces. Collective: all ranks write these files together, into
/// a folder that all of them see. The files do not depend on the number of ranks: points are in the order of their
/// numbers; a triangle begins with its least number; triangles are in the lexicographic order of their three numbers,
/// and constrained edges in the order of their lesser and their greater number. Either all files get their names or
/// none; all ranks return the error of the first rank that failed. A rank needs about 8 bytes per triangle for this.
[[nodiscard]] Status write_triangle_pieces(const PieceOfMesh& piece, const Pslg& pslg,
                                           const std::filesystem::path& stem, Ranks& ranks);

/// Reads Triangle's .area file: one area cap per triangle. A value <= 0 means no cap and becomes +infinity.
[[nodiscard]] Result<std::vector<double>> read_area(const std::filesystem::path& file);
/// Writes an .area file. Cap i belongs to triangle base + i; +infinity is written as -1. Precondition: caps are
/// positive.
[[nodiscard]] Status write_area(const std::filesystem::path& file, std::span<const double> caps, int base = 1);
/// Reads one positive number per input vertex. Format, as in Triangle's files: a line `n`, then n lines `i size`.
[[nodiscard]] Result<std::vector<double>> read_sizes(const std::filesystem::path& file, const GoOn& go_on = {});
/// Reads places at which edge lengths are wanted. Each line is `point X Y LENGTH`, `marker M LENGTH` or `region R
/// LENGTH`; `#` begins a comment. Error: `invalid_input` if there is no rule, or a length that is not > 0.
[[nodiscard]] Result<SizeRules> read_size_rules(const std::filesystem::path& file);

/// Reads a raster; the suffix determines the format. Values that are missing become NaN.
///   .asc  an ESRI ASCII grid: NCOLS, NROWS, XLLCORNER or XLLCENTER, YLLCORNER or YLLCENTER, CELLSIZE (or DX and DY),
///         and optionally NODATA_VALUE (default -9999). Upper and lower case are the same.
///   .npy  a two-dimensional array of NumPy, of integers or of floating-point numbers, in which the first row is the
///         northernmost. The world file NAME.wld has its place: six numbers, the step to the east, two zeros, the step
///         to the south (negative), and the coordinates of the grid point in the north-west corner.
[[nodiscard]] Result<Raster> read_raster(const std::filesystem::path& file, const GoOn& go_on = {});

/// Writes MSH 4.1. Each attribute of a region and each marker becomes a physical group named `region X` or `marker N`;
/// triangles without a region are in the group `domain`; a marker or a region with a name is in the group of this name.
/// The tag of a group is the attribute or marker itself if that is a positive int. Tags of vertices are in the order of
/// the mesh; triangles are grouped by region. Fields are $NodeData and $ElementData.
[[nodiscard]] Status write_msh(const Mesh& mesh, const std::filesystem::path& file, MshEncoding encoding,
                               ElementOrder elements = ElementOrder::first, const GoOn& go_on = {});
/// The file of partition 1, 2, ... of FILE.msh, as Gmsh names it: FILE_1.msh.
[[nodiscard]] std::filesystem::path msh_of_piece(const std::filesystem::path& file, int partition);
/// Writes a mesh in pieces as MSH 4.1, one file msh_of_piece(file, rank + 1) per rank, with the sections
/// $PartitionedEntities and $GhostElements. Collective. The tag of a vertex is its number in the whole mesh, plus 1.
/// Elements have tags rank by rank, the constrained edges of all ranks first, so these tags depend on the number of
/// ranks. All files have the same physical groups, chosen as by write_msh() for the whole mesh. Each rank has
///   - per physical group a partitioned entity, whose parent is the only entity of the group,
///   - for each set of ranks that share vertices a curve without elements, which has these vertices in all their files,
///   - a ghost surface: the triangles of other ranks that have a vertex in this piece, without their regions.
/// Either all files get their names or none; all ranks return the error of the first rank that failed.
[[nodiscard]] Status write_msh_piece(const PieceOfMesh& piece, const std::filesystem::path& file, MshEncoding encoding,
                                     Ranks& ranks);
/// Writes VTU version 1.0 with raw appended data and UInt64 headers. The cells are the triangles, then the
/// constrained edges as lines. Cell arrays: `region` (the attribute; 0 for lines), `marker` (of the edge; 0 for
/// triangles) and `quality` (the smallest angle, in degrees; NaN for lines). Point arrays: `marker` and `attributes`,
/// if the mesh has them. Fields follow, with NaN for lines; a field whose name is taken gets a number after it. The
/// names of markers and regions are field data: an array of the name, with the marker and 1, or the attribute and 2.
[[nodiscard]] Status write_vtu(const Mesh& mesh, const std::filesystem::path& file,
                               ElementOrder elements = ElementOrder::first, const GoOn& go_on = {});
/// Writes a legacy file of VTK (version 3.0, ASCII) with the cells and the arrays of write_vtu(), without `quality` and
/// names. Fields are 0 on lines. Source: The VTK User's Guide, "Simple legacy formats".
[[nodiscard]] Status write_vtk(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on = {});

/// The name of the cell array in which write_vtu() writes the smallest angles.
inline constexpr const char* vtu_quality = "quality";
/// The name of the point array in which a .vtu of one piece has the numbers of its points in the whole mesh.
inline constexpr const char* vtu_vertex_numbers = "GlobalNodeId";
/// Writes pieces of a mesh that several processes have made: as write_vtu(), with one number per point. The files get
/// their names together, and processes agree about that, so that either all pieces get their names or none.
class VtuPieces {
 public:
  VtuPieces();
  VtuPieces(const VtuPieces&) = delete;
  VtuPieces& operator=(const VtuPieces&) = delete;
  /// Removes the files that have not got their names.
  ~VtuPieces();

  /// Writes a piece, under another name than `file`.
  [[nodiscard]] Status add(const Mesh& mesh, std::span<const std::uint64_t> numbers, const std::filesystem::path& file);
  /// Gives all files their names, or none after an error. `agree` is called with the outcome, and returns that of all
  /// processes: if this is an error, the files that were there before are put back.
  [[nodiscard]] Status commit(const std::function<Status(const Status& placed)>& agree = {});

 private:
  struct Files;
  std::unique_ptr<Files> files_;
};
/// The files of the pieces that a .pvtu names, in its order. Error: invalid_input if it names none.
[[nodiscard]] Result<std::vector<std::filesystem::path>> files_of_pieces(const std::filesystem::path& pvtu);
/// Reads a file of VtuPieces.
[[nodiscard]] Result<NumberedMesh> read_vtu_piece(const std::filesystem::path& file);
/// What the .pvtu of a mesh in pieces names.
struct PiecesOfMesh {
  std::vector<std::string> files;  ///< relative to the folder of the .pvtu
  bool have_regions = false;       ///< Mesh::region is not empty
  std::size_t attributes_per_point = 0;
};
/// Writes the file with which ParaView opens the pieces together.
[[nodiscard]] Status write_pvtu(const PiecesOfMesh& pieces, const std::filesystem::path& file);
/// Writes points and triangles, and comments at the end that list the constrained edges with their markers.
[[nodiscard]] Status write_off(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on = {});
/// Writes SMS's 2D mesh: triangles as E3T with a material, points as ND with the first attribute, or 0, as z, and the
/// constrained edges of each marker as nodestrings, each with the marker after its end. The material of a triangle is
/// the tag that its region has in write_msh(): 1 if there are no regions. Source: SMS, "2D Mesh Files *.2dm".
[[nodiscard]] Status write_2dm(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on = {});
/// Writes the grid of SCHISM (hgrid.gr3) and of ADCIRC (fort.14). The depth of a point is its first attribute, or 0.
/// For each of `open_markers` the edges of the boundary with this marker are open boundaries, in this order; all others
/// are land, in chains of type 1 if they close around an island (its first node is not repeated), else of type 0. The
/// domain lies to the left of each chain. Error: `usage` if no edge of the boundary has one of the markers. Source:
/// SCHISM's manual, "hgrid.gr3"; ADCIRC's manual, "Grid and boundary information file".
[[nodiscard]] Status write_gr3(const Mesh& mesh, const std::filesystem::path& file,
                               std::span<const int> open_markers = {}, const GoOn& go_on = {});
/// Writes Abaqus' input file: *NODE, *ELEMENT of type CPS3 with one ELSET per region, and per marker an NSET of the
/// nodes and a *SURFACE of the sides at the boundary. The sets are REGION_T, MARKER_T and SIDES_T, where T is the tag
/// that write_msh() gives to the region or the marker; a comment before the set has the attribute or the marker itself.
[[nodiscard]] Status write_inp(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on = {});
/// Draws the mesh. The colour of a triangle depends on its region.
[[nodiscard]] Status write_svg(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on = {});
/// Draws points, segments, holes (crosses) and regions (diamonds with their attributes).
[[nodiscard]] Status write_svg(const Pslg& pslg, const std::filesystem::path& file, const GoOn& go_on = {});

}  // namespace pardel
