// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_contacts against the reference.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "contact_agreement.hpp"

namespace gcv::test {

std::string list_difference(const std::vector<gcv_contact>& got,
                            const std::vector<ListedContact>& wanted) {
  if (got.size() != wanted.size()) {
    return std::to_string(got.size()) + " contacts, not " + std::to_string(wanted.size());
  }
  const auto order = [](const gcv_contact& c) {
    return std::tuple(std::abs(c.gap), c.id_a, c.id_b, c.kind, c.a, c.b);
  };
  for (std::size_t k = 1; k < got.size(); ++k) {
    if (!(order(got[k - 1]) < order(got[k]))) {
      return "out of order: number " + std::to_string(k);
    }
  }
  for (const gcv_contact& contact : got) {
    const Ids ids{contact.id_a, contact.id_b};
    const auto same = std::find_if(wanted.begin(), wanted.end(), [&](const ListedContact& c) {
      return c.ids == ids &&
             c.contact.feature == reference::Feature{contact.kind, contact.a, contact.b};
    });
    if (same == wanted.end()) {
      return contact_difference(contact, nullptr);
    }
    const std::string difference = contact_difference(contact, &same->contact, ids);
    if (!difference.empty()) {
      return difference;
    }
  }
  return "";
}

Messages check_contacts(const ContactPair& pair, const Point& translation, double distance,
                        double slope, ContactCounts& counts) {
  std::vector<ListedContact> wanted;
  bool out_of_range = false;
  for (const reference::Contact& c :
       contacts(pair.exact_a, moved(pair.exact_b, invariants::exact(translation)),
                reference::Rational(distance), reference::Rational(slope))) {
    wanted.push_back({{}, c});
    out_of_range = out_of_range || is_out_of_range(c);
  }
  gcv_contact_list* handle = nullptr;
  const gcv_status status = gcv_contacts(pair.a.get(), pair.b.get(), translation.data(), distance,
                                         slope, nullptr, &handle);
  const invariants::ContactListHandle list(handle);
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
  const std::vector<gcv_contact> got = invariants::elements(gcv_contact_list_contacts, list.get());
  counts.listed += got.size();
  const std::string difference = list_difference(got, wanted);
  report(messages, translation, difference.empty() ? "" : place + difference);
  return messages;
}

}  // namespace gcv::test
