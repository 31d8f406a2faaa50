// Writers write the bytes, and readers give the results and the errors for files with all kinds of mistakes, that were
// recorded as fingerprints. After a change that is meant to change one of them, take over the value that the test
// shows.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>

#include "../../../core/formats.hpp"
#include "../../../core/formats/mesh_readers.hpp"
#include "../../../core/formats/raster_readers.hpp"
#include "../../../core/formats/text_reader.hpp"
#include "../../../core/support/picture.hpp"
#include "../../fingerprint.hpp"
#include "../../temporary_folder.hpp"
#include "../sample_mesh.hpp"

namespace pardel {

static void add_to(testing::Fingerprint& to, const Raster& r) {
  to.add_all(r.columns, r.rows, r.first, r.step_x, r.step_y, r.values);
}

namespace {

using testing::Fingerprint;

/// A mesh without regions, markers and attributes.
Mesh plain_mesh() {
  Mesh mesh = sample_mesh();
  mesh.region = {};
  mesh.region_attributes.clear();
  mesh.constrained_edges.clear();
  mesh.point_markers = {};
  mesh.attributes_per_point = 0;
  mesh.point_attributes = {};
  return mesh;
}

/// A mesh with two attributes per point, a triangle without a region, and regions that are no integers.
Mesh rich_mesh() {
  Mesh mesh = sample_mesh();
  mesh.region[2] = no_index;
  mesh.region_attributes = {-1, 1e-3};
  mesh.attributes_per_point = 2;
  mesh.point_attributes = Array<double>(std::size_t{12}, 0.25);
  for (std::size_t i = 0; i < 12; ++i) mesh.point_attributes[i] = double(i) / 3;
  return mesh;
}

Pslg sample_pslg() {
  Pslg pslg;
  pslg.points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 1}, {1, 2}};
  pslg.segments = {{0, 1, 2}, {1, 2, 3}, {2, 3, 0}, {3, 0, -1}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
  pslg.has_segment_markers = true;
  pslg.point_markers = {1, 2, 3, 4, 5, 6, 7};
  pslg.attributes_per_point = 1;
  pslg.point_attributes = {0.5, 1, 1.5, 2, 2.5, 3, 3.5};
  pslg.holes = {{1.25, 1.25}};
  pslg.regions = {{{3, 3}, 8, 0.5}, {{0.5, 0.5}, 9}};
  return pslg;
}

/// The results for all these texts.
template <class Parse>
std::string results(const std::vector<std::string>& texts, const Parse& parse) {
  Fingerprint all;
  std::size_t read = 0;
  for (const std::string& text : texts) {
    const auto result = parse(text);
    if (result) {
      all.add(*result);
      ++read;
    } else {
      all.add_all(result.error().kind, result.error().message);
    }
  }
  return std::to_string(read) + " of " + std::to_string(texts.size()) + " " + all.text();
}

/// The text, cut off at each byte.
std::vector<std::string> cut_off(const std::string& text) {
  std::vector<std::string> all;
  for (std::size_t n = 0; n <= text.size(); ++n) all.push_back(text.substr(0, n));
  return all;
}

/// The text with each line left out or twice, and with each of its words replaced or left out.
std::vector<std::string> with_mistakes(const std::string& text) {
  std::vector<std::string> all{text};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string line = text.substr(begin, end - begin);
    all.push_back(std::string(text).erase(begin, line.size()));
    all.push_back(std::string(text).insert(begin, line));
    all.push_back(std::string(text).insert(end - 1, " 1 # comment"));
    begin = end;
  }
  const auto in_word = [&](std::size_t i) {
    return i < text.size() && std::isspace(static_cast<unsigned char>(text[i])) == 0 && text[i] != '"';
  };
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!in_word(begin) || (begin > 0 && in_word(begin - 1))) continue;
    std::size_t end = begin;
    while (in_word(end)) ++end;
    for (const char* other : {"", "x", "-1", "0", "1", "2", "3", "4", "5", "0.5", "1e999", "nan", "+3", "++3", "1 1",
                              "2147483648", "-2147483649", "99999999999999999999"})
      all.push_back(std::string(text).replace(begin, end - begin, other));
  }
  return all;
}

/// The bytes with each one changed.
std::vector<std::string> with_changed_bytes(const std::string& bytes) {
  std::vector<std::string> all{bytes};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const int change : {0x01, 0x02, 0x80}) {
      all.push_back(bytes);
      all.back()[i] = static_cast<char>(all.back()[i] ^ change);
    }
  return all;
}

