// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// An exchange between the ranks of an MPI communicator, by MPI's C interface.
//
// Bound:    A part with k parcels to send and l to receive sends 2 k messages, takes part in one barrier, and needs
//           memory for k + l parcels. No message is longer than 2^30 bytes: longer parcels go in several.
// Source:   Hoefler, Siebert, Lumsdaine, "Scalable communication protocols for dynamic sparse data exchange",
//           PPoPP 2010: nonblocking consensus. The length of a parcel is sent by a synchronous send, which ends when
//           it has been received. Who has ended all of these enters a barrier that does not block. When the barrier
//           ends, nothing is on its way.
// Deviates: a part may leave the barrier and send lengths of the next exchange while another has not yet seen that
//           the barrier has ended. So two tags take turns. More are not needed: no part ends the next exchange
//           before all have begun it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MPI_EXCHANGE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MPI_EXCHANGE_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// See the head of this file.
class Mpi_exchange : public Exchange_base<Mpi_exchange> {
public:
  using Exchange_base::exclusive_scan;
  using Exchange_base::gather;
  using Exchange_base::max;
  using Exchange_base::min;
  using Exchange_base::sum;

  /// All ranks of `comm` have to call this. Its messages meet no others of `comm`.
  /// \param longest_message in bytes, from 1 to 2^31 - 1
  /// \throws std::runtime_error if MPI tells of an error, here and below
  explicit Mpi_exchange(MPI_Comm comm, std::size_t longest_message = std::size_t(1) << 30)
      : longest_message_(longest_message) {
    check(MPI_Comm_dup(comm, &comm_));
    check(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN));
    check(MPI_Comm_rank(comm_, &rank_));
    check(MPI_Comm_size(comm_, &size_));
  }
  Mpi_exchange(const Mpi_exchange&) = delete;
  Mpi_exchange& operator=(const Mpi_exchange&) = delete;
  /// All ranks have to do this, before `MPI_Finalize()`; after it nothing is left to be freed.
  ~Mpi_exchange() {
    int is_finalized = 0;
    MPI_Finalized(&is_finalized);
    if (is_finalized == 0) MPI_Comm_free(&comm_);
  }

  int rank() const { return rank_; }
  int size() const { return size_; }
  /// The communicator of this exchange alone.
  MPI_Comm communicator() const { return comm_; }

  Parcels exchange(Parcels outbox) {
    count(outbox);
    turn_ = 1 - turn_;
    Transfer transfer;
    for (Parcel& parcel : outbox)
      if (parcel.part == rank_)
        transfer.inbox.push_back({rank_, std::move(parcel.bytes)});
      else
        send(parcel, transfer);
    receive_until_all_have_sent(transfer);
    check(MPI_Waitall(static_cast<int>(transfer.contents.size()), transfer.contents.data(),
                      MPI_STATUSES_IGNORE));
    Parcels inbox(std::make_move_iterator(transfer.inbox.begin()),
                  std::make_move_iterator(transfer.inbox.end()));
    std::sort(inbox.begin(), inbox.end(), [](const Parcel& a, const Parcel& b) { return a.part < b.part; });
    return inbox;
  }

  void sum(Numbers& values) { reduce(values, MPI_SUM); }
  void min(Numbers& values) { reduce(values, MPI_MIN); }
  void max(Numbers& values) { reduce(values, MPI_MAX); }

  void exclusive_scan(Numbers& values) {
    count_collective();
    Numbers result(values.size(), 0); // MPI leaves that of the first rank as it is
    check(MPI_Exscan(values.data(), result.data(), length(values), MPI_INT64_T, MPI_SUM, comm_));
    if (rank_ == 0) result.assign(values.size(), 0);
    values = std::move(result);
  }

  void broadcast(Bytes& bytes, int root) {
    count_collective();
    std::int64_t n = static_cast<std::int64_t>(bytes.size());
    check(MPI_Bcast(&n, 1, MPI_INT64_T, root, comm_));
    bytes.resize(static_cast<std::size_t>(n));
    for_each_message(bytes, [&](char* begin, int n_of_message) {
      check(MPI_Bcast(begin, n_of_message, MPI_BYTE, root, comm_));
    });
  }

  Numbers gather(const Numbers& values) {
    count_collective();
    Numbers all(values.size() * static_cast<std::size_t>(size_));
    check(MPI_Allgather(values.data(), length(values), MPI_INT64_T, all.data(), length(values), MPI_INT64_T,
                        comm_));
    return all;
  }

