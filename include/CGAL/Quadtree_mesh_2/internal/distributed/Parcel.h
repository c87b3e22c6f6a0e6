// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What parts of a computation send each other, and the concept of an exchange.
//
// A computation has P parts, each with a memory of its own. All parts run the same program. They work alone, and meet
// in the functions of an exchange, which all of them call in the same order:
//
//     int rank() const, size() const             // which part this is, and of how many
//     Parcels exchange(Parcels)                  // a parcel for each part that is told something
//     void sum(Numbers&), min(Numbers&), max(Numbers&), exclusive_scan(Numbers&)
//     void broadcast(Bytes&, int root)           // what `root` has, for all
//     Numbers gather(const Numbers&)             // as many numbers of each part, for all: O(P) memory
//     const Exchange_traffic& traffic() const    // what this part has sent
//
// Parcels arrive in the order of their senders. Nothing is sent to a part that is told nothing, and no function but
// `gather()` needs memory for each part. Its numbers are those of parts, so they do not grow with the input.
// `Local_exchange` (one part), `In_memory_exchange` (threads) and `Mpi_exchange` are models.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PARCEL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PARCEL_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Bytes = Uninitialized_vector<char>;
using Numbers = std::vector<std::int64_t>;

/// As one copy: to insert them would construct byte after byte.
inline void append_bytes(Bytes& bytes, const void* begin, std::size_t size) {
  if (size == 0) return;
  const std::size_t before = bytes.size();
  bytes.resize(before + size);
  std::memcpy(bytes.data() + before, begin, size);
}

/// Bytes to a part, or from one.
struct Parcel {
  int part; ///< the receiver of what is sent, the sender of what arrives
  Bytes bytes;
};
using Parcels = std::vector<Parcel>;

/// What one part has sent to others; what it tells itself is free.
struct Exchange_traffic {
  std::size_t messages = 0;    ///< parcels
  std::size_t bytes = 0;       ///< in parcels
  std::size_t exchanges = 0;   ///< calls of `exchange()`
  std::size_t collectives = 0; ///< calls of the other functions, in which all parts take part
};

/// What all exchanges offer beside their own functions.
template <class Exchange>
class Exchange_base {
public:
  std::int64_t sum(std::int64_t value) { return one(value, &Exchange::sum); }
  std::int64_t min(std::int64_t value) { return one(value, &Exchange::min); }
  std::int64_t max(std::int64_t value) { return one(value, &Exchange::max); }
  /// The sum of the values of all parts before this one.
  std::int64_t exclusive_scan(std::int64_t value) { return one(value, &Exchange::exclusive_scan); }
  /// One number of each part.
  Numbers gather(std::int64_t value) { return static_cast<Exchange&>(*this).gather(Numbers{value}); }

  const Exchange_traffic& traffic() const { return traffic_; }

protected:
  /// Counts parcels that go out. \pre there is at most one for each part
  void count(const Parcels& outbox) {
    ++traffic_.exchanges;
    for (const Parcel& parcel : outbox) {
      if (parcel.part == static_cast<const Exchange&>(*this).rank()) continue;
      ++traffic_.messages, traffic_.bytes += parcel.bytes.size();
    }
  }
  void count_collective() { ++traffic_.collectives; }

private:
  std::int64_t one(std::int64_t value, void (Exchange::*function)(Numbers&)) {
    Numbers values{value};
    (static_cast<Exchange&>(*this).*function)(values);
    return values.front();
  }

  Exchange_traffic traffic_;
};

/// Records to a part, or from one.
template <class Record>
using Records_of_parts = std::map<int, std::vector<Record>>;

template <class Record>
Bytes bytes_of(const std::vector<Record>& records) {
  static_assert(std::is_trivially_copyable_v<Record>, "records are sent as the bytes that they are");
  Bytes bytes(records.size() * sizeof(Record));
  if (!bytes.empty()) std::memcpy(bytes.data(), records.data(), bytes.size());
  return bytes;
}

