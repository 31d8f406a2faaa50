// Writes sections of Gmsh's MSH 4.1 in ASCII or binary.
#pragma once

#include <cstdint>
#include <string_view>
#include <tuple>

#include "../formats.hpp"
#include "records.hpp"

namespace pardel::files {

/// The types of elements: lines of two or three nodes, triangles of three or six.
inline constexpr int msh_line = 1, msh_triangle = 2, msh_line_of_3 = 8, msh_triangle_of_6 = 9;

/// Writes numbers in the encoding of the file. In ASCII they are rows of text; in binary they are consecutive bytes.
class MshRows {
 public:
  MshRows(OutputFile& out, MshEncoding encoding) : out_(out), binary_(encoding == MshEncoding::binary) {}

  void open(std::string_view section) { out_.write((Bytes() << '$' << section << '\n').view()); }
  void close(std::string_view section) {
    out_.write((Bytes() << (binary_ ? "\n" : "") << "$End" << section << '\n').view());
  }
  void text(const Bytes& bytes) { out_.write(bytes.view()); }

  /// The first section.
  void format() {
    open("MeshFormat");
    out_.write(binary_ ? "4.1 1 8\n" : "4.1 0 8\n");
    if (binary_) row(1);
    close("MeshFormat");
  }

  /// The format distinguishes int, std::size_t and double. Each argument must have the type that the format prescribes.
  template <class... Numbers>
  void row(Numbers... numbers) {
    Bytes to;
    put(to, numbers...);
    out_.write(to.view());
  }
  /// Writes n rows: numbers(i) returns an array of the numbers of row i.
  template <class NumbersOf>
  void rows(std::size_t n, const NumbersOf& numbers) {
    if (binary_) return write_values(out_, n, numbers);
    write_records(out_, n,
                  [&](Bytes& to, std::size_t i) { std::apply([&](auto... each) { put(to, each...); }, numbers(i)); });
  }
  /// Writes n rows of an int and `width` doubles: row_of(i) returns the int and a pointer to the doubles.
  template <class RowOf>
  void rows_of_values(std::size_t n, std::size_t width, const RowOf& row_of) {
    write_records(out_, n, [&](Bytes& to, std::size_t i) {
      const auto [first, values] = row_of(i);
      if (binary_) {
        to.raw(first);
        for (std::size_t k = 0; k < width; ++k) to.raw(values[k]);
      } else {
        to << first;
        for (std::size_t k = 0; k < width; ++k) to << ' ' << values[k];
        to << '\n';
      }
    });
  }
  /// A row whose length is not known in advance.
  class Row {
   public:
    template <class Number>
    Row& operator<<(Number number) {
      if (binary_) {
        to_.raw(number);
      } else {
        to_ << number << ' ';
      }
      return *this;
    }

   private:
    friend class MshRows;
    explicit Row(bool binary) : binary_(binary) {}
    Bytes to_;
    bool binary_;
  };
  [[nodiscard]] Row long_row() const { return Row(binary_); }
  void write(Row& row) {
    if (!binary_) row.to_ << '\n';
    out_.write(row.to_.view());
  }

 private:
  template <class... Numbers>
  void put(Bytes& to, Numbers... numbers) const {
    if (binary_) {
      (to.raw(numbers), ...);
    } else {
      to.numbers(numbers...) << '\n';
    }
  }

  OutputFile& out_;
  bool binary_;
};

}  // namespace pardel::files