private:
  /// What is on its way in one exchange. Nothing of it moves in memory.
  struct Transfer {
    std::deque<std::int64_t> lengths;
    std::vector<MPI_Request> sent_lengths;
    std::vector<MPI_Request> contents; // sent and received
    std::deque<Parcel> inbox;
  };

  int tag_of_length() const { return turn_; }
  int tag_of_contents() const { return 2 + turn_; }

  void send(Parcel& parcel, Transfer& transfer) {
    transfer.lengths.push_back(static_cast<std::int64_t>(parcel.bytes.size()));
    transfer.sent_lengths.emplace_back();
    check(MPI_Issend(&transfer.lengths.back(), 1, MPI_INT64_T, parcel.part, tag_of_length(), comm_,
                     &transfer.sent_lengths.back()));
    for_each_message(parcel.bytes, [&](char* begin, int n) {
      transfer.contents.emplace_back();
      check(MPI_Isend(begin, n, MPI_BYTE, parcel.part, tag_of_contents(), comm_, &transfer.contents.back()));
    });
  }

  /// Gets the length of a parcel, if one has arrived, and begins to receive the parcel.
  bool try_to_receive(Transfer& transfer) {
    int has_arrived = 0;
    MPI_Message message;
    MPI_Status status;
    check(MPI_Improbe(MPI_ANY_SOURCE, tag_of_length(), comm_, &has_arrived, &message, &status));
    if (has_arrived == 0) return false;
    std::int64_t n = 0;
    check(MPI_Mrecv(&n, 1, MPI_INT64_T, &message, MPI_STATUS_IGNORE));
    transfer.inbox.push_back({status.MPI_SOURCE, Bytes(static_cast<std::size_t>(n))});
    for_each_message(transfer.inbox.back().bytes, [&](char* begin, int n_of_message) {
      transfer.contents.emplace_back();
      check(MPI_Irecv(begin, n_of_message, MPI_BYTE, status.MPI_SOURCE, tag_of_contents(), comm_,
                      &transfer.contents.back()));
    });
    return true;
  }

  void receive_until_all_have_sent(Transfer& transfer) {
    MPI_Request barrier = MPI_REQUEST_NULL;
    bool is_in_barrier = false;
    for (int is_done = 0; is_done == 0;) {
      if (try_to_receive(transfer)) continue;
      if (is_in_barrier) {
        check(MPI_Test(&barrier, &is_done, MPI_STATUS_IGNORE));
      } else {
        int are_sent = 0;
        check(MPI_Testall(static_cast<int>(transfer.sent_lengths.size()), transfer.sent_lengths.data(),
                          &are_sent, MPI_STATUSES_IGNORE));
        if (are_sent != 0) check(MPI_Ibarrier(comm_, &barrier));
        is_in_barrier = are_sent != 0;
      }
      std::this_thread::yield(); // there may be more ranks than cores
    }
  }

  template <class F>
  void for_each_message(Bytes& bytes, const F& f) const {
    for (std::size_t begin = 0; begin < bytes.size(); begin += longest_message_)
      f(bytes.data() + begin, static_cast<int>(std::min(longest_message_, bytes.size() - begin)));
  }

  void reduce(Numbers& values, MPI_Op operation) {
    count_collective();
    check(MPI_Allreduce(MPI_IN_PLACE, values.data(), length(values), MPI_INT64_T, operation, comm_));
  }

  static int length(const Numbers& values) { return static_cast<int>(values.size()); }

  static void check(int error) {
    if (error == MPI_SUCCESS) return;
    char text[MPI_MAX_ERROR_STRING];
    int n = 0;
    MPI_Error_string(error, text, &n);
    throw std::runtime_error("MPI: " + std::string(text, static_cast<std::size_t>(n)));
  }

  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, size_ = 1;
  std::size_t longest_message_;
  int turn_ = 0;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MPI_EXCHANGE_H
