// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Calls of the questions about two polygons.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "region_calls.hpp"

namespace gcv::fuzz {

class QuestionCalls : protected RegionCalls {
 protected:
  using RegionCalls::RegionCalls;

  void relation() {
    ask<std::int8_t>("gcv_relation", {}, [](const Question& q, std::int8_t* out) {
      return gcv_relation(q.a, q.b, q.translations, q.count, q.options, out);
    });
  }

  void distance() {
    ask<gcv_separation>("gcv_distance", {GCV_ERR_RANGE},
                        [](const Question& q, gcv_separation* out) {
                          return gcv_distance(q.a, q.b, q.translations, q.count, q.options, out);
                        });
  }

  void cast() {
    ask<gcv_impact>("gcv_cast", {GCV_ERR_RANGE}, [this](const Question& q, gcv_impact* out) {
      const Vectors motions(*this, q.count, *q.faults);
      return gcv_cast(q.a, q.b, q.translations, motions.get(), q.count, q.options, out);
    });
  }

  void penetration() {
    ask<gcv_escape>(
        "gcv_penetration", {GCV_ERR_RANGE},
        [](const Question& q, gcv_escape* out) {
          return gcv_penetration(q.a, q.b, q.translations, q.count, q.options, out);
        },
        Options::Use::escape);
  }

  void contacts() {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults);
    std::array<double, 2> point{};
    const double* const t = reference(point, faults);
    const double distance = size(faults);
    const double slope = size(faults);
    make("gcv_contacts", lists_, faults, {GCV_ERR_RANGE}, [&](gcv_contact_list** out) {
      return gcv_contacts(a, b, t, distance, slope, options.get(), out);
    });
  }

  void listed_contacts() {
    list_of<gcv_contact>("gcv_contact_list_contacts", lists_, gcv_contact_list_contacts);
  }
  void listed_indices() {
    list_of<std::uint64_t>("gcv_contact_list_previous", lists_, gcv_contact_list_previous);
  }

  void destroy_contacts() {
    lists_[input_.below(lists_.size())].reset();
    gcv_contact_list_destroy(nullptr);
  }

  // A number that must not be negative.
  double size(Faults& faults) {
    const double x = input_.below(8) == 0 ? -number() : number();
    faults.add_if(!std::isfinite(x), GCV_ERR_NOT_FINITE);
    faults.add_if(x < 0, GCV_ERR_INVALID_ARGUMENT);
    return x;
  }

  // A list that belongs to a list of contacts.
  template <class Element, class Function>
  void list_of(const char* name, const Slots<gcv_contact_list>& lists, Function function) {
    Faults faults;
    const gcv_contact_list* const list = pick(lists, faults);
    fill<Element>(name, faults, [&](Element* out, std::size_t capacity, std::size_t* required) {
      return function(list, out, capacity, required);
    });
  }

  // Some vectors, finite or not; or NULL, which is no fault where there are none. Of SIZE_MAX,
  // which is to be refused, there is one number.
  class Vectors {
   public:
    Vectors(QuestionCalls& calls, std::size_t count, Faults& faults)
        : xy_(count == SIZE_MAX ? 1 : 2 * count + 1) {
      for (std::size_t k = 0; k + 1 < xy_.size(); ++k) {
        xy_[k] = calls.number();
        faults.add_if(!std::isfinite(xy_[k]), GCV_ERR_NOT_FINITE);
      }
      is_null_ = calls.input_.below(16) == 0;
      faults.add_if(is_null_ && count > 0, GCV_ERR_NULL_ARGUMENT);
      faults.add_if(count == SIZE_MAX, GCV_ERR_INVALID_ARGUMENT);
    }

    [[nodiscard]] const double* get() const { return is_null_ ? nullptr : xy_.data(); }

   private:
    std::vector<double> xy_;
    bool is_null_;
  };

  // call(out) writes `count` answers to `out`, or nothing. Gives what was written.
  template <class Result, class Call>
  std::vector<Result> answers(const char* name, std::size_t count, Faults& faults, Statuses others,
                              Call call) {
    const bool is_huge = count == SIZE_MAX;  // refused
    Bytes bytes((is_huge ? 0 : count * sizeof(Result)) + sentinels, untouched_byte);
    const bool is_null = input_.below(16) == 0;
    Result* const out = is_null ? nullptr : reinterpret_cast<Result*>(bytes.data());
    faults.add_if(is_null && count > 0, GCV_ERR_NULL_ARGUMENT);
    const gcv_status status = call(out);
    const bool well = judge(name, status, faults, others);
    std::vector<Result> results(well && !is_null ? count : 0);
    check(untouched(bytes, results.size() * sizeof(Result)),
          std::string(name) + " writes where it must not");
    if (!results.empty()) {
      std::memcpy(results.data(), bytes.data(), results.size() * sizeof(Result));
    }
    return results;
  }

 private:
  struct Question {
    const gcv_polygon* a;
    const gcv_polygon* b;
    const double* translations;
    std::size_t count;
    const gcv_options* options;
    Faults* faults;
  };

  // call(question, out) answers for every translation, or writes nothing.
  template <class Result, class Call>
  void ask(const char* name, Statuses others, Call call, Options::Use use = Options::Use::sum) {
    Faults faults;
    const gcv_polygon* const a = pick(polygons_, faults);
    const gcv_polygon* const b = pick(polygons_, faults);
    const Options options(input_, faults, use);
    const std::size_t count = input_.below(5);
    const Vectors translations(*this, count, faults);
    answers<Result>(name, count, faults, others, [&](Result* out) {
      return call(Question{a, b, translations.get(), count, options.get(), &faults}, out);
    });
  }
};

}  // namespace gcv::fuzz
