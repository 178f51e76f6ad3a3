// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_contacts and gcv_contact_list_*.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "contacts.hpp"
#include "error.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "near_contacts.hpp"
#include "options.hpp"
#include "task.hpp"

using gcv::Contact;
using gcv::Error;
using gcv::PlacedPair;
using gcv::PolygonPair;
using gcv::Status;
using gcv::Tally;
using gcv::Task;
using gcv::capi::fill;
using gcv::capi::guarded;
using gcv::capi::is_out_of_range;
using gcv::capi::public_contact;
using gcv::capi::read_options;
using gcv::capi::require;
using gcv::capi::Vectors;

namespace {

// Throws Error: not_finite, invalid_argument.
void require_size(double x, const char* name) {
  if (!std::isfinite(x)) {
    throw Error(Status::not_finite, "%s is %g, not finite", name, x);
  }
  if (x < 0) {
    throw Error(Status::invalid_argument, "%s is %g, it must not be negative", name, x);
  }
}

// Throws Error: range.
std::vector<gcv_contact> public_contacts(const std::vector<Contact>& contacts) {
  std::vector<gcv_contact> result;
  result.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    if (is_out_of_range(contact)) {
      throw Error(Status::range, "a contact: a distance or a point is beyond the largest double");
    }
    result.push_back(public_contact(contact));
  }
  return result;
}

}  // namespace

gcv_status gcv_contacts(const gcv_polygon* a, const gcv_polygon* b, const double t[2],
                        double distance, double slope, const gcv_options* options,
                        gcv_contact_list** out) {
  return guarded([&] {
    require(a, "a");
    require(b, "b");
    require(t, "t");
    require(out, "out");
    const gcv_options given = read_options(options);
    const Vectors translation(t, 1, "t");
    require_size(distance, "distance");
    require_size(slope, "slope");
    const PolygonPair pair(*a->polygon, *b->polygon);
    Task task(1, given.progress, given.progress_context);
    task.begin(std::uint64_t{pair.a.boundary.size()} + pair.b.boundary.size());
    Tally tally;
    const auto contacts =
        near_contacts(PlacedPair(pair, translation[0]), distance, slope, task, tally);
    auto list = std::make_unique<gcv_contact_list>(public_contacts(contacts));
    task.finish();
    *out = list.release();
  });
}

void gcv_contact_list_destroy(gcv_contact_list* list) { delete list; }

gcv_status gcv_contact_list_contacts(const gcv_contact_list* list, gcv_contact* out,
                                     size_t capacity, size_t* required) {
  return guarded([&] {
    require(list, "list");
    fill(list->contacts.size(), "contacts", "out", out, capacity, required,
         [&](gcv_contact* to) { std::copy(list->contacts.begin(), list->contacts.end(), to); });
  });
}

gcv_status gcv_contact_list_previous(const gcv_contact_list* list, uint64_t* out, size_t capacity,
                                     size_t* required) {
  return guarded([&] {
    require(list, "list");
    const std::size_t count = list->contacts.size();
    fill(count, "indices", "out", out, capacity, required, [&](std::uint64_t* to) {
      std::fill_n(to, count, std::numeric_limits<std::uint64_t>::max());
    });
  });
}
