// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Errors on which all parts agree: what one part throws, all throw, and none waits for one that has ended.
//
// Computes: of the errors of all parts the one of the least item; of several with the same item, that of the lowest
//           part. Where slices of an input are in the order of parts, that is the error that one part alone would find
//           first.
// Bound:    two sums over all parts; one more message to each if there is an error.
//
// What is no fault of the input, such as no memory left, may come where parts meet. Then it is thrown at one part
// alone, and whoever runs the parts has to end the others.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ERROR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ERROR_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Distributed_point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// An error as all parts can throw it: its type, what it names, and its text. Types that are not listed become
/// `std::runtime_error`, and those derived from `Pslg_error_2` become that.
struct Portable_error {
  enum class Type : std::int32_t { POINT, PSLG, INVALID_ARGUMENT, LENGTH, MEMORY, LOGIC, RUNTIME };

  struct Head {
    Type type;
    std::int32_t kind;
    std::int64_t point, other;
  };
  Head head;
  std::string text;   ///< the reason, of points
  Pslg_parts_2 parts; ///< of the graph that are at fault

  static Portable_error of(const std::exception_ptr& error) {
    try {
      std::rethrow_exception(error);
    } catch (const Distributed_point_error& e) {
      return {{Type::POINT, static_cast<std::int32_t>(e.kind()), e.point(), e.other()}, e.reason(), {}};
    } catch (const Pslg_error_2& e) {
      return {{Type::PSLG, static_cast<std::int32_t>(e.kind()), 0, 0}, e.what(), e.parts()};
    } catch (const std::invalid_argument& e) {
      return {{Type::INVALID_ARGUMENT, 0, 0, 0}, e.what(), {}};
    } catch (const std::length_error& e) {
      return {{Type::LENGTH, 0, 0, 0}, e.what(), {}};
    } catch (const Scratch_full& e) { // whose text names the folder
      return {{Type::RUNTIME, 0, 0, 0}, e.what(), {}};
    } catch (const std::bad_alloc&) {
      return {{Type::MEMORY, 0, 0, 0}, "", {}};
    } catch (const std::logic_error& e) {
      return {{Type::LOGIC, 0, 0, 0}, e.what(), {}};
    } catch (const std::exception& e) {
      return {{Type::RUNTIME, 0, 0, 0}, e.what(), {}};
    } catch (...) {
      return {{Type::RUNTIME, 0, 0, 0}, "unknown error", {}};
    }
  }

  static Portable_error from_bytes(const Bytes& bytes) {
    Portable_error error{};
    Archive_reader reader(bytes);
    std::vector<char> text;
    reader(error.head), reader(text);
    error.text.assign(text.begin(), text.end());
    for_each_list(error.parts, reader);
    return error;
  }
  Bytes to_bytes() const {
    Archive_writer writer;
    writer(head), writer(std::vector<char>(text.begin(), text.end()));
    for_each_list(parts, writer);
    return std::move(writer.bytes);
  }

  [[noreturn]] void raise() const {
    switch (head.type) {
    case Type::POINT:
      throw Distributed_point_error(static_cast<Point_error::Kind>(head.kind), head.point, head.other, text);
    case Type::PSLG:
      throw Pslg_error_2(static_cast<Pslg_error_2::Kind>(head.kind), text, parts);
    case Type::INVALID_ARGUMENT:
      throw std::invalid_argument(text);
    case Type::LENGTH:
      throw std::length_error(text);
    case Type::MEMORY:
      throw std::bad_alloc();
    case Type::LOGIC:
      throw std::logic_error(text);
    case Type::RUNTIME:
      break;
    }
    throw std::runtime_error(text);
  }

private:
  template <class Parts, class F>
  static void for_each_list(Parts& parts, F&& f) {
    f(parts.vertices), f(parts.segments), f(parts.holes);
    f(parts.regions), f(parts.triangles), f(parts.seeds);
  }
};

/// An error that came where parts meet, so that others may be waiting there: it cannot be agreed on.
struct Lone_error {
  std::exception_ptr error;
};

/// Does what parts do together. If there is no memory for it, that is a lone error: it may come anywhere.
template <class Work>
auto work_together(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Lone_error{std::current_exception()};
  }
}

/// Throws the same error at all parts if there is one at any of them. All parts have to call this.
/// \param error null if there is none here
/// \param item what the error is about, at least 0: that of the least item is thrown
template <class Exchange>
void agree_on_error(Exchange& exchange, const std::exception_ptr& error, std::int64_t item = 0) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  const std::int64_t least = exchange.min(error ? item : none);
  if (least == none) return;
  const bool is_candidate = error && item == least;
  const std::int64_t part = exchange.min(is_candidate ? std::int64_t(exchange.rank()) : none);
  Bytes bytes;
  if (exchange.rank() == part) bytes = Portable_error::of(error).to_bytes();
  exchange.broadcast(bytes, static_cast<int>(part));
  Portable_error::from_bytes(bytes).raise();
}

/// Does what may fail at some parts, in which they do not meet, and agrees on the error of the lowest one. Where they
/// do meet, errors have to be the same for all, or lone ones, which are thrown at once.
template <class Exchange, class Work>
void agree_on_work(Exchange& exchange, const Work& work) {
  std::exception_ptr error;
  try {
    work();
  } catch (const Lone_error&) {
    throw;
  } catch (...) {
    error = std::current_exception();
  }
  agree_on_error(exchange, error);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_AGREE_ON_ERROR_H
