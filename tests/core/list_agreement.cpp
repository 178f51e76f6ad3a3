// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_contacts against the reference.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "contact_agreement.hpp"

namespace gcv::test {

namespace {

struct DestroyList {
  void operator()(gcv_contact_list* list) const { gcv_contact_list_destroy(list); }
};

std::vector<gcv_contact> contacts_of(const gcv_contact_list* list) {
  std::size_t count = 0;
  invariants::require(gcv_contact_list_contacts(list, nullptr, 0, &count), "their number");
  std::vector<gcv_contact> contacts(count);
  if (count > 0) {
    invariants::require(gcv_contact_list_contacts(list, contacts.data(), count, &count),
                        "the contacts");
  }
  return contacts;
}

}  // namespace

Messages check_contacts(const ContactPair& pair, const Point& translation, double distance,
                        double slope, ContactCounts& counts) {
  const std::vector<reference::Contact> wanted =
      contacts(pair.exact_a, moved(pair.exact_b, invariants::exact(translation)),
               reference::Rational(distance), reference::Rational(slope));
  bool out_of_range = false;
  for (const reference::Contact& c : wanted) {
    out_of_range = out_of_range || is_out_of_range(c);
  }
  gcv_contact_list* handle = nullptr;
  const gcv_status status = gcv_contacts(pair.a.get(), pair.b.get(), translation.data(), distance,
                                         slope, nullptr, &handle);
  const std::unique_ptr<gcv_contact_list, DestroyList> list(handle);
  const std::string place = "distance " + text_of(distance) + ", slope " + text_of(slope) + ", ";
  Messages messages;
  if (out_of_range) {
    ++counts.out_of_range;
    if (status != GCV_ERR_RANGE) {
      report(messages, translation, place + "contacts, not GCV_ERR_RANGE");
    }
    return messages;
  }
  invariants::require(status, "contacts");
  const std::vector<gcv_contact> got = contacts_of(list.get());
  counts.listed += got.size();
  if (got.size() != wanted.size()) {
    report(messages, translation,
           place + std::to_string(got.size()) + " contacts, not " + std::to_string(wanted.size()));
  }
  const auto order = [](const gcv_contact& c) {
    return std::tuple(std::abs(c.gap), c.kind, c.a, c.b);
  };
  for (std::size_t k = 1; k < got.size(); ++k) {
    if (!(order(got[k - 1]) < order(got[k]))) {
      report(messages, translation, place + "out of order: number " + std::to_string(k));
    }
  }
  for (const gcv_contact& contact : got) {
    const auto same = std::find_if(wanted.begin(), wanted.end(), [&](const reference::Contact& c) {
      return c.feature == reference::Feature{contact.kind, contact.a, contact.b};
    });
    const std::string difference =
        contact_difference(contact, same == wanted.end() ? nullptr : &*same);
    if (!difference.empty()) {
      report(messages, translation, place + difference);
      break;
    }
  }
  return messages;
}

}  // namespace gcv::test