/// What a writer writes.
template <class Write>
std::string written(const char* name, const Write& write) {
  const TemporaryFolder folder;
  EXPECT_TRUE(write(folder / name).ok());
  return folder.read(name);
}
std::string written(const Mesh& mesh, const char* name, MshEncoding encoding = MshEncoding::ascii) {
  return written(name, [&](const auto& file) { return write_mesh(mesh, sample_pslg(), file, encoding); });
}

Result<Mesh> msh(const std::string& text) { return files::parse_msh(text, "m"); }
Result<Mesh> vtu(const std::string& text) { return files::parse_vtu(text, "m"); }
Result<Mesh> off(const std::string& text) { return files::parse_off(text, "m"); }
Result<Pslg> poly(const std::string& text) { return parse_poly(text, "m"); }
Result<Raster> asc(const std::string& text) { return files::parse_asc(text, "m"); }

const char* const msh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 4 \"marker -4\"\n2 9 \"region 2.5\"\n2 8 \"land\"\n"
    "$EndPhysicalNames\n$Nodes\n5\n1 0 0 0\n2 2 0 0\n3 2 2 0\n5 0 2 0\n9 1 1 0\n$EndNodes\n$Elements\n7\n1 15 2 1 1 1\n"
    "2 1 2 4 1 1 2\n3 1 2 0 1 2 3\n4 2 2 9 1 1 2 9\n5 2 3 8 1 7 2 3 9\n6 2 2 9 2 3 5 9\n7 2 0 5 1 9\n$EndElements\n"
    "$NodeData\n1\n\"h\"\n1\n0.0\n3\n0\n1\n5\n1 0.5\n2 1\n3 1.5\n5 2\n9 2.5\n$EndNodeData\n";
const char* const asc_grid =
    "NCOLS 3\nnrows 2\nXLLCORNER 10\nYLLCENTER 5\nDX 2\nDY 1\nNODATA_value -1\n1 2 -1\n4 5.5 6e2\n";

TEST(RecordedFiles, are_written_with_the_same_bytes) {
  Fingerprint all;
  for (const Mesh& mesh : {sample_mesh(), plain_mesh(), rich_mesh()}) {
    for (const char* name : {"m.msh", "m.vtu", "m.off", "m.svg", "m.node"}) all.add(written(mesh, name));
    all.add(written(mesh, "m.msh", MshEncoding::binary));
    for (unsigned switches = 0; switches < 256; ++switches) {
      const auto on = [&](unsigned i) { return (switches >> i & 1U) != 0; };
      const TriangleFiles files{.base = on(0) ? 1 : 0,
                                .write_node = on(1),
                                .write_ele = on(2),
                                .write_poly = on(3),
                                .write_edge = on(4),
                                .write_neigh = on(5),
                                .markers = on(6),
                                .second_order = on(7),
                                .command = on(1) == on(4) ? "pardel" : ""};
      const TemporaryFolder folder;
      EXPECT_TRUE(write_triangle_files(mesh, sample_pslg(), folder / "m", files).ok());
      for (const char* suffix : {"m.node", "m.ele", "m.poly", "m.edge", "m.neigh"}) all.add(folder.read(suffix));
    }
  }
  EXPECT_EQ(all.text(), "68503a4e4565d608");
  Fingerprint domains;
  for (const int base : {0, 1})
    domains.add(written("m.poly", [&](const auto& file) { return write_poly(sample_pslg(), file, base); }));
  domains.add(written("m.svg", [](const auto& file) { return write_svg(sample_pslg(), file); }));
  domains.add(written("m.area", [](const auto& file) {
    return write_area(file, std::vector<double>{0.5, INFINITY, 2});
  }));
  EXPECT_EQ(domains.text(), "42583f2adcd2165f");
}

TEST(RecordedFiles, that_are_cut_off_cause_the_same_results) {
  EXPECT_EQ(results(cut_off(written(rich_mesh(), "m.msh")), msh), "2 of 605 314c36ae99c5e9a2");
  EXPECT_EQ(results(cut_off(written(sample_mesh(), "m.msh", MshEncoding::binary)), msh), "2 of 1403 5aeaca2bcbebb2e0");
  EXPECT_EQ(results(cut_off(msh2), msh), "4 of 371 c3157133781e40ff");
  EXPECT_EQ(results(cut_off(written(rich_mesh(), "m.vtu")), vtu), "29 of 1866 c44d4ceb8430d870");
  EXPECT_EQ(results(cut_off(written(sample_mesh(), "m.off")), off), "24 of 143 c37211cff5cdafcd");
  EXPECT_EQ(results(cut_off(written("m.poly", [](const auto& f) { return write_poly(sample_pslg(), f); })), poly),
            "9 of 191 4cd83892726386c3");
  EXPECT_EQ(results(cut_off(asc_grid), asc), "3 of 85 cb24c6bfa7545944");
}

