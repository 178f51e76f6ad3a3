// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The system gives fewer threads than the options ask for, or none. The answers are the same.
#include "refused_threads.hpp"

#include "questions.hpp"

namespace {

using gcv::faults::check;

void ask_with_few_threads(const gcv::faults::Question& question, const gcv::faults::Pair& pair) {
  constexpr std::size_t many = 1000;  // enough for four threads
  const gcv::faults::Places places = gcv::faults::places_of(pair, many);
  const std::string expected = gcv::faults::answers(question, pair, places, nullptr);
  gcv_options options = GCV_OPTIONS_INIT;
  options.threads = 4;
  for (const long given : {0, 1, 2, 3}) {
    gcv::faults::threads_left = given;
    gcv::faults::threads_refused = 0;
    check(gcv::faults::answers(question, pair, places, &options) == expected, question.name,
          " answers otherwise on fewer threads");
    check(gcv::faults::threads_left == 0, question.name, " does not take the threads that it gets");
    check(gcv::faults::threads_refused == (given < 3 ? 1 : 0), question.name,
          " was refused no thread, or asked again");
  }
}

}  // namespace

int main() {
  for (const gcv::faults::Pair& pair : gcv::faults::pairs()) {
    for (const gcv::faults::Question& question : gcv::faults::questions) {
      ask_with_few_threads(question, pair);
    }
  }
}