template <class Record>
std::size_t number_of_records(const Bytes& bytes) {
  static_assert(std::is_trivially_copyable_v<Record>, "records are sent as the bytes that they are");
  if (bytes.size() % sizeof(Record) != 0) throw std::logic_error("a parcel with a part of a record");
  return bytes.size() / sizeof(Record);
}

template <class Record>
void append_records(const Bytes& bytes, std::vector<Record>& records) {
  const std::size_t n = records.size();
  records.resize(n + number_of_records<Record>(bytes));
  if (!bytes.empty()) std::memcpy(static_cast<void*>(records.data() + n), bytes.data(), bytes.size());
}

template <class Record>
std::vector<Record> records_of(const Bytes& bytes) {
  std::vector<Record> records;
  append_records(bytes, records);
  return records;
}

/// The records for a part, which are no longer in the outbox then.
template <class Record>
std::vector<Record> take_records_for(int part, Records_of_parts<Record>& outbox) {
  const auto found = outbox.find(part);
  return found == outbox.end() ? std::vector<Record>() : std::move(outbox.extract(found).mapped());
}

/// The records for each part as bytes. They are freed one by one.
template <class Record>
Parcels parcels_of(Records_of_parts<Record> outbox) {
  Parcels parcels;
  for (auto& [part, records] : outbox) {
    if (records.empty()) continue;
    parcels.push_back({part, bytes_of(records)});
    std::vector<Record>().swap(records);
  }
  return parcels;
}

/// Sends records to parts, and returns those that arrive, by sender. Parts with no records get nothing. What a part
/// tells itself is not copied.
template <class Record, class Exchange>
Records_of_parts<Record> exchange_records(Exchange& exchange, Records_of_parts<Record> outbox) {
  Records_of_parts<Record> inbox;
  std::vector<Record> own = take_records_for(exchange.rank(), outbox);
  if (!own.empty()) inbox[exchange.rank()] = std::move(own);
  for (Parcel& parcel : exchange.exchange(parcels_of(std::move(outbox)))) {
    inbox[parcel.part] = records_of<Record>(parcel.bytes);
    Bytes().swap(parcel.bytes);
  }
  return inbox;
}

/// The same, with what arrives of all senders, one after the other.
template <class Record, class Exchange>
std::vector<Record> exchange_and_join(Exchange& exchange, Records_of_parts<Record> outbox) {
  std::vector<Record> own = take_records_for(exchange.rank(), outbox);
  Parcels inbox = exchange.exchange(parcels_of(std::move(outbox)));
  if (inbox.empty()) return own;
  std::size_t length = own.size();
  for (const Parcel& parcel : inbox) length += number_of_records<Record>(parcel.bytes);
  std::vector<Record> all;
  all.reserve(length);
  const auto first_behind =
      std::find_if(inbox.begin(), inbox.end(), [&](const Parcel& p) { return p.part > exchange.rank(); });
  const auto add = [&all](auto begin, auto end) {
    for (auto parcel = begin; parcel != end; ++parcel) {
      append_records(parcel->bytes, all);
      Bytes().swap(parcel->bytes);
    }
  };
  add(inbox.begin(), first_behind);
  all.insert(all.end(), own.begin(), own.end());
  add(first_behind, inbox.end());
  return all;
}

/// The exchange of the only part.
class Local_exchange : public Exchange_base<Local_exchange> {
public:
  using Exchange_base::exclusive_scan;
  using Exchange_base::gather;
  using Exchange_base::max;
  using Exchange_base::min;
  using Exchange_base::sum;

  int rank() const { return 0; }
  int size() const { return 1; }
  Parcels exchange(Parcels outbox) { return count(outbox), outbox; }
  void sum(Numbers&) { count_collective(); }
  void min(Numbers&) { count_collective(); }
  void max(Numbers&) { count_collective(); }
  void exclusive_scan(Numbers& values) { count_collective(), values.assign(values.size(), 0); }
  void broadcast(Bytes&, int) { count_collective(); }
  Numbers gather(const Numbers& values) { return count_collective(), values; }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PARCEL_H