TEST(RecordedFiles, of_text_with_mistakes_cause_the_same_results) {
  EXPECT_EQ(results(with_mistakes(written(rich_mesh(), "m.msh")), msh), "1798 of 4180 2f498d1db585c739");
  EXPECT_EQ(results(with_mistakes(msh2), msh), "846 of 2215 e031bd40c7133af0");
  EXPECT_EQ(results(with_mistakes(written(rich_mesh(), "m.off")), off), "621 of 1171 216b890019b6ca90");
  EXPECT_EQ(
      results(with_mistakes(written("m.poly", [](const auto& f) { return write_poly(sample_pslg(), f, 0); })), poly),
      "793 of 1576 cf9048d312b07ea1");
  EXPECT_EQ(results(with_mistakes(asc_grid), asc), "151 of 388 19fb51da3809fe7e");
}

TEST(RecordedFiles, of_bytes_with_mistakes_cause_the_same_results) {
  EXPECT_EQ(results(with_changed_bytes(written(sample_mesh(), "m.msh", MshEncoding::binary)), msh),
            "2153 of 4207 de0fbe1991f2b990");
  EXPECT_EQ(results(with_changed_bytes(written(sample_mesh(), "m.vtu")), vtu), "3094 of 5452 f93b9f2c8b9b87d3");
  EXPECT_EQ(results(with_changed_bytes(msh2), msh), "222 of 1111 665b5851764f22c8");
  EXPECT_EQ(results(with_changed_bytes(asc_grid), asc), "65 of 253 7fa09233b553e1bf");
}

std::string data(const char* name) {
  const auto text = files::read_file(std::filesystem::path(PARDEL_FORMATS_DATA) / name);
  EXPECT_TRUE(text.ok());
  return text.ok() ? std::string(std::string_view(*text)) : std::string();
}

TEST(RecordedFiles, of_other_programs_with_mistakes_cause_the_same_results) {
  EXPECT_EQ(results(with_changed_bytes(data("zlib_by_meshio.vtu")), vtu), "1211 of 3808 64cf109967ec23ce");
  EXPECT_EQ(results(cut_off(data("zlib_by_meshio.vtu")), vtu), "136 of 1270 66157da85b1b3ecc");
  EXPECT_EQ(results(cut_off(data("zlib_appended_raw.vtu")), vtu), "29 of 1394 7cb71a6a18f54907");
  EXPECT_EQ(results(with_changed_bytes(data("zlib_appended_raw.vtu")), vtu), "1184 of 4180 d3e700e9cac903f6");
  EXPECT_EQ(results(cut_off(data("zlib_appended_base64.vtu")), vtu), "29 of 1576 19a1f1825b923dd8");
  EXPECT_EQ(results(cut_off(data("msh22_by_meshio.msh")), msh), "2 of 439 5d81332c590365e8");
  EXPECT_EQ(results(with_changed_bytes(data("msh22_by_meshio.msh")), msh), "636 of 1315 cdac1413dabab012");
}

TEST(RecordedFiles, of_triangle_with_mistakes_cause_the_same_results) {
  const TemporaryFolder good, bad;
  const TriangleFiles files{.write_edge = true, .write_neigh = true};
  ASSERT_TRUE(write_triangle_files(rich_mesh(), sample_pslg(), good / "m", files).ok());
  const std::vector<const char*> names{"m.node", "m.ele", "m.poly", "m.edge", "m.neigh"};
  Fingerprint all;
  for (const char* broken : names)
    for (const char* left_out : {"", "m.poly", "m.neigh"}) {
      if (std::string(left_out) == broken) continue;
      for (const char* name : names) {
        std::filesystem::remove(bad / name);
        if (std::string(left_out) != name) bad.write(name, good.read(name));
      }
      std::vector<std::string> texts = with_mistakes(good.read(broken));
      for (std::size_t i = 0; i < texts.size(); i += *left_out == 0 ? 1 : 5) {
        bad.write(broken, texts[i]);
        const Result<Mesh> mesh = read_mesh(bad / "m.ele");
        if (mesh)
          all.add(*mesh);
        else
          all.add(message_of(mesh, bad));
      }
    }
  EXPECT_EQ(all.text(), "1d26aa0a8ffee3ed");
}

}  // namespace
}  // namespace pardel
